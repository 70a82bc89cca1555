#include "floor/free_floor.hpp"

#include "plain/least_floor.hpp"

namespace {

constexpr i64 PER_MM = 4;
constexpr i64 LEAST_FLOOR = LEAST_FLOOR_MM2 * PER_MM * PER_MM;
constexpr i32 FREE = 0, TAKEN = -1;

constexpr Rect scaled(const Rect& rect) { return {PER_MM * rect.x0, PER_MM * rect.z0, PER_MM * rect.x1, PER_MM * rect.z1}; }

// Cells from `first` to before `last` along an axis.
struct CellRange {
  i32 first;
  i32 last;
};

CellRange cells_between(Span<i64> cuts, i64 low, i64 high) {
  const i32 after_low = count_before(cuts, [&](i64 cut) { return cut <= low; });
  const i32 at_high = count_before(cuts, [&](i64 cut) { return cut < high; });
  return {most(after_low - 1, 0), least(at_high, cuts.size - 1)};
}

// The cuts of an axis: its ends and what lies between, sorted, without repeats.
Span<i64> cuts_between(i64 low, i64 high, Span<Interval> edges) {
  List<i64> cuts;
  cuts.add(low);
  cuts.add(high);
  for (const Interval& one : edges) {
    if (low < one.low && one.low < high) cuts.add(one.low);
    if (low < one.high && one.high < high) cuts.add(one.high);
  }
  stable_sort(cuts.all(), [](i64 a, i64 b) { return a < b; });
  keep_once(cuts);
  return cuts.all();
}

// The cells between the edges of what is taken, each with the number of its component of the free floor, from 1; around them taken ones.
class Cells {
 public:
  Cells(const Rect& floor, Span<Rect> taken) {
    List<Interval> across, along;
    for (const Rect& rect : taken) {
      if (!rect.overlaps(floor)) continue;
      across.add({rect.x0, rect.x1});
      along.add({rect.z0, rect.z1});
    }
    xs_ = cuts_between(floor.x0, floor.x1, across.all());
    zs_ = cuts_between(floor.z0, floor.z1, along.all());
    labels_ = {reserved<i32>((xs_.size + 1) * (zs_.size + 1)).data, xs_.size + 1, zs_.size + 1};
    for (i32 i = 0; i < labels_.rows; i++) {
      const bool is_inside = i > 0 && i + 1 < labels_.rows;
      const Span<i32> row = labels_.row(i);
      for (i32& label : row) label = is_inside ? FREE : TAKEN;
      row[0] = row[row.size - 1] = TAKEN;
    }
    for (i32 k = 0; k < across.size(); k++) take({across[k].low, along[k].low, across[k].high, along[k].high});
    flood();
  }

  i32 components() const { return components_; }

  // The area of a component's free centres, of a person who is not smaller than asked; no more is counted once that is `enough`.
  i64 area(i32 component, i64 enough) const {
    i64 area = 0;
    for (i32 i = 1; i + 1 < labels_.rows; i++) {
      for (i32 j = 1; j + 1 < labels_.columns; j++) {
        if (labels_.at(i, j) != component) continue;
        area += area_within(xs_[i] - xs_[i - 1], zs_[j] - zs_[j - 1], [&](i32 x, i32 z) { return labels_.at(i + x, j + z) == TAKEN; });
        if (area >= enough) return area;
      }
    }
    return area;
  }

  // The component with the most free centres; 0 where there is none.
  i32 largest() const {
    i32 best = 0;
    i64 largest = -1;
    const i64 whole = (xs_[xs_.size - 1] - xs_[0]) * (zs_[zs_.size - 1] - zs_[0]);
    for (i32 component = 1; component <= components_; component++) {
      const i64 own = area(component, whole);
      if (own > largest) best = component;
      largest = most(own, largest);
    }
    return best;
  }

  // Marks the components of which a cell meets a box.
  void mark_touched(const Rect& box, Span<bool> touched) const {
    const i32 nx = xs_.size - 1, nz = zs_.size - 1;
    if (most(box.x0, xs_[0]) >= least(box.x1, xs_[nx]) || most(box.z0, zs_[0]) >= least(box.z1, zs_[nz])) return;
    const CellRange x = cells_between(xs_, box.x0, box.x1), z = cells_between(zs_, box.z0, box.z1);
    for (i32 i = x.first; i < x.last; i++) {
      for (i32 j = z.first; j < z.last; j++) {
        if (label_at(i, j) != TAKEN) touched[label_at(i, j) - 1] = true;
      }
    }
  }

