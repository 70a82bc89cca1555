#include "placement/widen.hpp"

#include "placement/grid.hpp"
#include "plain/lists.hpp"
#include "plain/memory.hpp"

namespace placement {

// Where a block meets another one or a wall: a link of what closes the way.
struct Link {
  Cells cells;  // what both cover; of a wall the row of cells beyond the floor
  i32 block, other;  // numbers of blocks; `other` is AT_LOW or AT_HIGH for the walls there
  i32 axis;  // along which a wall is met
  i32 pile;  // the first link of those that touch one another
};

// All links, and, where they are piled up, by pile 1 for each component that it touches.
struct Links {
  List<Link> all;
  Table<u8> touched;
};

static bool same(const DifferenceRow& a, const DifferenceRow& b) { return a.axis == b.axis && a.i == b.i && a.j == b.j && a.s == b.s; }

constexpr i32 AT_LOW = -1, AT_HIGH = -2;

i64 wide_number(const Work& work, const DifferenceRow& row) {
  i64& count = work.counts->wide;
  i64 at = 0;
  while (at < count && !same(work.wide[at], row)) at++;
  if (at == work.wide.size) return UNTOLD;
  if (at == count) work.wide[count++] = row;
  return at;
}

// Adds a wider row to those found, where the bounds leave room for it.
static void add_wide(const Work& work, List<i64>& found, const DifferenceRow& row) {
  if (row.i == row.j) return;
  if (bound_of(work.high, row.axis, row.j) - bound_of(work.low, row.axis, row.i) < row.s) return;
  found.add(wide_number(work, row));
}

static void between_parts(const Work& work, List<i64>& found, const WalkGrid& grid, const Part& a, const Part& b) {
  const i64 width = grid.state->width;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 u = a.variable[axis], v = b.variable[axis];
    const i64 shift = a.offset[axis] - b.offset[axis];
    add_wide(work, found, {axis, u, v, a.extent[axis] + shift + width});
    add_wide(work, found, {axis, v, u, b.extent[axis] - shift + width});
  }
}

// Adds the rows that make room between a block and the walls on one side.
static void from_wall(const Room& room, const Work& work, List<i64>& found, const WalkGrid& grid, const Link& link) {
  const NumberedRect& block = grid.blocks[link.block];
  if (block.number < 0) return;
  const SpaceRow& space = *room.space.data;
  const Part& part = work.parts[block.number];
  const i64 axis = link.axis, width = grid.state->width, v = part.variable[axis], offset = part.offset[axis];
  if (link.other == AT_LOW) {
    add_wide(work, found, {axis, ORIGIN, v, space.low[axis] + width - offset});
  } else {
    add_wide(work, found, {axis, v, ORIGIN, part.extent[axis] + offset + width - space.high[axis]});
  }
}

// Adds the rows that make room between two blocks.
static void between_blocks(const Room& room, const Work& work, List<i64>& found, const WalkGrid& grid, const Link& link) {
  const NumberedRect &a = grid.blocks[link.block], &b = grid.blocks[link.other];
  const auto part = [&](i64 number) { return number >= 0 ? work.parts[number] : unmoved(room.zones[-1 - number]); };
  if (a.number >= 0) {
    between_parts(work, found, grid, part(a.number), part(b.number));
  } else if (b.number >= 0) {
    between_parts(work, found, grid, part(b.number), part(a.number));
  }
}

static void link_walls(List<Link>& links, const WalkGrid& grid, i32 number) {
  const NumberedRect& block = grid.blocks[number];
  for (i32 axis = 0; axis < 2; axis++) {
    const i32 cuts = static_cast<i32>(grid.state->cuts[axis]);
    Cells beyond = grid.block_cells[number];
    beyond.first[axis] = -1;
    beyond.last[axis] = 0;
    if (block.low[axis] < grid.cuts.at(axis, 0)) links.add({beyond, number, AT_LOW, axis, links.size()});
    beyond.first[axis] = cuts - 1;
    beyond.last[axis] = cuts;
    if (block.high[axis] > grid.cuts.at(axis, cuts - 1)) links.add({beyond, number, AT_HIGH, axis, links.size()});
  }
}

static void link_blocks(List<Link>& links, const WalkGrid& grid, i32 one, i32 two) {
  const NumberedRect &a = grid.blocks[one], &b = grid.blocks[two];
  const Cells &of_a = grid.block_cells[one], &of_b = grid.block_cells[two];
  Cells both;
  for (i64 axis = 0; axis < 2; axis++) {
    if (a.low[axis] >= b.high[axis] || b.low[axis] >= a.high[axis]) return;
    both.first[axis] = most(of_a.first[axis], of_b.first[axis]);
    both.last[axis] = least(of_a.last[axis], of_b.last[axis]);
  }
  links.add({both, one, two, 0, links.size()});
}

static bool touch(const Cells& a, const Cells& b) {
  return a.first[0] <= b.last[0] && b.first[0] <= a.last[0] && a.first[1] <= b.last[1] && b.first[1] <= a.last[1];
}

