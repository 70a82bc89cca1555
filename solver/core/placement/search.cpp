#include "placement/search.hpp"

#include "placement/branch.hpp"
#include "placement/dual.hpp"
#include "placement/grid.hpp"
#include "placement/nodes.hpp"
#include "placement/program.hpp"

namespace placement {

constexpr f64 COST_TOLERANCE = 1e-9;
constexpr i64 WIDENINGS = 4;  // widenings on one path of the tree

// Brings a node's path back: its rows to the programmes, its positions to nodes.positions.
static void open_node(const Work& work, const Programs& programs, const Nodes& nodes, i64 slot) {
  i64 at[2];
  for (i64 axis = 0; axis < 2; axis++) at[axis] = programs.fixed_rows[axis] + nodes.row_count.at(slot, axis);
  for (i64 pick = nodes.last_pick[slot]; pick >= 0; pick = nodes.pick_before[pick]) {
    const i64 k = nodes.pick_option[pick];
    const DifferenceRow& row = k < work.options.size ? work.options[k] : work.wide[k - work.options.size];
    append_row(programs, --at[row.axis], row);
  }
  for (i64 axis = 0; axis < 2; axis++) {
    spread(work, programs, axis, nodes.x.row(slot, axis), nodes.positions);
    nodes.state->base[axis] = 0;
  }
}

// Notes the active constraints of an axis at the open node, with their multipliers.
static void keep_forces(const Programs& programs, const Nodes& nodes, i64 slot, i64 axis) {
  const i64 n = programs.size[axis];
  for (i64 a = 0; a < nodes.active_size.at(slot, axis); a++) {
    const i64 c = nodes.active.at(slot, axis, a), at = nodes.result->forces++;
    ForceRow& force = nodes.best_forces[at];
    force = {axis, -1, c};
    if (c >= 2 * n) {
      force = {axis, programs.rows.at(axis, 0, c - 2 * n), programs.rows.at(axis, 1, c - 2 * n)};
    } else if (c >= n) {
      force = {axis, c - n, -1};
    }
    nodes.best_multipliers[at] = nodes.multiplier.at(slot, axis, a);
  }
}

static void keep_best(const Work& work, const Programs& programs, const Nodes& nodes, i64 slot) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) nodes.best.at(axis, v) = nodes.positions.at(axis, v);
  }
  nodes.best_cost[0] = nodes.total(slot);
  i64 count = 0;
  for (i64 pick = nodes.last_pick[slot]; pick >= 0; pick = nodes.pick_before[pick]) nodes.best_picks[count++] = nodes.pick_option[pick];
  nodes.result->found = 1;
  nodes.result->picks = count;
  nodes.result->forces = 0;
  for (i64 axis = 0; axis < 2; axis++) keep_forces(programs, nodes, slot, axis);
}

// Opens the root; false where it is infeasible.
static bool open_root(const Work& work, const Programs& programs, const Nodes& nodes) {
  for (i64 c = 0; c < work.counts->choices; c++) {
    if (work.choice_size[c] == 0) return false;
    work.held[c] = 0;
  }
  if (!prepare(work, programs, nodes)) return false;
  const i64 slot = next_slot(nodes);
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 k = 0; k < programs.size[axis]; k++) nodes.x.at(slot, axis, k) = programs.start.at(axis, k);
    nodes.active_size.at(slot, axis) = nodes.row_count.at(slot, axis) = 0;
    nodes.cost.at(slot, axis) = programs.start_cost[axis];
    nodes.result->solves++;
    Programme own(programs, nodes, axis, slot);
    if (continue_dual(own, programs.fixed_rows[axis], -1, INFINITE) != Solved::YES) return false;
  }
  nodes.last_pick[slot] = -1;
  nodes.widened[slot] = 0;
  take_slot(nodes);
  nodes.stack[0] = slot;
  nodes.state->open = 1;
  return true;
}

// Tells whether the open node's placement, rounded to millimetres, is walkable.
static bool passes(const Engine& engine) {
  const Table<i64>& rounded = engine.grid.positions;
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < engine.work.sizes[axis]; v++) {
      rounded.at(axis, v) = whole(floor(engine.nodes.positions.at(axis, v) * 1000 + 0.5));
    }
  }
  return walkable(engine.room, engine.work, engine.grid, rounded);
}

// Looks at an open node that may be better than the best: branches on it, keeps it, or widens what blocks its way.
static void visit(const Engine& engine, i64 slot, f64 best, bool walk) {
  const Nodes& nodes = engine.nodes;
  open_node(engine.work, engine.programs, nodes, slot);
  const i64 count = find_violated(engine, slot);
  if (count > 0) {
    branch(engine, slot, count, best);
  } else if (count == DEAD) {
    nodes.result->solves++;  // costs about as much as a QP
  } else if (!walk || passes(engine)) {
    keep_best(engine.work, engine.programs, nodes, slot);
  } else {
    nodes.result->turned_down++;
    if (nodes.widened[slot] < WIDENINGS) widen(engine, slot, best);
  }
}

// Empties the tree.
static void begin(const Work& work, const Nodes& nodes, f64 ceiling) {
  *nodes.result.data = {};
  nodes.result->exhausted = 1;
  nodes.best_cost[0] = ceiling;
  nodes.state->open = nodes.state->picked = 0;
  nodes.state->spare = nodes.state->untouched = nodes.spare.size;
  work.counts->wide = 0;
}

void search(const Engine& engine, i64 limit, f64 ceiling, bool walk) {
  constexpr i64 room_for = TRIED_CHOICES * OPTIONS + WIDE_CHILDREN;
  const Nodes& nodes = engine.nodes;
  NodesState& state = *nodes.state.data;
  begin(engine.work, nodes, ceiling);
  if (!open_root(engine.work, engine.programs, nodes)) return;
  i64 opened = 0;
  while (state.open > 0) {
    if (state.open < opened) cheapest_on_top(nodes);
    opened = state.open--;
    const i64 slot = nodes.stack[state.open];
    const f64 best = nodes.best_cost[0] - COST_TOLERANCE;
    if (nodes.total(slot) < best) {
      const bool full = state.spare <= room_for || state.picked + room_for >= nodes.pick_option.size;
      if (nodes.result->solves >= limit || full) {
        nodes.result->exhausted = 0;
        return;
      }
      visit(engine, slot, best, walk);
    }
    nodes.spare[state.spare++] = slot;
  }
}

}  // namespace placement
