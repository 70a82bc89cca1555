// What stands around a room for what opens in it; doors are closed.
#pragma once

#include "validate/room.hpp"

namespace validate {

// A box in a room's frame, m.
struct ShellBox {
  f64 x0, y0, z0, x1, y1, z1;
};

// The walls without their openings, and what is fitted to these; nothing where that is too much.
Span<ShellBox> shell_of(const Room& room, Looks& looks);

}  // namespace validate
