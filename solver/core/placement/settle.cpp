#include "placement/settle.hpp"

#include "placement/grid.hpp"
#include "placement/pull.hpp"
#include "placement/tidy.hpp"

namespace placement {

// Rounding adds this before flooring: wishes lie on half millimetres, so the switch is kept away from them and from a continuous
// solver's last digits.
constexpr f64 TIE_MM = 0.49;

// The fixed rows along an axis, and those taken.
static Span<DifferenceRow> rows_along(const Work& work, const Span<DifferenceRow>& taken, i64 axis) {
  Span<DifferenceRow> found = reserved<DifferenceRow>(static_cast<i32>(work.counts->rows) + taken.size);
  i32 count = 0;
  for (i64 k = 0; k < work.counts->rows; k++) {
    if (work.rows[k].axis == axis) found[count++] = work.rows[k];
  }
  for (const DifferenceRow& row : taken) {
    if (row.axis == axis) found[count++] = row;
  }
  return {found.data, count};
}

// Lowers positions, at first their upper bounds, to the greatest at which every row holds; false where there are none.
static bool lower_to_latest(const Span<DifferenceRow>& rows, const Span<i64>& low, const Span<i64>& latest) {
  for (i32 round = 0; round <= latest.size; round++) {
    bool changed = false;
    for (const DifferenceRow& row : rows) {
      const i64 last = (row.j == ORIGIN ? 0 : latest[row.j]) - row.s;
      if (row.i == ORIGIN) {
        if (last < 0) return false;
      } else if (latest[row.i] > last) {
        latest[row.i] = last;
        changed = true;
      }
    }
    for (i32 v = 0; v < latest.size; v++) {
      if (latest[v] < low[v]) return false;
    }
    if (!changed) return true;
  }
  return false;
}

// Moves positions up until every row holds; a solution above them exists, so that each round but the last sets one for good.
static void push(const Span<DifferenceRow>& rows, const Span<i64>& p) {
  for (i32 round = 0; round <= p.size; round++) {
    bool changed = false;
    for (const DifferenceRow& row : rows) {
      if (row.j == ORIGIN) continue;
      const i64 first = (row.i == ORIGIN ? 0 : p[row.i]) + row.s;
      if (p[row.j] >= first) continue;
      p[row.j] = first;
      changed = true;
    }
    if (!changed) return;
  }
  fail(Failure::endless);
}

// Difference constraints with whole data have a whole solution whenever they have any. The latest positions come from a backward sweep;
// then every position is rounded, clamped to the latest and pushed forward along the rows. Nothing moves by more than about the rounding.
//
// Writes whole positions, mm, near `positions`, m, at which bounds, fixed rows and the rows taken hold.
//
// Returns whether there are any: what a search found always has them.
static bool snap(const Work& work, const Span<DifferenceRow>& taken, const Table<f64>& positions, const Table<i64>& snapped) {
  for (i64 axis = 0; axis < 2; axis++) {
    arena::Scope scope;
    const i32 size = static_cast<i32>(work.sizes[axis]);
    const Span<DifferenceRow> rows = rows_along(work, taken, axis);
    const Span<i64> latest = reserved<i64>(size), p = {snapped.row(axis).data, size};
    for (i32 v = 0; v < size; v++) latest[v] = work.high.at(axis, v);
    if (!lower_to_latest(rows, work.low.row(axis), latest)) return false;
    for (i32 v = 0; v < size; v++) {
      p[v] = between(whole(floor(positions.at(axis, v) * 1000 + TIE_MM)), work.low.at(axis, v), latest[v]);
    }
    push(rows, p);
  }
  return true;
}

// The option of a choice that holds with most slack at the positions found.
static i64 widest_option(const Engine& engine, i64 choice) {
  i64 widest = OPTIONS * choice;
  f64 most = -INFINITE;
  for (i64 k = OPTIONS * choice; k < OPTIONS * choice + engine.work.choice_size[choice]; k++) {
    const DifferenceRow& row = engine.work.options[k];
    const Table<f64>& best = engine.nodes.best;
    const f64 slack = place_of(best, row.axis, row.j) - place_of(best, row.axis, row.i) - static_cast<f64>(row.s) / 1000;
    if (slack <= most) continue;
    widest = k;
    most = slack;
  }
  return widest;
}

Span<DifferenceRow> find_taken(const Desk& desk) {
  const Engine& engine = desk.engine;
  const Work& work = engine.work;
  const i64 choices = work.counts->choices, picks = engine.nodes.result->picks;
  for (i64 c = 0; c < choices; c++) desk.taken[c] = work.options[widest_option(engine, c)];
  for (i64 k = 0; k < picks; k++) {
    const i64 pick = engine.nodes.best_picks[k];
    if (pick < work.options.size) desk.taken[pick / OPTIONS] = work.options[pick];
  }
  i32 count = static_cast<i32>(choices);
  for (i64 k = picks - 1; k >= 0; k--) {
    const i64 wide = engine.nodes.best_picks[k] - work.options.size;
    if (wide >= 0) desk.taken[count++] = work.wide[wide];
  }
  return {desk.taken.data, count};
}

Settled settle(const Desk& desk, bool walk, bool slide) {
  const Engine& engine = desk.engine;
  const Table<i64>& p = engine.grid.positions;
  desk.added[0] = 0.0;
  if (!snap(engine.work, find_taken(desk), engine.nodes.best, p)) return Settled::no_whole_place;
  for (i64 axis = 0; axis < 2; axis++) p.at(axis, p.columns - 1) = 0;
  if (!holds(engine.work, p)) return Settled::not_valid;
  if (!walk || !walkable(engine.room, engine.work, engine.grid, p)) return Settled::not_walkable;
  if (slide) desk.added[0] = tidy(desk, p);
  return Settled::walkable;
}

}  // namespace placement
