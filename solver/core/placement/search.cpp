#include "placement/search.hpp"

#include "placement/branch.hpp"
#include "placement/dual.hpp"
#include "placement/grid.hpp"
#include "placement/memo.hpp"
#include "placement/nodes.hpp"
#include "placement/program.hpp"

namespace placement {

constexpr i64 WIDENINGS = 4, MOST_WIDENINGS = 12;  // widenings on one path of the tree

// Writes the rows of a node's path along an axis to its programme, or the last of them.
static void write_path(const Engine& engine, i64 slot, i64 axis, bool only_last) {
  const Nodes& nodes = engine.nodes;
  const Program& program = engine.programs[axis];
  i32 at = 2 * program.size + program.fixed_rows + nodes.axes.at(slot, axis).rows;
  for (i64 pick = nodes.last_pick[slot]; pick >= 0; pick = nodes.pick_before[pick]) {
    const DifferenceRow& row = row_of(engine.work, nodes.pick_option[pick]);
    if (row.axis != axis) continue;
    write_row(program, --at, row);
    if (only_last) return;
  }
}

// Brings a node back: its rows to the programmes, its positions to nodes.positions; what is there from the last one stays.
static void open_node(const Engine& engine, i64 slot) {
  const Nodes& nodes = engine.nodes;
  for (i64 axis = 0; axis < 2; axis++) {
    const NodeAxis& own = nodes.axes.at(slot, axis);
    i64& shown = nodes.state->shown[axis];
    if (shown == own.version) continue;
    write_path(engine, slot, axis, shown == own.before);
    spread(engine.programs[axis], nodes.x.row(slot, axis), nodes.positions.row(axis));
    shown = own.version;
  }
}

// Notes the active constraints of an axis at the open node, with their multipliers.
static void keep_forces(const Engine& engine, i64 slot, i64 axis) {
  const Nodes& nodes = engine.nodes;
  const Program& program = engine.programs[axis];
  for (i64 a = 0; a < nodes.axes.at(slot, axis).active; a++) {
    const FreeRow& row = program.rows[nodes.active.at(slot, axis, a)];
    const i64 at = nodes.result->forces++;
    nodes.best_forces[at] = {axis, row.i < program.size ? row.i : -1, row.j < program.size ? row.j : -1};
    nodes.best_multipliers[at] = nodes.multiplier.at(slot, axis, a);
  }
}

static void keep_best(const Engine& engine, i64 slot) {
  const Work& work = engine.work;
  const Nodes& nodes = engine.nodes;
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) nodes.best.at(axis, v) = nodes.positions.at(axis, v);
  }
  nodes.best_cost[0] = nodes.total(slot);
  i64 count = 0;
  for (i64 pick = nodes.last_pick[slot]; pick >= 0; pick = nodes.pick_before[pick]) nodes.best_picks[count++] = nodes.pick_option[pick];
  nodes.result->found = 1;
  nodes.result->picks = count;
  nodes.result->forces = 0;
  for (i64 axis = 0; axis < 2; axis++) keep_forces(engine, slot, axis);
}

// Writes the options of the choices that are new; of the others is known which option held last.
static void place_options(const Work& work, i32 columns) {
  i64& placed = work.counts->placed;
  for (; placed < work.counts->choices; placed++) {
    for (i64 k = OPTIONS * placed; k < OPTIONS * placed + work.choice_size[placed]; k++) {
      const DifferenceRow& row = work.options[k];
      const i64 first = row.axis * columns, origin = first + columns - 1;
      const i64 i = row.i == ORIGIN ? origin : first + row.i, j = row.j == ORIGIN ? origin : first + row.j;
      work.placed_options[k] = {static_cast<i32>(i), static_cast<i32>(j), static_cast<f64>(row.s) / 1000};
    }
    work.held[placed] = work.placed_options[OPTIONS * placed];
  }
}

