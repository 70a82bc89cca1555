// Right-angled turns: vectors and sides of a body in the room's frame (0 faces south, 90 east).
#pragma once

#include "placement/room.hpp"

namespace placement {

// The x of a vector turned counter-clockwise seen from above.
inline i64 turned_x(i64 x, i64 z, i64 turn) {
  if (turn == 0) return x;
  if (turn == 90) return z;
  return turn == 180 ? -x : -z;
}

// The z of a vector turned counter-clockwise seen from above.
inline i64 turned_z(i64 x, i64 z, i64 turn) {
  if (turn == 0) return z;
  if (turn == 90) return -x;
  return turn == 180 ? -z : x;
}

// The wall that a side of a body with that rotation looks at.
inline Wall facing(i64 side, i64 rotation) {
  const i64 x = side == RIGHT ? 1 : side == LEFT ? -1 : 0;
  const i64 z = side == FRONT ? 1 : side == BACK ? -1 : 0;
  const i64 dx = turned_x(x, z, rotation), dz = turned_z(x, z, rotation);
  if (dx == 0) return dz > 0 ? SOUTH : NORTH;
  return dx > 0 ? EAST : WEST;
}

}  // namespace placement
