// What stands around a room for what opens in it; doors are closed.
#pragma once

#include "validate/room.hpp"

namespace validate {

// A box in a room's frame, m.
struct ShellBox {
  f64 x0, y0, z0, x1, y1, z1;
};

// An opening on a room's walls, whichever room lists it: from where to where on its edge, and how high, m. Of the boxes that are fitted to
// openings so many are its own, which follow those of the one before it.
struct HoleRow {
  Edge edge;
  f64 low, high;
  i64 fitted;
};

// A box that is fitted to an opening: along the wall from where that begins, up from the floor, across from the wall's middle line, m.
struct FittedBox {
  f64 start, end, low, high, near, far;
};

// The walls without their holes, and what is fitted to these.
Span<ShellBox> shell_of(const Room& room, Span<HoleRow> holes, Span<FittedBox> fitted);

}  // namespace validate