// Opens the root; false where it is infeasible.
static bool open_root(const Engine& engine) {
  const Work& work = engine.work;
  const Nodes& nodes = engine.nodes;
  bool none_left = false;
  for (i64 c = 0; c < work.counts->choices; c++) none_left |= work.choice_size[c] == 0;
  if (none_left || !prepare(engine)) return false;
  for (i64 c = 0; c < work.counts->choices; c++) {
    if (work.choice_size[c] == 1 && !fix_row(engine, work.options[OPTIONS * c])) return false;
  }
  place_options(work, nodes.positions.columns);
  const i64 slot = next_slot(nodes);
  for (i64 axis = 0; axis < 2; axis++) {
    const Program& program = engine.programs[axis];
    const Span<f64> x = nodes.x.row(slot, axis);
    for (i32 v = 0; v < program.width; v++) x[v] = program.start[v];
    nodes.axes.at(slot, axis) = {program.start_cost, 0, 0, ++nodes.state->versions, NO_VERSION};
    nodes.result->solves++;
    Programme own(program, nodes, axis, slot);
    if (continue_dual(own, 2 * program.size + program.fixed_rows, -1, INFINITE) != Solved::YES) return false;
  }
  nodes.last_pick[slot] = -1;
  nodes.widened[slot] = 0;
  take_slot(nodes);
  nodes.stack[0] = slot;
  nodes.state->open = 1;
  return true;
}

bool passes(const Engine& engine) {
  const Table<i64>& rounded = engine.grid.positions;
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < engine.work.sizes[axis]; v++) {
      rounded.at(axis, v) = whole(floor(engine.nodes.positions.at(axis, v) * 1000 + 0.5));
    }
  }
  const bool passed = walkable(engine.room, engine.work, engine.grid, rounded);
  if (engine.memo == nullptr) return passed;
  Memo& memo = *engine.memo;
  if (!passed) {
    memo.closed += engine.grid.state->width > engine.room.space->robot;  // a person came everywhere where somebody wider walked last
  } else if (engine.room.space->ways < memo.ways) {
    memo.closed += !joins_doors(engine.room, engine.work, engine.grid, rounded, memo.ways);
  }
  return passed;
}

// Looks at an open node that may be better than the best: branches on it, keeps it, or widens what blocks its way.
static void visit(const Engine& engine, i64 slot, f64 best, bool walk, bool all) {
  const Nodes& nodes = engine.nodes;
  open_node(engine, slot);
  if (all && leave_sibling(engine, slot, best)) return;
  const i64 choice = find_violated(engine, slot);
  if (choice >= 0) {
    branch(engine, slot, choice, best);
  } else if (choice == DEAD) {
    nodes.result->solves++;  // costs about as much as a QP
  } else if (!walk || passes(engine)) {
    keep_best(engine, slot);
  } else {
    nodes.result->turned_down++;
    if (nodes.widened[slot] < (all ? MOST_WIDENINGS : WIDENINGS)) {
      widen(engine, slot, best, all);
    } else if (all) {
      nodes.result->exhausted = 0;
    }
  }
}

// Empties the tree.
static void begin(const Nodes& nodes) {
  nodes.state->open = nodes.state->picked = 0;
  nodes.state->spare = nodes.state->untouched = nodes.spare.size;
  for (i64 axis = 0; axis < 2; axis++) {
    nodes.state->shown[axis] = nodes.state->based[axis] = nodes.state->reached[axis] = NO_VERSION;
  }
}

// Searches for what is cheaper than the best so far.
static void go_on(const Engine& engine, i64 limit, bool walk, bool all) {
  const Nodes& nodes = engine.nodes;
  NodesState& state = *nodes.state.data;
  begin(nodes);
  if (!open_root(engine)) return;
  i64 opened = 0;
  while (state.open > 0) {
    if (state.open < opened) cheapest_on_top(nodes);
    opened = state.open--;
    const i64 slot = nodes.stack[state.open];
    const f64 best = nodes.best_cost[0] - COST_TOLERANCE;
    if (nodes.total(slot) < best) {
      const bool full = state.spare <= OPTIONS + FEW_CHILDREN || state.picked + MOST_FAMILY >= nodes.pick_option.size;
      if (nodes.result->solves >= limit || full) {
        nodes.result->exhausted = 0;
        return;
      }
      visit(engine, slot, best, walk, all);
    } else {
      nodes.result->dear = 1;
    }
    nodes.spare[state.spare++] = slot;
  }
}

void search(const Engine& engine, i64 limit, f64 ceiling, bool walk, bool all) {
  *engine.nodes.result.data = {};
  engine.nodes.result->exhausted = 1;
  engine.nodes.best_cost[0] = ceiling;
  engine.work.counts->wide = 0;
  go_on(engine, limit, walk, all);
}

}  // namespace placement
