// Free floor of any size: floors less obstacles, cut at every edge that matters, in components one can walk about in.
//
// A grid's cells grow with the square of its boxes, so the floor is cut into tiles of few each: a house is one tile, a town or a heap of
// thousands of boxes many. Components are numbered across the tiles' borders, from 1.
#pragma once

#include "plain/lists.hpp"
#include "plain/rects.hpp"

namespace validate {

// An area in square steps: a town's are more than 64 bits hold.
struct Area {
  u64 high = 0;
  u64 low = 0;

  void add(const Area& other) {
    low += other.low;
    high += other.high + (low < other.low);
  }
  // Adds the product of two lengths, none below 0.
  void add_product(i64 a, i64 b) {
    constexpr u64 HALF = 0xFFFFFFFFULL;
    const u64 x = static_cast<u64>(a), y = static_cast<u64>(b);
    const u64 ll = (x & HALF) * (y & HALF), lh = (x & HALF) * (y >> 32), hl = (x >> 32) * (y & HALF), hh = (x >> 32) * (y >> 32);
    const u64 middle = (ll >> 32) + (lh & HALF) + (hl & HALF);
    add({hh + (lh >> 32) + (hl >> 32) + (middle >> 32), middle << 32 | (ll & HALF)});
  }
};

// The cells between all edges of some floors and obstacles; `cells` holds 0 where something stands, else what was put there.
struct Grid {
  Span<i64> xs;
  Span<i64> zs;
  Table<i32> cells;  // by place along x, then along z

  i64 width(i32 i) const { return xs[i + 1] - xs[i]; }
  i64 depth(i32 k) const { return zs[k + 1] - zs[k]; }
};

// The cells [x0, x1) by [z0, z1) of a grid.
struct CellWindow {
  i32 x0, x1, z0, z1;
};

// Free cells are 1.
Grid grid_of(Span<Rect> floors, Span<Rect> obstacles);

// The cells that a box meets.
CellWindow window_of(const Grid& grid, const Rect& box);

// Tiles without what one obstacle covers; free cells are 1.
List<Grid> tiles_of(Span<Rect> floors, Span<Rect> obstacles, i32 most_boxes);

// Numbers the components of free cells that share sides, in the order of their first cells; returns how many there are.
i32 label(List<Grid>& tiles);

// Merges the cells that are chosen, `chosen(i, k)`: runs along z, then runs that are alike from place to place along x.
template <class Chosen> void rectangles(const Grid& grid, Chosen chosen, List<Rect>& found) {
  struct Run {
    i32 start, end, since;
  };
  List<Run> open, runs;
  for (i32 i = 0; i <= grid.cells.rows; i++) {
    runs.cut(0);
    for (i32 k = 0; i < grid.cells.rows && k < grid.cells.columns; k++) {
      if (!chosen(i, k)) continue;
      if (runs.size() > 0 && runs[runs.size() - 1].end == k) runs[runs.size() - 1].end = k + 1;
      else runs.add({k, k + 1, i});
    }
    i32 next = 0;  // both lists are sorted and apart
    for (const Run& one : open) {
      while (next < runs.size() && runs[next].start < one.start) next++;
      const bool goes_on = next < runs.size() && runs[next].start == one.start && runs[next].end == one.end;
      if (goes_on) runs[next].since = one.since;
      else found.add({grid.xs[one.since], grid.zs[one.start], grid.xs[i], grid.zs[one.end]});
    }
    swap(open, runs);
  }
}

// What of some floors is free of obstacles, in rectangles that do not overlap.
void find_free(Span<Rect> floors, Span<Rect> obstacles, i32 most_boxes, List<Rect>& found);

}  // namespace validate
