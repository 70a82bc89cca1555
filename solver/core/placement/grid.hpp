// Can a square person get from the doors to every use side? Exact, on the compressed grid; and what blocks the way.
//
// Bodies are inflated by half the person and the walls moved in by as much; cuts at the inflated edges make cells that are wholly
// free or wholly blocked. Lengths are doubled millimetres, so that halves stay integers, and the person is 1 mm smaller than asked,
// so that a gap of exactly its size counts. Targets then never lie on a cut.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// The runs of a row of cells.
inline Span<Run> runs_of(const WalkGrid& grid, i32 row) {
  const i32 first = grid.first_run[row];
  return {grid.runs.data + first, grid.first_run[row + 1] - first};
}

// Calls `meet(component)` for every run that has one of some cells, row by row, until it says true; tells whether it did.
template <class Meet> bool any_met(const WalkGrid& grid, const Cells& cells, Meet meet) {
  for (i32 row = cells.first[0]; row < cells.last[0]; row++) {
    for (const Run& run : runs_of(grid, row)) {
      if (run.first >= cells.last[1]) break;
      if (cells.first[1] < run.last && meet(run.component)) return true;
    }
  }
  return false;
}

// The cells that a target meets, not only touches: blocks are half a millimetre smaller than they block, so that a way just as wide as who
// walks has cells, and ends of what can be walked lie between the cuts.
Cells cells_of(const WalkGrid& grid, const NumberedRect& target);

// Tells whether all doors and use sides are joined, and the doors by ways as wide as asked, with the bodies at integer positions, mm.
// Leaves runs, cuts and the entered component in `grid`.
bool walkable(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& positions);

// Finds what bodies cover wherever they stand between low and high, mm; returns how many rectangles, numbered by their parts.
i64 find_covered(const Work& work, const Table<i64>& low, const Table<i64>& high, const Rows<NumberedRect>& found);

// Tells whether ways so wide join the doors, with the bodies at integer positions, mm; no wider than who walks they do.
bool joins_doors(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& positions, i64 ways);

// Tells whether the bodies may leave one component of the least free centres that meets all doors and use sides.
//
// "No" is certain for all positions between low and high: only what is covered at every one of them blocks the way, and whatever
// may be a place to come to counts as one.
bool may_be_walkable(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high);

}  // namespace placement
