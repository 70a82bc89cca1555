#include "placement/settle.hpp"

#include "placement/grid.hpp"
#include "placement/pull.hpp"
#include "placement/snap.hpp"
#include "placement/tidy.hpp"

namespace placement {

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

i64 find_taken(const Desk& desk) {
  const Engine& engine = desk.engine;
  const Work& work = engine.work;
  const i64 choices = work.counts->choices, picks = engine.nodes.result->picks;
  for (i64 c = 0; c < choices; c++) desk.taken[c] = work.options[widest_option(engine, c)];
  for (i64 k = 0; k < picks; k++) {
    const i64 pick = engine.nodes.best_picks[k];
    if (pick < work.options.size) desk.taken[pick / OPTIONS] = work.options[pick];
  }
  i64 count = choices;
  for (i64 k = picks - 1; k >= 0; k--) {
    const i64 wide = engine.nodes.best_picks[k] - work.options.size;
    if (wide >= 0) desk.taken[count++] = work.wide[wide];
  }
  return count;
}

void hand_over(const Desk& desk) {
  const Nodes& nodes = desk.engine.nodes;
  for (i32 k = 0; k < nodes.best.rows * nodes.best.columns; k++) desk.owns.data[k] = desk.finals.data[k] = nodes.best.data[k];
  for (i64 k = 0; k < nodes.result->forces; k++) {
    desk.force_rows[k] = nodes.best_forces[k];
    desk.multipliers[k] = nodes.best_multipliers[k];
  }
  *desk.handed.data = {find_taken(desk), nodes.result->forces};
}

// Snaps positions to grid.positions and checks them; `walkable` where they are valid, the walk not asked.
static Settled snap_and_check(const Desk& desk, const Span<DifferenceRow>& taken, const Table<f64>& positions) {
  const Table<i64>& p = desk.engine.grid.positions;
  if (!snap(desk.engine.work, taken, positions, p)) return Settled::no_whole_place;
  for (i64 axis = 0; axis < 2; axis++) p.at(axis, p.columns - 1) = 0;
  return holds(desk.engine.work, p) ? Settled::walkable : Settled::not_valid;
}

Settled settle(const Desk& desk, bool walk, bool slide) {
  const Engine& engine = desk.engine;
  const Table<i64>& p = engine.grid.positions;
  const Span<DifferenceRow> taken = {desk.taken.data, static_cast<i32>(desk.handed->taken)};
  desk.added[0] = 0.0;
  Settled found = snap_and_check(desk, taken, desk.finals);
  if (found != Settled::walkable) return found;
  if (!walk) return Settled::not_walkable;
  if (!walkable(engine.room, engine.work, engine.grid, p)) {
    arena::Scope scope;
    const Span<i64> first = reserved<i64>(p.rows * p.columns);
    for (i32 k = 0; k < first.size; k++) first[k] = p.data[k];
    found = snap_and_check(desk, taken, desk.owns);
    if (found != Settled::walkable) return found;
    if (!walkable(engine.room, engine.work, engine.grid, p)) {
      for (i32 k = 0; k < first.size; k++) p.data[k] = first[k];
      return Settled::not_walkable;
    }
  }
  if (slide) desk.added[0] = tidy(desk, p);
  return Settled::walkable;
}

}  // namespace placement
