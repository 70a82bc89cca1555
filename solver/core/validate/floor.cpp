// Tiles, their grids and components.
#include "validate/floor.hpp"

namespace validate {

constexpr i64 SMALLEST = 200000;  // tiles are not halved below 5 cm, however many boxes meet there

static Span<i64> sorted_once(List<i64>& values) {
  stable_sort(values.all(), [](i64 a, i64 b) { return a < b; });
  keep_once(values);
  return values.all();
}

static i32 count_below(Span<i64> values, i64 value) {
  return count_before(values, [&](i64 one) { return one < value; });
}

// Adds a number to the cells of a box, as steps: the sum of a row of cells up to one is what that one holds.
static void add_steps(const Grid& grid, const Rect& box, i32 number) {
  const i32 x0 = count_below(grid.xs, box.x0), x1 = count_below(grid.xs, box.x1);
  const i32 z0 = count_below(grid.zs, box.z0), z1 = count_below(grid.zs, box.z1);
  if (z0 >= z1) return;
  for (i32 i = x0; i < x1; i++) {
    grid.cells.at(i, z0) += number;
    if (z1 < grid.cells.columns) grid.cells.at(i, z1) -= number;
  }
}

Grid grid_of(Span<Rect> floors, Span<Rect> obstacles) {
  List<i64> xs, zs;
  const auto add_cuts = [&](const Rect& box) { xs.add(box.x0), xs.add(box.x1), zs.add(box.z0), zs.add(box.z1); };
  for (const Rect& box : floors) add_cuts(box);
  for (const Rect& box : obstacles) add_cuts(box);
  Grid grid{sorted_once(xs), sorted_once(zs), {}};
  const i32 wide = most(grid.xs.size - 1, 0), deep = most(grid.zs.size - 1, 0);
  const i64 outweighs = -static_cast<i64>(floors.size) - 1;  // one obstacle, all floors
  if (static_cast<i64>(wide) * deep > (1 << 28) || -outweighs * obstacles.size >= 1LL << 31) fail(Failure::memory_full);
  grid.cells = {zeroes<i32>(wide * deep).data, wide, deep};
  for (const Rect& box : floors) add_steps(grid, box, 1);
  for (const Rect& box : obstacles) add_steps(grid, box, static_cast<i32>(outweighs));
  for (i32 i = 0; i < wide; i++) {
    i32 held = 0;
    for (i32& cell : grid.cells.row(i)) {
      held += cell;
      cell = held > 0;
    }
  }
  return grid;
}

CellWindow window_of(const Grid& grid, const Rect& box) {
  const auto first = [](Span<i64> cuts, i64 low) { return most(count_below(cuts, low + 1) - 1, 0); };
  const auto last = [](Span<i64> cuts, i64 high) { return least(count_below(cuts, high), cuts.size - 1); };
  return {first(grid.xs, box.x0), last(grid.xs, box.x1), first(grid.zs, box.z0), last(grid.zs, box.z1)};
}

// The parts of boxes that lie in a region; where they are many, each once.
static List<Rect> clipped(Span<Rect> boxes, const Rect& region, i32 many) {
  List<Rect> found;
  for (const Rect& box : boxes) {
    if (box.overlaps(region)) found.add(box.common(region));
  }
  if (found.size() <= many) return found;
  stable_sort(found.all(), goes_before);
  keep_once(found);
  return found;
}

List<Grid> tiles_of(Span<Rect> floors, Span<Rect> obstacles, i32 most_boxes) {
  struct Part {
    Rect region;
    Span<Rect> floors, obstacles;
  };
  List<Grid> tiles;
  List<Part> waiting;
  if (floors.size == 0) return tiles;
  Rect all = floors[0];
  for (const Rect& box : floors) all = all.with(box);
  waiting.add({all, floors, obstacles});
  while (waiting.size() > 0) {
    const Part part = waiting[waiting.size() - 1];
    waiting.cut(waiting.size() - 1);
    const Rect& region = part.region;
    const Span<Rect> here = clipped(part.floors, region, most_boxes).all(), taken = clipped(part.obstacles, region, most_boxes).all();
    bool is_covered = here.size == 0;
    for (const Rect& box : taken) is_covered = is_covered || box == region;
    if (is_covered) continue;
    if (here.size + taken.size <= most_boxes || most(region.width(), region.depth()) <= SMALLEST) {
      tiles.add(grid_of(here, taken));
      continue;
    }
    Rect first = region, second = region;
    if (region.width() >= region.depth()) first.x1 = second.x0 = region.x0 + region.width() / 2;
    else first.z1 = second.z0 = region.z0 + region.depth() / 2;
    waiting.add({second, here, taken});
    waiting.add({first, here, taken});
  }
  return tiles;
}

namespace {

// Numbers of which some are joined; each stands for the least of those it is joined with.
class Joined {
 public:
  explicit Joined(i32 count) : first_(reserved<i32>(count + 1)) {
    for (i32 i = 0; i <= count; i++) first_[i] = i;
  }
  i32 first(i32 run) const {
    while (first_[run] != run) run = first_[run] = first_[first_[run]];
    return run;
  }
  void join(i32 a, i32 b) const {
    const i32 one = first(a), other = first(b);
    first_[most(one, other)] = least(one, other);
  }
  // Numbers the groups from 1, in the order of their first members; puts a member's number in its place. Returns how many there are.
  i32 number() const {
    i32 count = 0;
    for (i32 run = 1; run < first_.size; run++) first_[run] = first_[run] == run ? ++count : first_[first_[run]];
    return count;
  }
  i32 operator[](i32 run) const { return first_[run]; }