static i32 pile_of(const List<Link>& links, i32 link) {
  while (links[link].pile != link) link = links[link].pile = links[links[link].pile].pile;
  return link;
}

// The cells that a link covers, and those around them.
static Cells around(const WalkGrid& grid, Cells cells) {
  for (i64 axis = 0; axis < 2; axis++) {
    cells.first[axis] = most(cells.first[axis] - 1, 0);
    cells.last[axis] = least(cells.last[axis] + 1, static_cast<i32>(grid.state->cuts[axis]) - 1);
  }
  return cells;
}

// Finds the links; where asked, those that touch one another are piled up, and which components these touch is noted.
static Links find_links(const WalkGrid& grid, bool piled) {
  Links links;
  for (i32 k = 0; k < grid.state->blocks; k++) {
    link_walls(links.all, grid, k);
    for (i32 other = 0; other < k; other++) link_blocks(links.all, grid, other, k);
  }
  if (!piled) return links;
  for (i32 k = 0; k < links.all.size(); k++) {
    for (i32 other = 0; other < k; other++) {
      if (!touch(links.all[k].cells, links.all[other].cells)) continue;
      const i32 one = pile_of(links.all, k), two = pile_of(links.all, other);
      links.all[most(one, two)].pile = least(one, two);
    }
  }
  const i32 columns = static_cast<i32>(grid.state->components) + 1;
  links.touched = {zeroes<u8>(links.all.size() * columns).data, links.all.size(), columns};
  for (i32 k = 0; k < links.all.size(); k++) {
    const Span<u8> touched = links.touched.row(pile_of(links.all, k));
    any_met(grid, around(grid, links.all[k].cells), [&](i32 component) {
      touched[component] = 1;
      return false;
    });
  }
  return links;
}

// Tells whether a link's pile lies between some components and others: nobody comes from there to them unless such a link opens.
static bool parts(const Links& links, i32 link, const Span<u8>& within) {
  const Span<u8> touched = links.touched.row(pile_of(links.all, link));
  bool inside = false, outside = false;
  for (i32 c = 1; c < touched.size && !(inside && outside); c++) {
    if (touched[c]) (within[c] ? inside : outside) = true;
  }
  return inside && outside;
}

// The same of a link by itself.
static bool parts(const WalkGrid& grid, const Link& link, const Span<u8>& within) {
  bool inside = false, outside = false;
  return any_met(grid, around(grid, link.cells), [&](i32 component) {
    (within[component] ? inside : outside) = true;
    return inside && outside;
  });
}

static i64 count_parting(const Links& links, const Span<u8>& within) {
  i64 count = 0;
  for (i32 k = 0; k < links.all.size(); k++) count += parts(links, k, within);
  return count;
}

// The components in which one of the targets from number `k` on is that have the same number; `k` becomes the number behind them.
static Span<u8> components_at(const WalkGrid& grid, i64& k, bool& any) {
  const Span<u8> within = zeroes<u8>(static_cast<i32>(grid.state->components) + 1);
  any = false;
  for (const i64 number = grid.targets[k].number; k < grid.state->targets && grid.targets[k].number == number; k++) {
    any_met(grid, cells_of(grid, grid.targets[k]), [&](i32 component) {
      any = within[component] = 1;
      return false;
    });
  }
  return within;
}

// The block over a point of a door's line, on an axis, that reaches farthest; -1 where none is there.
static i32 farthest_over(const WalkGrid& grid, const NumberedRect& door, i64 axis, i64 point) {
  i32 found = -1;
  for (i32 k = 0; k < grid.state->blocks; k++) {
    const NumberedRect& block = grid.blocks[k];
    const bool over = block.low[1 - axis] <= door.low[1 - axis] && block.high[1 - axis] >= door.low[1 - axis];
    if (!over || block.low[axis] > point || block.high[axis] < point) continue;
    if (found < 0 || block.high[axis] > grid.blocks[found].high[axis]) found = k;
  }
  return found;
}

// Adds a row that takes a block off what is before, or behind, a place on an axis.
static void leave(const Work& work, List<i64>& found, const WalkGrid& grid, const NumberedRect& block, i64 axis, i64 place, bool before) {
  if (block.number < 0) return;
  const i64 grow = grid.state->width - 1;
  const Part& part = work.parts[block.number];
  const i64 v = part.variable[axis], offset = part.offset[axis];
  if (before) {
    add_wide(work, found, {axis, ORIGIN, v, floor_div(place + grow + 2, 2) - offset});
  } else {
    add_wide(work, found, {axis, v, ORIGIN, part.extent[axis] + offset - floor_div(place - grow - 1, 2)});
  }
}

