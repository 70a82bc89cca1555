#include "placement/grid.hpp"

#include "placement/frames.hpp"
#include "plain/least_floor.hpp"

namespace placement {

// Adds where the person's centre may be while it touches a side of a piece that stands between low and high.
static void add_side_target(
    const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high, i64 piece, i64 side) {
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
    target.low[axis] = axis == normal ? first + shift : first;
    target.high[axis] = axis == normal ? last + shift : last + 2 * body.extent[axis];
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

// Collects the doors, which are the first targets.
static void gather_doors(const Room& room, const WalkGrid& grid) {
  GridState& state = *grid.state.data;
  state.targets = 0;
  const i64 wider = state.width - room.space->robot;
  for (i64 k = 0; k < room.doors.size; k++) {
    const Door door = wider > 0 ? entry_of(*room.space.data, room.doors[k], wider) : room.doors[k];
    grid.targets[state.targets++] = {{door.low[0], door.low[1]}, {door.high[0], door.high[1]}, k};
  }
  state.numbers = room.doors.size;
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
    if (part.stand != 0 || part.low >= HEADROOM_MM) continue;
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

// Writes the sorted cuts of an axis, without repeats; returns how many.
static i64 cut(const WalkGrid& grid, i64 axis, i64 low, i64 high) {
  const Span<i64> cuts = grid.cuts.row(axis);
  i64 n = 2;
  cuts[0] = low;
  cuts[1] = high;
  for (i64 k = 0; k < grid.state->blocks; k++) {
    const i64 edges[] = {grid.blocks[k].low[axis], grid.blocks[k].high[axis]};
    for (const i64 edge : edges) {
      if (edge <= low || edge >= high) continue;
      i64 at = n;
      while (cuts[at - 1] > edge) at--;
      if (cuts[at - 1] == edge) continue;
      for (i64 to = n; to > at; to--) cuts[to] = cuts[to - 1];
      cuts[at] = edge;
      n++;
    }
  }
  return n;
}

i64 first_cell(const WalkGrid& grid, i64 axis, i64 value) {
  constexpr i64 FEW = 24;  // so many are counted through rather than halved
  const i64* cuts = grid.cuts.row(axis).data;
  i64 low = 0, high = grid.state->cuts[axis];
  while (high - low > FEW) {
    const i64 middle = (low + high) / 2;
    if (cuts[middle] < value) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  i64 below = low;
  for (i64 k = low; k < high; k++) below += cuts[k] < value;
  return below;
}

// Labels cells 0 where free, -1 where blocked.
static void mark_blocked(const WalkGrid& grid, i64 nx, i64 nz) {
  for (i64 k = 0; k < nx * nz; k++) grid.labels[k] = 0;
  for (i64 k = 0; k < grid.state->blocks; k++) {
    const NumberedRect& block = grid.blocks[k];
    const i64 x0 = first_cell(grid, 0, block.low[0]), x1 = least(first_cell(grid, 0, block.high[0]), nx);
    const i64 z0 = first_cell(grid, 1, block.low[1]), z1 = least(first_cell(grid, 1, block.high[1]), nz);
    for (i64 i = x0; i < x1; i++) {
      for (i64 j = z0; j < z1; j++) grid.labels[i * nz + j] = -1;
    }
  }
}

// Gives a free cell of a row beside one of a component that component's number and queues it.
static void flood_to(const WalkGrid& grid, i64 cell, i64 row, i64 number, i64& queued) {
  if (grid.labels[cell] != 0) return;
  grid.labels[cell] = number;
  grid.queue[queued++] = {static_cast<i32>(cell), static_cast<i32>(row)};
}

// Numbers the components of free cells from 1 and sums their areas, doubled millimetres squared.
static void flood(const WalkGrid& grid, i64 nx, i64 nz) {
  const Span<i64> xs = grid.cuts.row(0), zs = grid.cuts.row(1);
  i64 count = 0, start = 0;
  for (i64 row = 0; row < nx; row++) {
    for (; start < (row + 1) * nz; start++) {
      if (grid.labels[start] != 0) continue;
      count++;
      i64 queued = 0, area = 0;
      flood_to(grid, start, row, count, queued);
      while (queued > 0) {
        const auto [cell, i] = grid.queue[--queued];
        const i64 j = cell - i * nz;
        area += (xs[i + 1] - xs[i]) * (zs[j + 1] - zs[j]);
        if (i > 0) flood_to(grid, cell - nz, i - 1, count, queued);
        if (i + 1 < nx) flood_to(grid, cell + nz, i + 1, count, queued);
        if (j > 0) flood_to(grid, cell - 1, i, count, queued);
        if (j + 1 < nz) flood_to(grid, cell + 1, i, count, queued);
      }
      grid.areas[count] = area;
    }
  }
  grid.state->components = count;
}

// The cells whose closed rectangles meet a target.
static Cells cells_of(const WalkGrid& grid, const NumberedRect& target) {
  Cells cells;
  for (i64 axis = 0; axis < 2; axis++) {
    cells.first[axis] = most<i64>(first_cell(grid, axis, target.low[axis]) - 1, 0);
    cells.last[axis] = least(first_cell(grid, axis, target.high[axis]), grid.state->cuts[axis] - 1);
  }
  return cells;
}

// Counts what each component meets, of the targets of one number one.
static void count_reached(const WalkGrid& grid, i64 nz) {
  for (i64 c = 0; c <= grid.state->components; c++) grid.reached[c] = {0, -1};
  for (i64 k = 0; k < grid.state->targets; k++) {
    const Cells cells = cells_of(grid, grid.targets[k]);
    for (i64 i = cells.first[0]; i < cells.last[0]; i++) {
      for (i64 j = cells.first[1]; j < cells.last[1]; j++) {
        const i64 label = grid.labels[i * nz + j];
        if (label > 0 && grid.reached[label].last != grid.targets[k].number) {
          grid.reached[label].last = grid.targets[k].number;
          grid.reached[label].count++;
        }
      }
    }
  }
}

// The component one walks in: of those at the first door the one that meets most; without doors the largest.
static i64 entered_of(const Room& room, const WalkGrid& grid) {
  i64 best = 0;
  if (room.doors.size == 0) {
    for (i64 c = 1; c <= grid.state->components; c++) {
      if (best == 0 || grid.areas[c] > grid.areas[best]) best = c;
    }
    return best;
  }
  const i64 nz = grid.state->cuts[1] - 1;
  const Cells cells = cells_of(grid, grid.targets[0]);
  for (i64 i = cells.first[0]; i < cells.last[0]; i++) {
    for (i64 j = cells.first[1]; j < cells.last[1]; j++) {
      const i64 c = grid.labels[i * nz + j];
      if (c > 0 && (best == 0 || grid.reached[c].count > grid.reached[best].count)) best = c;
    }
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
  const i64 nx = state.cuts[0] - 1, nz = state.cuts[1] - 1;
  mark_blocked(grid, nx, nz);
  flood(grid, nx, nz);
  count_reached(grid, nz);
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
  const i64 nx = grid.state->cuts[0] - 1, nz = grid.state->cuts[1] - 1;
  i64 area = 0;
  for (i64 i = 0; i < nx; i++) {
    for (i64 j = 0; j < nz; j++) {
      if (grid.labels[i * nz + j] != component) continue;
      area += area_within(xs[i + 1] - xs[i], zs[j + 1] - zs[j], [&](i64 x, i64 z) {
        x += i, z += j;
        return x < 0 || x >= nx || z < 0 || z >= nz || grid.labels[x * nz + z] < 0;
      });
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

bool joins_doors(const Room& room, const WalkGrid& grid, const Rows<NumberedRect>& bodies) {
  grid.state->width = room.space->ways;
  gather_blocks(room, grid, bodies, bodies.size);
  gather_doors(room, grid);
  if (!part_floor(room, grid)) return false;
  grid.state->entered = entered_of(room, grid);
  return grid.state->entered != 0 && grid.reached[grid.state->entered].count == grid.state->numbers;
}

bool walkable(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& positions) {
  if (!is_reached(room, work, grid, positions)) return false;
  if (room.space->ways <= room.space->robot || room.doors.size < 2) return true;
  Rows<NumberedRect> bodies = grid.blocks;
  bodies.size = static_cast<i32>(find_covered(work, positions, positions, grid.blocks));
  return joins_doors(room, grid, bodies);
}

bool may_be_walkable(const Room& room, const Work& work, const WalkGrid& grid, const Table<i64>& low, const Table<i64>& high) {
  if (!part_for_person(room, work, grid, low, high)) return false;
  for (i64 c = 1; c <= grid.state->components; c++) {
    if (grid.reached[c].count == grid.state->numbers && has_least_floor(room, grid, c)) return true;
  }
  return false;
}

}  // namespace placement
