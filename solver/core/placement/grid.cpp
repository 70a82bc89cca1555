#include "placement/grid.hpp"

#include "placement/frames.hpp"
#include "plain/least_floor.hpp"

namespace placement {

constexpr u64 ALL = ~0ULL;

// Adds where the person's centre may be while it touches a side of a piece that stands between low and high.
static void add_side_target(
    const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high, i64 piece, i64 side) {
  const i64 inset = 2 * room.sides[work.taken_side[piece]].inset;
  const Wall wall = facing(side, work.rotation[piece]);
  const Part& body = work.parts[work.body_part[piece]];
  const i64 robot = room.space->robot;
  NumberedRect& target = grid.targets[grid.state->targets++];
  target.number = grid.state->numbers;
  const i64 normal = wall == EAST || wall == WEST ? 0 : 1;
  const i64 extent = 2 * body.extent[normal];
  const i64 shift = wall == NORTH || wall == WEST ? -robot : extent + robot;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 first = 2 * (low.at(axis, body.variable[axis]) + body.offset[axis]);
    const i64 last = 2 * (high.at(axis, body.variable[axis]) + body.offset[axis]);
    target.low[axis] = axis == normal ? first + shift : first + inset;
    target.high[axis] = axis == normal ? last + shift : last + 2 * body.extent[axis] - inset;
  }
}

// Where the centre of somebody wider than the person is who has just come through a door.
static Door entry_of(const SpaceRow& space, Door door, i64 wider) {
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 first = 2 * space.low[axis] + space.robot, last = 2 * space.high[axis] - space.robot;
    if (door.low[axis] == door.high[axis] && (door.low[axis] == first || door.low[axis] == last)) {
      door.low[axis] += door.low[axis] == first ? wider : -wider;
      door.high[axis] = door.low[axis];
    } else if (door.high[axis] - door.low[axis] < 2 * wider) {
      door.low[axis] = door.high[axis] = floor_div(door.low[axis] + door.high[axis], 4) * 2 + floor_mod(space.robot + wider, 2);
    } else {
      door.low[axis] += wider;
      door.high[axis] -= wider;
    }
  }
  return door;
}

// Collects the doors, which are the first targets; of those that are joined outside one is enough.
static void gather_doors(const Room& room, const WalkGrid& grid) {
  GridState& state = *grid.state.data;
  state.targets = 0;
  const i64 wider = state.width - room.space->robot, others = most<i64>(room.space->outer - 1, 0);
  for (i64 k = 0; k < room.doors.size; k++) {
    const Door door = wider > 0 ? entry_of(*room.space.data, room.doors[k], wider) : room.doors[k];
    grid.targets[state.targets++] = {{door.low[0], door.low[1]}, {door.high[0], door.high[1]}, most<i64>(k - others, 0)};
  }
  state.numbers = room.doors.size - others;
}

// Collects the use sides, which are no matter for who is wider than the person.
static void gather_sides(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high) {
  GridState& state = *grid.state.data;
  for (i64 piece = 0; piece < room.pieces.size; piece++) {
    if (work.taken_candidate[piece] == ABSENT) continue;
    const SidesRow& sides = room.sides[work.taken_side[piece]];
    for (i64 bit = FRONT; bit <= RIGHT; bit *= 2) {
      if ((sides.stands | sides.all_of) & bit) {
        add_side_target(room, work, grid, low, high, piece, bit);
        state.numbers++;
      }
    }
    for (i64 bit = FRONT; bit <= RIGHT; bit *= 2) {
      if (sides.any_of & bit) add_side_target(room, work, grid, low, high, piece, bit);
    }
    if (sides.any_of) state.numbers++;
  }
}

i64 find_covered(const Work& work, const Table<i64>& low, const Table<i64>& high, const Rows<NumberedRect>& found) {
  i64 count = 0;
  for (i64 k = 0; k < work.counts->parts; k++) {
    const Part& part = work.parts[k];
    if (!is_in_the_way(part)) continue;
    i64 first[2], last[2];
    for (i64 axis = 0; axis < 2; axis++) {
      first[axis] = high.at(axis, part.variable[axis]) + part.offset[axis];
      last[axis] = low.at(axis, part.variable[axis]) + part.offset[axis] + part.extent[axis];
    }
    if (first[0] >= last[0] || first[1] >= last[1]) continue;
    found[count++] = {{first[0], first[1]}, {last[0], last[1]}, k};
  }
  return count;
}