  // Makes one component of those that are marked.
  void join(Span<bool> marked) {
    i32 first = 0;
    for (i32 k = 0; k < labels_.rows * labels_.columns; k++) {
      i32& label = labels_.data[k];
      if (label == TAKEN || !marked[label - 1]) continue;
      if (first == 0) first = label;
      label = first;
    }
  }

 private:
  i32& label_at(i32 i, i32 j) const { return labels_.at(i + 1, j + 1); }

  void take(const Rect& rect) {
    const CellRange x = cells_between(xs_, rect.x0, rect.x1), z = cells_between(zs_, rect.z0, rect.z1);
    for (i32 i = x.first; i < x.last; i++) {
      for (i32 j = z.first; j < z.last; j++) label_at(i, j) = TAKEN;
    }
  }

  void flood() {
    const i32 all = labels_.rows * labels_.columns;
    const Span<i32> queue = reserved<i32>(all);
    for (i32 start = 0; start < all; start++) {
      if (labels_.data[start] != FREE) continue;
      flood_from(start, ++components_, queue);
    }
  }

  // Numbers the free cells that hang together with one of them.
  void flood_from(i32 start, i32 number, Span<i32> queue) {
    const i32 beside[] = {-labels_.columns, labels_.columns, -1, 1};
    i32 queued = 0;
    const auto reach = [&](i32 cell) {
      if (labels_.data[cell] != FREE) return;
      labels_.data[cell] = number;
      queue[queued++] = cell;
    };
    reach(start);
    while (queued > 0) {
      const i32 cell = queue[--queued];
      for (const i32 step : beside) reach(cell + step);
    }
  }

  Span<i64> xs_{}, zs_{};
  Table<i32> labels_{};
  i32 components_ = 0;
};

// Takes from the components that serve those that do not touch something; gives back what touched it for the next.
void keep(Span<bool> serving, Span<bool> touched) {
  for (i32 k = 0; k < serving.size; k++) {
    serving[k] = serving[k] && touched[k];
    touched[k] = false;
  }
}

}  // namespace

FreeFloor::FreeFloor(const Rect& clear, i64 robot, Span<Doorway> doors, Span<Goal> goals, i32 outer)
    : reach_(floor_div(robot * PER_MM, 2) - 1), domain_(scaled(clear).shrunk(reach_)), doors_(doors), goals_(goals), outer_(outer) {}

Rect FreeFloor::grown(const Rect& body) const { return scaled(body).shrunk(-reach_); }

// Where the centre is when somebody has just come through a door.
Rect FreeFloor::entry_of(const Doorway& door) const {
  const Interval along = door.square.along(door.wall);
  const Rect beyond = scaled(door.square).shrunk(reach_);
  return strip_at(door.wall, inner_line(door.wall, domain_, beyond), {PER_MM * along.low + reach_, PER_MM * along.high - reach_}, 1);
}

// Where the centre is while somebody touches that side of a body.
Rect FreeFloor::contact(const Rect& body, Wall side) const {
  return strip_at(opposite(side), grown(body).line(side), scaled(body).along(side), 1);
}

bool FreeFloor::connects() const {
  if (domain_.width() <= 0 || domain_.depth() <= 0) return false;
  const arena::Scope scope;
  Cells cells(domain_, taken_.all());
  const Span<bool> serving = reserved<bool>(cells.components()), touched = zeroes<bool>(cells.components());
  for (bool& serves : serving) serves = true;
  for (i32 k = 0; k < outer_; k++) cells.mark_touched(entry_of(doors_[k]), touched);
  if (outer_ > 0) {
    cells.join(touched);
    keep(serving, touched);
  }
  for (i32 k = outer_; k < doors_.size; k++) {
    cells.mark_touched(entry_of(doors_[k]), touched);
    keep(serving, touched);
  }
  for (const Goal& goal : goals_) {
    for (const Wall side : WALLS) {
      if (!(goal.sides >> static_cast<i32>(side) & 1)) continue;
      cells.mark_touched(contact(goal.rect, side), touched);
      if (goal.need_all) keep(serving, touched);
    }
    if (!goal.need_all) keep(serving, touched);
  }
  const i32 only = doors_.size > 0 ? 0 : cells.largest();  // nobody comes in
  for (i32 k = 0; k < serving.size; k++) {
    if (serving[k] && (only == 0 || only == k + 1) && cells.area(k + 1, LEAST_FLOOR) >= LEAST_FLOOR) return true;
  }
  return false;
}

bool FreeFloor::connects_with(const Rect& body) {
  add(body);
  const bool connected = connects();
  taken_.cut(taken_.size() - 1);
  return connected;
}
