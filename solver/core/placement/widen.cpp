#include "placement/widen.hpp"

#include "placement/grid.hpp"

namespace placement {

// Tells whether cells of blocked floor touch the component entered and another one.
static bool divides(const WalkGrid& grid, Cells cells) {
  for (i64 axis = 0; axis < 2; axis++) {
    cells.first[axis] = most(cells.first[axis] - 1, 0);
    cells.last[axis] = least(cells.last[axis] + 1, static_cast<i32>(grid.state->cuts[axis]) - 1);
  }
  bool inside = false, outside = false;
  return any_met(grid, cells, [&](i32 component) {
    (component == grid.state->entered ? inside : outside) = true;
    return inside && outside;
  });
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
static void from_walls(const Room& room, const Work& work, const WalkGrid& grid, i64 number) {
  const SpaceRow& space = *room.space.data;
  const NumberedRect& block = grid.blocks[number];
  const Part& part = work.parts[block.number];
  for (i64 axis = 0; axis < 2; axis++) {
    const i32 cuts = static_cast<i32>(grid.state->cuts[axis]);
    const i64 low = grid.cuts.at(axis, 0), high = grid.cuts.at(axis, cuts - 1);
    const i64 v = part.variable[axis], offset = part.offset[axis];
    Cells strip = grid.block_cells[number];
    strip.first[axis] = strip.last[axis] = 0;
    if (block.low[axis] < low && divides(grid, strip)) add_wide(work, {axis, ORIGIN, v, space.low[axis] + grid.state->width - offset});
    strip.first[axis] = strip.last[axis] = cuts - 1;
    if (block.high[axis] > high && divides(grid, strip)) {
      add_wide(work, {axis, v, ORIGIN, part.extent[axis] + offset + grid.state->width - space.high[axis]});
    }
  }
}

// Adds the rows that make room between two blocks, where what they both cover closes the way.
static void between_blocks(const Room& room, const Work& work, const WalkGrid& grid, i64 one, i64 two) {
  const NumberedRect &a = grid.blocks[one], &b = grid.blocks[two];
  const Cells &of_a = grid.block_cells[one], &of_b = grid.block_cells[two];
  Cells both;
  for (i64 axis = 0; axis < 2; axis++) {
    if (a.low[axis] >= b.high[axis] || b.low[axis] >= a.high[axis]) return;
    both.first[axis] = most(of_a.first[axis], of_b.first[axis]);
    both.last[axis] = least(of_a.last[axis], of_b.last[axis]);
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
    if (grid.blocks[k].number >= 0) from_walls(room, work, grid, k);
    for (i64 other = 0; other < k; other++) between_blocks(room, work, grid, other, k);
  }
  return first;
}

}  // namespace placement
