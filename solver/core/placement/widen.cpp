#include "placement/widen.hpp"

#include "placement/grid.hpp"

namespace placement {

// A rectangle of floor, doubled millimetres.
struct Patch {
  i64 low[2], high[2];
};

// Tells whether a rectangle of blocked floor touches the component entered and another one.
static bool divides(const WalkGrid& grid, const Patch& patch) {
  i64 first[2], last[2];
  for (i64 axis = 0; axis < 2; axis++) {
    first[axis] = most<i64>(first_cell(grid, axis, patch.low[axis]) - 1, 0);
    last[axis] = least(first_cell(grid, axis, patch.high[axis]) + 1, grid.state->cuts[axis] - 1);
  }
  const i64 nz = grid.state->cuts[1] - 1, entered = grid.state->entered;
  bool inside = false, outside = false;
  for (i64 i = first[0]; i < last[0]; i++) {
    for (i64 j = first[1]; j < last[1]; j++) {
      const i64 label = grid.labels[i * nz + j];
      if (label == entered) {
        inside = true;
      } else if (label > 0) {
        outside = true;
      }
      if (inside && outside) return true;
    }
  }
  return false;
}

// Adds a wider row where the bounds leave room for it.
static void add_wide(const Work& work, const DifferenceRow& row) {
  if (row.i == row.j || work.counts->wide >= work.wide.size) return;
  i64 highest = row.j != ORIGIN ? work.high.at(row.axis, row.j) : 0;
  if (row.i != ORIGIN) highest -= work.low.at(row.axis, row.i);
  if (highest >= row.s) work.wide[work.counts->wide++] = row;
}

static void between_parts(const Work& work, const WalkGrid& grid, const Part& a, const Part& b) {
  const i64 width = grid.state->width;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 u = a.variable[axis], v = b.variable[axis];
    const i64 shift = a.offset[axis] - b.offset[axis];
    add_wide(work, {axis, u, v, a.extent[axis] + shift + width});
    add_wide(work, {axis, v, u, b.extent[axis] - shift + width});
  }
}

static void from_zone(const Work& work, const WalkGrid& grid, const Part& part, const Zone& zone) {
  const i64 width = grid.state->width;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 v = part.variable[axis], offset = part.offset[axis];
    add_wide(work, {axis, v, ORIGIN, part.extent[axis] + offset - zone.low[axis] + width});
    add_wide(work, {axis, ORIGIN, v, zone.high[axis] - offset + width});
  }
}

// Adds the rows that make room between a block and the walls it is too near to.
static void from_walls(const Room& room, const Work& work, const WalkGrid& grid, const NumberedRect& block) {
  const SpaceRow& space = *room.space.data;
  const Part& part = work.parts[block.number];
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 other = 1 - axis;
    const i64 low = grid.cuts.at(axis, 0), high = grid.cuts.at(axis, grid.state->cuts[axis] - 1);
    const i64 v = part.variable[axis], offset = part.offset[axis];
    Patch strip;
    strip.low[other] = block.low[other];
    strip.high[other] = block.high[other];
    strip.low[axis] = strip.high[axis] = low;
    if (block.low[axis] < low && divides(grid, strip)) add_wide(work, {axis, ORIGIN, v, space.low[axis] + grid.state->width - offset});
    strip.low[axis] = strip.high[axis] = high;
    if (block.high[axis] > high && divides(grid, strip)) {
      add_wide(work, {axis, v, ORIGIN, part.extent[axis] + offset + grid.state->width - space.high[axis]});
    }
  }
}

// Adds the rows that make room between two blocks, where what they both cover closes the way.
static void between_blocks(const Room& room, const Work& work, const WalkGrid& grid, const NumberedRect& a, const NumberedRect& b) {
  Patch both;
  for (i64 axis = 0; axis < 2; axis++) {
    both.low[axis] = most(a.low[axis], b.low[axis]);
    both.high[axis] = least(a.high[axis], b.high[axis]);
    if (both.low[axis] >= both.high[axis]) return;
  }
  if (!divides(grid, both)) return;
  if (a.number >= 0 && b.number >= 0) {
    between_parts(work, grid, work.parts[a.number], work.parts[b.number]);
  } else if (a.number >= 0) {
    from_zone(work, grid, work.parts[a.number], room.zones[-1 - b.number]);
  } else if (b.number >= 0) {
    from_zone(work, grid, work.parts[b.number], room.zones[-1 - a.number]);
  }
}

i64 add_wider_rows(const Room& room, const Work& work, const WalkGrid& grid) {
  const i64 first = work.counts->wide;
  if (grid.state->entered == 0) return first;
  for (i64 k = 0; k < grid.state->blocks; k++) {
    if (grid.blocks[k].number >= 0) from_walls(room, work, grid, grid.blocks[k]);
    for (i64 other = 0; other < k; other++) between_blocks(room, work, grid, grid.blocks[other], grid.blocks[k]);
  }
  return first;
}

}  // namespace placement