// Adds rows that take a block off a stretch of a door's line.
static void uncover(const Work& work, List<i64>& found, const WalkGrid& grid, const NumberedRect& block, const NumberedRect& stretch) {
  for (i64 axis = 0; axis < 2; axis++) {
    leave(work, found, grid, block, axis, stretch.low[axis], true);
    leave(work, found, grid, block, axis, stretch.high[axis], false);
  }
}

// Adds rows of which one must hold where somebody can come in by a door that blocks cover, one behind another: one of them leaves the
// stretch that it has of the door. False where they do not tell all.
static bool uncover(const Work& work, List<i64>& found, const WalkGrid& grid, const NumberedRect& door) {
  const i64 axis = door.low[0] == door.high[0] ? 1 : 0;
  const Span<i64> cuts = grid.cuts.row(axis);
  NumberedRect stretch = door;
  const i64 end = least(door.high[axis], cuts[static_cast<i32>(grid.state->cuts[axis]) - 1]);
  stretch.low[axis] = most(door.low[axis], cuts[0]);
  for (i32 k = farthest_over(grid, door, axis, stretch.low[axis]); k >= 0;) {
    const NumberedRect& block = grid.blocks[k];
    if (block.high[axis] >= end) {
      stretch.high[axis] = end;
      uncover(work, found, grid, block, stretch);
      return true;
    }
    k = farthest_over(grid, door, axis, block.high[axis]);
    if (k < 0 || grid.blocks[k].high[axis] <= block.high[axis]) return false;
    stretch.high[axis] = floor_div(most(grid.blocks[k].low[axis], stretch.low[axis]) + block.high[axis], 2);
    uncover(work, found, grid, block, stretch);
    stretch.low[axis] = stretch.high[axis];
  }
  return false;
}

// Adds what uncovers the first that is covered of what must be come to; false where nothing is, or the rows do not tell all.
static bool uncover_first(const Room& room, const Work& work, List<i64>& found, const WalkGrid& grid) {
  bool any;
  for (i64 k = 0; k < grid.state->targets;) {
    const i64 first = k;
    components_at(grid, k, any);
    if (any) continue;
    bool told = k <= room.doors.size;  // sides move with their pieces
    for (i64 one = first; told && one < k; one++) told = uncover(work, found, grid, grid.targets[one]);
    if (!told) found.add(UNTOLD);
    return told;
  }
  return false;
}

// Adds what frees an end of a door's line that a block covers, where one comes in by the rest to one side of what is parted alone.
static void uncover_ends(const Room& room, const Work& work, List<i64>& found, const WalkGrid& grid, const Span<u8>& within) {
  for (i64 k = 0; k < room.doors.size; k++) {
    const NumberedRect& door = grid.targets[k];
    const i64 axis = door.low[0] == door.high[0] ? 1 : 0;
    bool inside = false, outside = false;
    any_met(grid, cells_of(grid, door), [&](i32 component) {
      (within[component] ? inside : outside) = true;
      return false;
    });
    if (inside == outside) continue;
    const i32 low = farthest_over(grid, door, axis, door.low[axis]), high = farthest_over(grid, door, axis, door.high[axis]);
    if (low >= 0) leave(work, found, grid, grid.blocks[low], axis, door.low[axis], true);
    if (high >= 0) leave(work, found, grid, grid.blocks[high], axis, door.high[axis], false);
  }
}

// Finds the components that are parted from the others by the fewest links: `best`, or those at something that is not reached. False where
// no link tells what is wrong: all is reached, and too little floor is free.
static bool part_by_fewest(const WalkGrid& grid, const Links& links, Span<u8>& best) {
  i64 fewest = count_parting(links, best);
  bool reached = true, any;
  for (i64 k = 0; k < grid.state->targets;) {
    const Span<u8> within = components_at(grid, k, any);
    if (within[grid.state->entered]) continue;
    reached = false;
    if (!any) continue;  // covered: no link leads to it
    const i64 count = count_parting(links, within);
    if (count >= fewest) continue;
    best = within;
    fewest = count;
  }
  return !reached;
}

Span<i64> wider_rows(const Room& room, const Work& work, const WalkGrid& grid, bool all) {
  List<i64> found;
  if (all && grid.state->cuts[0] > 0 && uncover_first(room, work, found, grid)) return found.all();
  if (grid.state->entered == 0) {
    found.add(UNTOLD);
    return found.all();
  }
  const Links links = find_links(grid, all);
  Span<u8> within = zeroes<u8>(static_cast<i32>(grid.state->components) + 1);
  within[grid.state->entered] = 1;
  if (all && !part_by_fewest(grid, links, within)) found.add(UNTOLD);
  if (all) uncover_ends(room, work, found, grid, within);
  for (i32 k = 0; k < links.all.size(); k++) {
    if (!(all ? parts(links, k, within) : parts(grid, links.all[k], within))) continue;
    if (links.all[k].other < 0) {
      from_wall(room, work, found, grid, links.all[k]);
    } else {
      between_blocks(room, work, found, grid, links.all[k]);
    }
  }
  return found.all();
}

}  // namespace placement
