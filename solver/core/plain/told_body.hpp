// A body of a room as it was put there, and as the host tells of it: BODY of solver/body_rows.py.
#pragma once

#include "rects.hpp"

// Furniture or a small thing, mm. `on` and `under` count the furniture, then the things; -1 is nobody. `number` counts the room's bodies of
// one name.
struct ToldBody {
  i32 kind, on, under, wall, rotation, colour, number, unused;
  Rect rect;
  i64 low, width, depth, height;

  bool hangs() const { return wall >= 0 && wall < static_cast<i32>(Wall::none); }
};