// Where no centre may be of who is so wide, by what is covered from `low` to `high`, mm.
static NumberedRect blocked_by(const i64 (&low)[2], const i64 (&high)[2], i64 number, i64 width) {
  const i64 grow = width - 1;
  return {{2 * low[0] - grow, 2 * low[1] - grow}, {2 * high[0] + grow, 2 * high[1] + grow}, number};
}

// Collects what is blocked, by bodies that cover rectangles and by parts missing from the room.
static void gather_blocks(const Room& room, const WalkGrid& grid, const Rows<NumberedRect>& bodies, i64 covered) {
  const i64 width = grid.state->width;
  i64& count = grid.state->blocks;
  for (count = 0; count < covered; count++) {
    const NumberedRect body = bodies[count];
    grid.blocks[count] = blocked_by(body.low, body.high, body.number, width);
  }
  for (i64 k = 0; k < room.zones.size; k++) {
    const Zone& zone = room.zones[k];
    if (zone.is_wall) grid.blocks[count++] = blocked_by(zone.low, zone.high, -1 - k, width);
  }
}

// Writes the sorted cuts of an axis, without repeats, and which cells each block covers; returns how many cuts there are.
static i32 cut(const WalkGrid& grid, i64 axis, i64 low, i64 high) {
  constexpr i64 BITS = 20, ENDS = 1 << BITS;  // more than blocks have
  const Span<i64> cuts = grid.cuts.row(axis), edges = grid.edges;
  i32 count = 0;
  for (i64 k = 0; k < grid.state->blocks; k++) {
    const i64 both[] = {grid.blocks[k].low[axis] * ENDS + 2 * k, grid.blocks[k].high[axis] * ENDS + 2 * k + 1};
    for (const i64 edge : both) {
      i32 at = count++;
      for (; at > 0 && edges[at - 1] > edge; at--) edges[at] = edges[at - 1];
      edges[at] = edge;
    }
  }
  i32 n = 1;
  cuts[0] = low;
  for (i32 k = 0; k < count; k++) {
    const i64 at = edges[k] >> BITS, end = edges[k] & (ENDS - 1);
    if (at > cuts[n - 1] && at < high) cuts[n++] = at;
    Cells& cells = grid.block_cells[end / 2];
    (end % 2 == 0 ? cells.first : cells.last)[axis] = at <= low ? 0 : at < high ? n - 1 : n;
  }
  cuts[n] = high;
  return n + 1;
}

// The words of a row of cells; the last cell has a blocked one behind it, and that a free one.
static i32 words_of(i32 nz) { return (nz + 1) / 64 + 1; }

// Marks cells as blocked: a word of all their rows after the other.
static void block(const WalkGrid& grid, i32 words, const Cells& cells) {
  const auto& [first, last] = cells;
  const i32 begin = first[1] / 64, end = (last[1] - 1) / 64;
  for (i32 w = begin; w <= end && first[1] < last[1]; w++) {
    const u64 from = w == begin ? ALL << first[1] % 64 : ALL, to = w == end ? ALL >> (63 - (last[1] - 1) % 64) : ALL;
    for (i32 i = first[0]; i < last[0]; i++) grid.blocked[i * words + w] |= from & to;
  }
}

// Marks the cells that blocks cover, and those beyond the ends of rows.
static void mark_blocked(const WalkGrid& grid, i32 nx, i32 nz) {
  const i32 words = words_of(nz);
  for (i32 k = 0; k < nx * words; k++) grid.blocked[k] = 0;
  block(grid, words, {{0, nz}, {nx, nz + 1}});
  for (i64 k = 0; k < grid.state->blocks; k++) block(grid, words, grid.block_cells[k]);
}

// The first cell of a row from one on that is blocked, or, by ALL, that is free.
static i32 next_cell(const u64* words, i32 from, u64 flipped) {
  i32 w = from / 64;
  u64 left = (words[w] ^ flipped) & ALL << from % 64;
  while (left == 0) left = words[++w] ^ flipped;
  return 64 * w + __builtin_ctzll(left);
}

// The first run that is known to be joined with one; its `component` is its own number.
static i32 first_joined(const Span<Run>& runs, i32 k) {
  while (runs[k].component != k) k = runs[k].component = runs[runs[k].component].component;
  return k;
}