 private:
  Span<i32> first_;
};

// Free cells side by side along z, from `start` to before `end`, in a row across x.
struct Run {
  i32 row, start, end;
};

// A free cell at a tile's border: on which line (across x or z), from, to, of which component.
struct Border {
  i64 axis, line, from, to, component;

  bool is_before(const Border& other) const {
    if (axis != other.axis) return axis < other.axis;
    return line != other.line ? line < other.line : from < other.from;
  }
};

}  // namespace

// Finds the runs of free cells along z, row by row.
static List<Run> runs_of(const Table<i32>& cells) {
  List<Run> runs;
  for (i32 i = 0; i < cells.rows; i++) {
    const Span<i32> row = cells.row(i);
    for (i32 k = 0; k < row.size; k++) {
      if (row[k] == 0) continue;
      const i32 start = k;
      while (k < row.size && row[k] != 0) k++;
      runs.add({i, start, k});
    }
  }
  return runs;
}

// Numbers the components of one tile from `count` + 1; returns the last number.
static i32 label_tile(const Grid& grid, i32 count) {
  arena::Scope scope;
  const List<Run> runs = runs_of(grid.cells);
  const Joined joined(runs.size());
  for (i32 a = 0, b = 0; b < runs.size();) {
    const Run &one = runs[a], &other = runs[b];
    const bool beside = one.row + 1 == other.row;
    if (beside && one.start < other.end && other.start < one.end) joined.join(a + 1, b + 1);
    if (one.row + 1 < other.row || (beside && one.end <= other.end)) a++;
    else b++;
  }
  const i32 found = joined.number();
  for (i32 k = 0; k < runs.size(); k++) {
    const Span<i32> row = grid.cells.row(runs[k].row);
    for (i32 at = runs[k].start; at < runs[k].end; at++) row[at] = count + joined[k + 1];
  }
  return count + found;
}

static void add_borders(const Grid& grid, bool at_end, List<Border>& found) {
  const Table<i32>& cells = grid.cells;
  if (cells.rows == 0 || cells.columns == 0) return;
  const i32 row = at_end ? cells.rows - 1 : 0, column = at_end ? cells.columns - 1 : 0;
  for (i32 k = 0; k < cells.columns; k++) {
    if (cells.at(row, k)) found.add({0, grid.xs[at_end ? cells.rows : 0], grid.zs[k], grid.zs[k + 1], cells.at(row, k)});
  }
  for (i32 i = 0; i < cells.rows; i++) {
    if (cells.at(i, column)) found.add({1, grid.zs[at_end ? cells.columns : 0], grid.xs[i], grid.xs[i + 1], cells.at(i, column)});
  }
}

// Joins the components of different tiles that share more than a point of a border.
static void join_tiles(const List<Grid>& tiles, const Joined& joined) {
  List<Border> ending, beginning;
  for (const Grid& tile : tiles) add_borders(tile, true, ending), add_borders(tile, false, beginning);
  const auto before = [](const Border& a, const Border& b) { return a.is_before(b); };
  stable_sort(ending.all(), before);
  stable_sort(beginning.all(), before);
  i32 here = 0, there = 0;
  while (here < ending.size() && there < beginning.size()) {
    const Border &one = ending[here], &other = beginning[there];
    const bool same_line = one.axis == other.axis && one.line == other.line;
    if (same_line && least(one.to, other.to) > most(one.from, other.from)) {
      joined.join(static_cast<i32>(one.component), static_cast<i32>(other.component));
    }
    const bool ends_first = same_line ? one.to <= other.to : one.is_before(other);
    if (ends_first) here++;
    else there++;
  }
}

i32 label(List<Grid>& tiles) {
  i32 count = 0;
  for (const Grid& tile : tiles) count = label_tile(tile, count);
  if (tiles.size() < 2) return count;
  const Joined joined(count);
  join_tiles(tiles, joined);
  const i32 found = joined.number();
  for (const Grid& tile : tiles) {
    for (i32 i = 0; i < tile.cells.rows; i++) {
      for (i32& cell : tile.cells.row(i)) {
        if (cell) cell = joined[cell];
      }
    }
  }
  return found;
}

void find_free(Span<Rect> floors, Span<Rect> obstacles, i32 most_boxes, List<Rect>& found) {
  for (const Grid& tile : tiles_of(floors, obstacles, most_boxes)) {
    rectangles(tile, [&](i32 i, i32 k) { return tile.cells.at(i, k) != 0; }, found);
  }
}

}  // namespace validate
