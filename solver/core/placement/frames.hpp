// Sides of a body in the room's frame (0 faces south, 90 east).
#pragma once

#include "placement/room.hpp"

namespace placement {

// The wall that a side of a body with that rotation looks at.
inline Wall facing(i64 side, i64 rotation) {
  const i64 x = side == RIGHT ? 1 : side == LEFT ? -1 : 0;
  const i64 z = side == FRONT ? 1 : side == BACK ? -1 : 0;
  const Point way = rotated({x, z}, static_cast<i32>(rotation));
  if (way.x == 0) return way.z > 0 ? SOUTH : NORTH;
  return way.x > 0 ? EAST : WEST;
}

}  // namespace placement