// Joins the runs of a row, which begin at `own`, with those of the row before that they touch.
static void join_rows(const Span<Run>& runs, i32 before, i32 own, i32 end) {
  for (i32 a = before, b = own; a < own && b < end;) {
    if (runs[a].first < runs[b].last && runs[b].first < runs[a].last) {
      const i32 one = first_joined(runs, a), two = first_joined(runs, b);
      runs[most(one, two)].component = least(one, two);
    }
    (runs[a].last < runs[b].last ? a : b)++;
  }
}

// Finds the runs of free cells, row by row; each has the number of one of its component that is not behind it, the first its own.
static void find_runs(const WalkGrid& grid, i32 nx, i32 nz) {
  i32 count = 0, before = 0;
  for (i32 row = 0; row < nx; row++) {
    const u64* const words = &grid.blocked[row * words_of(nz)];
    const i32 own = grid.first_run[row] = count;
    for (i32 first = next_cell(words, 0, ALL), last; first < nz; first = next_cell(words, last, ALL)) {
      last = next_cell(words, first, 0);
      grid.runs[count] = {first, last, count};
      count++;
    }
    join_rows(grid.runs, before, own, count);
    before = own;
  }
  grid.first_run[nx] = count;
}

Cells cells_of(const WalkGrid& grid, const NumberedRect& target) {
  Cells cells;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64* const cuts = grid.cuts.row(axis).data;
    const i64 count = grid.state->cuts[axis];
    i64 low = 0, high = 0;  // cuts below its ends: there are few, and each comparison is as good as a guess
    for (i64 k = 0; k < count; k++) {
      low += cuts[k] <= target.low[axis];
      high += cuts[k] < target.high[axis];
    }
    cells.first[axis] = static_cast<i32>(most<i64>(low - 1, 0));
    cells.last[axis] = static_cast<i32>(least(high, count - 1));
  }
  return cells;
}

// Joins all runs that meet doors which are joined outside.
static void join_outside(const Room& room, const WalkGrid& grid) {
  i32 joined = -1;
  for (i64 k = 0; k < room.space->outer; k++) {
    any_met(grid, cells_of(grid, grid.targets[k]), [&](i32 run) {
      const i32 own = first_joined(grid.runs, run), one = joined < 0 ? own : first_joined(grid.runs, joined);
      joined = grid.runs[most(own, one)].component = least(own, one);
      return false;
    });
  }
}

// Numbers the components of free cells from 1, by their first cells, and sums their areas, doubled millimetres squared.
static void number_components(const WalkGrid& grid, i32 nx) {
  const Span<i64> xs = grid.cuts.row(0), zs = grid.cuts.row(1);
  i32 count = 0, k = 0;
  for (i32 row = 0; row < nx; row++) {
    for (Run& run : runs_of(grid, row)) {
      if (run.component == k++) {
        run.component = ++count;
        grid.areas[count] = 0;
      } else {
        run.component = grid.runs[run.component].component;
      }
      grid.areas[run.component] += (xs[row + 1] - xs[row]) * (zs[run.last] - zs[run.first]);
    }
  }
  grid.state->components = count;
}

// Counts what each component meets, of the targets of one number one.
static void count_reached(const WalkGrid& grid) {
  for (i64 c = 0; c <= grid.state->components; c++) grid.reached[c] = {0, -1};
  for (i64 k = 0; k < grid.state->targets; k++) {
    const i64 number = grid.targets[k].number;
    any_met(grid, cells_of(grid, grid.targets[k]), [&](i32 component) {
      Reached& reached = grid.reached[component];
      reached.count += reached.last != number;
      reached.last = number;
      return false;
    });
  }
}

// The component one walks in: at the doors joined outside, else at the first one, that which meets most; where nobody comes in the largest.
// Which is the largest may change with each piece that is added: while some are to come that stand already it may be any.
static i64 entered_of(const Room& room, const WalkGrid& grid) {
  i64 best = 0;
  if (is_walked_in_largest(room)) {
    for (i64 c = 1; c <= grid.state->components; c++) {
      const i64 more = best == 0 || !grid.state->unfinished ? 0 : grid.reached[c].count - grid.reached[best].count;
      if (best == 0 || more > 0 || (more == 0 && grid.areas[c] > grid.areas[best])) best = c;
    }
    return best;
  }
  for (i64 k = 0; k < most<i64>(room.space->outer, 1); k++) {
    any_met(grid, cells_of(grid, grid.targets[k]), [&](i32 c) {
      if (best == 0 || grid.reached[c].count > grid.reached[best].count) best = c;
      return false;
    });
  }
  return best;
}

// Parts the floor that is free beside blocks into components and counts what each meets; false where the room is too narrow.
static bool part_floor(const Room& room, const WalkGrid& grid) {
  const SpaceRow& space = *room.space.data;
  GridState& state = *grid.state.data;
  const i64 grow = state.width - 1;
  state.entered = state.cuts[0] = state.cuts[1] = 0;
  for (i64 axis = 0; axis < 2; axis++) {
    if (2 * space.low[axis] + grow >= 2 * space.high[axis] - grow) return false;
  }
  for (i64 axis = 0; axis < 2; axis++) state.cuts[axis] = cut(grid, axis, 2 * space.low[axis] + grow, 2 * space.high[axis] - grow);
  const i32 nx = static_cast<i32>(state.cuts[0]) - 1, nz = static_cast<i32>(state.cuts[1]) - 1;
  mark_blocked(grid, nx, nz);
  find_runs(grid, nx, nz);
  join_outside(room, grid);
  number_components(grid, nx);
  count_reached(grid);
  return true;
}

// The same for a person, with what it is to reach; bodies stand between low and high.
static bool part_for_person(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high) {
  grid.state->width = room.space->robot;
  gather_blocks(room, grid, grid.blocks, find_covered(work, low, high, grid.blocks));
  gather_doors(room, grid);
  gather_sides(room, work, grid, low, high);
  return part_floor(room, grid);
}

// Tells whether a component has the least free centres, of a person who is not smaller than asked.
static bool has_least_floor(const Room& room, const WalkGrid& grid, i64 component) {
  constexpr i64 SURELY = 4;  // so many times as much is enough by any measure
  const i64 wanted = 4 * room.space->least_floor;
  if (grid.areas[component] < wanted || grid.areas[component] >= SURELY * wanted) return grid.areas[component] >= wanted;
  const Span<i64> xs = grid.cuts.row(0), zs = grid.cuts.row(1);
  const i32 nx = static_cast<i32>(grid.state->cuts[0]) - 1, nz = static_cast<i32>(grid.state->cuts[1]) - 1;
  i64 area = 0;
  for (i32 i = 0; i < nx; i++) {
    for (const Run& run : runs_of(grid, i)) {
      for (i32 j = run.first; j < run.last && run.component == component; j++) {
        area += area_within(xs[i + 1] - xs[i], zs[j + 1] - zs[j], [&](i32 x, i32 z) {
          x += i, z += j;
          return x < 0 || x >= nx || z < 0 || z >= nz || (grid.blocked[x * words_of(nz) + z / 64] >> z % 64 & 1);
        });
      }
    }
  }
  return area >= wanted;
}

// Tells whether a person comes to all doors and use sides.
static bool is_reached(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& positions) {
  const i64 least_floor = room.space->least_floor;
  GridState& state = *grid.state.data;
  if (!part_for_person(room, work, grid, positions, positions)) {
    return state.numbers <= least<i64>(room.doors.size, 1) && least_floor == 0;
  }
  state.entered = entered_of(room, grid);
  if (state.entered == 0) return state.numbers == 0 && least_floor == 0;
  return grid.reached[state.entered].count == state.numbers && has_least_floor(room, grid, state.entered);
}

bool joins_doors(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& positions, i64 ways) {
  if (ways <= room.space->robot || room.doors.size < 2) return true;
  Rows<NumberedRect> bodies = grid.blocks;
  bodies.size = static_cast<i32>(find_covered(work, positions, positions, grid.blocks));
  grid.state->width = ways;
  gather_blocks(room, grid, bodies, bodies.size);
  gather_doors(room, grid);
  if (!part_floor(room, grid)) return false;
  grid.state->entered = entered_of(room, grid);
  return grid.state->entered != 0 && grid.reached[grid.state->entered].count == grid.state->numbers;
}

bool walkable(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& positions) {
  return is_reached(room, work, grid, positions) && joins_doors(room, work, grid, positions, room.space->ways);
}

bool may_be_walkable(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high) {
  if (!part_for_person(room, work, grid, low, high)) return false;
  for (i64 c = 1; c <= grid.state->components; c++) {
    if (grid.reached[c].count == grid.state->numbers && has_least_floor(room, grid, c)) return true;
  }
  return false;
}

}  // namespace placement
