#include "placement/branch.hpp"

#include "placement/dual.hpp"
#include "placement/nodes.hpp"
#include "placement/program.hpp"
#include "placement/widen.hpp"
#include "plain/pairs.hpp"

namespace placement {

constexpr f64 ROUNDING = 1e-7;  // an option is given up only if it misses by more than this, m

// A variable's number among the free ones, and where it is if it is fixed.
struct Place {
  i32 column;
  f64 value;
};

inline Place place_of(const Program& program, i64 variable) {
  const i64 at = variable == ORIGIN ? program.column.size - 1 : variable;
  return {program.column[at], program.value[at]};
}

// Tells whether a row over all variables is within reach.
inline bool possible(const Engine& engine, const DifferenceRow& row) {
  if (row.i == row.j) return row.s <= 0;
  const Program& program = engine.programs[row.axis];
  const Place i = place_of(program, row.i), j = place_of(program, row.j);
  const f64 room = -metres(row.s) + (program.most[j.column] + j.value) - (program.least[i.column] + i.value);
  return room >= -ROUNDING;
}

// Narrows how far variables go by the rows from one to before another; tells whether that changed anything.
static bool sweep(const Program& program, i32 first, i32 end) {
  const i32 n = program.size;
  const Span<f64> &least = program.least, &most = program.most;
  bool changed = false;
  for (i32 r = first; r < end; r++) {
    const auto [i, j, rest] = program.rows[r];
    const f64 lowest = least[i] - rest, highest = most[j] + rest;
    const bool is_higher = least[j] < lowest - ROUNDING, is_lower = most[i] > highest + ROUNDING;
    if (!is_higher && !is_lower) continue;
    if (is_higher && j < n) {
      least[j] = lowest;
      changed = true;
    }
    if (is_lower && i < n) {
      most[i] = highest;
      changed = true;
    }
  }
  return changed;
}

// Bound propagation over difference rows, as in disjunctive scheduling (Carlier & Pinson, Management Science 35, 1989): no QP is spent on
// options that are out of reach.
//
// Writes to `least` and `most` the positions of an axis's free variables that its first `count` rows behind the bounds leave.
static void propagate(Program& program, i32 count) {
  const Span<f64> &least = program.least, &most = program.most;
  const i32 first = 2 * program.size, end = first + count;
  for (i32 v = 0; v < program.width; v += 2) {
    pair_at(least, v) = pair_at(program.low, v);
    pair_at(most, v) = pair_at(program.high, v);
  }
  // More than two sweeps sharpen the bounds for more than that saves (measured).
  if (sweep(program, first, end)) sweep(program, first, end);
}

constexpr f64 VIOLATED = 1e-8;  // an option holds when it misses by less than this, m
// Puts choices with fewer options within reach before those violated more; more than any slack in steps.
constexpr i64 FEWER_FIRST = 1'000'000'000'000;
// With more choices than this the most violated come first whatever is left to them: nothing is proven there anyway.
constexpr i64 MANY_CHOICES = 500;

// How far an option of a choice holds at positions, m.
static f64 slack_at(const f64* positions, const PlacedOption& own) { return positions[own.j] - positions[own.i] - own.s; }

// The first choice from number `choice` on of which no option holds that was last seen to; `choices` where there is none. By itself, since
// a loop of few steps is compiled to fewer where nothing else is in their way. Its end by `<` is one jump, by a `>=` that fails four steps.
[[gnu::noinline]] static i32 next_doubtful(const PlacedOption* held, const f64* positions, i32 choice, i32 choices) {
  while (choice < choices && !(slack_at(positions, held[choice]) < -VIOLATED)) choice++;
  return choice;
}

// How far the option of a choice holds that holds best; where it holds at all, some option that does, which is noted.
static f64 best_slack(const Engine& engine, i32 choice) {
  const i32 first = OPTIONS * choice, end = first + static_cast<i32>(engine.work.choice_size[choice]);
  const f64* positions = engine.nodes.positions.data;
  PlacedOption& held = engine.work.held[choice];
  f64 slack = slack_at(positions, held);
  for (i32 k = first; k < end && slack < -VIOLATED; k++) {
    held = engine.work.placed_options[k];
    slack = most(slack, slack_at(positions, held));
  }
  return slack;
}

// How many options of a choice are still within reach.
static i64 possible_options(const Engine& engine, i64 choice) {
  i64 count = 0;
  for (i64 k = OPTIONS * choice; k < OPTIONS * choice + engine.work.choice_size[choice]; k++) {
    count += possible(engine, engine.work.options[k]);
  }
  return count;
}

// Finds how far the rows of the open node let the variables go, where that is not known from the last one.
static void reach_out(const Engine& engine, i64 slot) {
  for (i64 axis = 0; axis < 2; axis++) {
    const NodeAxis& own = engine.nodes.axes.at(slot, axis);
    i64& reached = engine.nodes.state->reached[axis];
    if (reached == own.version) continue;
    propagate(engine.programs[axis], engine.programs[axis].fixed_rows + own.rows);
    reached = own.version;
  }
}

i64 find_violated(const Engine& engine, i64 slot) {
  const i32 choices = static_cast<i32>(engine.work.counts->choices);
  const bool few = choices <= MANY_CHOICES;
  bool known = false;
  i64 found = ALL_HOLD, lowest = 0;
  const auto next_from = [&](i32 c) { return next_doubtful(engine.work.held.data, engine.nodes.positions.data, c, choices); };
  for (i32 c = next_from(0); c < choices; c = next_from(c + 1)) {
    const f64 slack = best_slack(engine, c);
    if (slack >= -VIOLATED) continue;
    if (!known) reach_out(engine, slot);
    known = true;
    const i64 left = possible_options(engine, c);
    if (left <= 1) return left == 0 ? DEAD : c;
    const i64 key = (few ? left * FEWER_FIRST : 0) + in_steps(slack);
    if (found != ALL_HOLD && key >= lowest) continue;
    found = c;
    lowest = key;
  }
  return found;
}

// Solves the parent with one row more; returns the child's slot, or -1 where it is infeasible or too dear.
static i64 solve_child(const Engine& engine, i64 parent, i64 option, f64 ceiling) {
  const Nodes& nodes = engine.nodes;
  NodesState& state = *nodes.state.data;
  const DifferenceRow& row = row_of(engine.work, option);
  const i64 axis = row.axis;
  const Program& program = engine.programs[axis];
  const NodeAxis &before = nodes.axes.at(parent, axis), &other = nodes.axes.at(parent, 1 - axis);
  if (program.fixed_rows + before.rows >= program.most_rows) {
    nodes.result->exhausted = 0;
    return -1;
  }
  nodes.result->solves++;
  const i32 at = 2 * program.size + program.fixed_rows + before.rows;
  if (!write_row(program, at, row)) return -1;
  if (state.based[axis] != before.version) build_base(Programme(program, nodes, axis, parent));
  const i64 slot = next_slot(nodes);
  nodes.axes.at(slot, axis) = before;
  copy_axis(engine, parent, slot, axis);
  Programme own(program, nodes, axis, slot);
  const Solved solved = continue_dual(own, at + 1, at, ceiling - other.cost);
  state.based[axis] = own.dropped ? NO_VERSION : before.version;
  const bool dear = solved == Solved::TOO_DEAR || own.node.cost + other.cost >= ceiling;
  nodes.result->dear |= dear;
  if (dear || solved == Solved::INFEASIBLE) return -1;
  own.node.rows++;
  own.node.version = ++state.versions;
  own.node.before = before.version;
  nodes.axes.at(slot, 1 - axis) = other;
  nodes.last_pick[slot] = option;  // becomes a pick when the child is kept
  nodes.widened[slot] = nodes.widened[parent];
  take_slot(nodes);
  return slot;
}

// Writes the numbers of a choice's options to nodes.order, those that miss least at nodes.positions first.
static void order_options(const Engine& engine, i64 choice) {
  const Nodes& nodes = engine.nodes;
  for (i64 o = 0; o < engine.work.choice_size[choice]; o++) {
    const i64 k = OPTIONS * choice + o;
    const i64 slack = in_steps(slack_at(nodes.positions.data, engine.work.placed_options[k]));
    i64 at = o;
    for (; at > 0 && nodes.order[at - 1].slack < slack; at--) nodes.order[at] = nodes.order[at - 1];
    nodes.order[at] = {k, slack};
  }
}

void branch(const Engine& engine, i64 parent, i64 choice, f64 ceiling) {
  const Work& work = engine.work;
  const Nodes& nodes = engine.nodes;
  i64 count = 0;
  order_options(engine, choice);
  for (i64 o = 0; o < work.choice_size[choice]; o++) {
    const i64 k = nodes.order[o].option;
    if (!possible(engine, work.options[k])) continue;
    const i64 slot = solve_child(engine, parent, k, ceiling);
    if (slot >= 0) nodes.family[count++] = {slot, in_steps(nodes.total(slot))};
  }
  sort_family(nodes, count);
  open_family(engine, parent, count);
}

constexpr i32 MOST_WIDE_PICKS = 48;  // of a path, that siblings are left for another one; widenings still fit in SPARE_PATH

// The row of a sibling that was opened on top of a node of the open node's path, where it holds at the open node by more than rounding;
// null where none does, or the path is too long.
static const DifferenceRow* row_of_sibling(const Engine& engine, i64 slot) {
  const Nodes& nodes = engine.nodes;
  const DifferenceRow* found = nullptr;
  i32 wide = 0;
  for (i64 pick = nodes.last_pick[slot]; pick >= 0; pick = nodes.pick_before[pick]) {
    wide += nodes.pick_option[pick] >= engine.work.options.size;
    for (i64 q = pick + 1; found == nullptr && q < nodes.state->picked && nodes.pick_before[q] == nodes.pick_before[pick]; q++) {
      const DifferenceRow& row = row_of(engine.work, nodes.pick_option[q]);
      const f64 apart = place_of(nodes.positions, row.axis, row.j) - place_of(nodes.positions, row.axis, row.i);
      if (row.i != row.j && apart > metres(row.s) + ROUNDING) found = &row;
    }
  }
  return wide < MOST_WIDE_PICKS ? found : nullptr;
}

bool leave_sibling(const Engine& engine, i64 parent, f64 ceiling) {
  const DifferenceRow* row = row_of_sibling(engine, parent);
  const i64 number = row == nullptr ? UNTOLD : wide_number(engine.work, {row->axis, row->j, row->i, -row->s});
  if (number == UNTOLD) return false;
  const i64 slot = solve_child(engine, parent, engine.work.options.size + number, ceiling);
  engine.nodes.family[0] = {slot, 0};
  if (slot >= 0) open_family(engine, parent, 1);
  return true;
}

// Tells whether a row holds only where another one does.
static bool implies(const DifferenceRow& row, const DifferenceRow& other) {
  return row.axis == other.axis && row.i == other.i && row.j == other.j && row.s >= other.s;
}

// Tells whether whatever a row of `wide` allows at a node is found without it: below a sibling of the node's path that was opened on top of
// it, or beside it, by a row of its own family that forbids less.
static bool is_covered(const Engine& engine, i64 slot, const Span<i64>& rows, i32 at) {
  const Nodes& nodes = engine.nodes;
  const DifferenceRow& row = engine.work.wide[rows[at]];
  for (i32 k = 0; k < rows.size; k++) {
    const bool other = rows[k] != UNTOLD && (rows[k] != rows[at] || k < at);
    if (other && implies(row, engine.work.wide[rows[k]])) return true;
  }
  for (i64 pick = nodes.last_pick[slot]; pick >= 0; pick = nodes.pick_before[pick]) {
    for (i64 q = pick + 1; q < nodes.state->picked && nodes.pick_before[q] == nodes.pick_before[pick]; q++) {
      if (implies(row, row_of(engine.work, nodes.pick_option[q]))) return true;
    }
  }
  return false;
}

void widen(const Engine& engine, i64 parent, f64 ceiling, bool all) {
  const arena::Scope scope;
  const Nodes& nodes = engine.nodes;
  i64 count = 0;
  reach_out(engine, parent);
  const Span<i64> rows = wider_rows(engine.room, engine.work, engine.grid, all);
  for (i32 at = 0; at < rows.size; at++) {
    const i64 row = rows[at];
    const bool fits = count < nodes.family.size && nodes.state->spare >= OPTIONS;
    if (all && (row == UNTOLD || !fits)) nodes.result->exhausted = 0;
    if (!fits) break;
    if (row == UNTOLD || (all && is_covered(engine, parent, rows, at))) continue;
    if (!possible(engine, engine.work.wide[row])) {
      nodes.result->solves++;  // a QP would say so, too
      continue;
    }
    const i64 slot = solve_child(engine, parent, engine.work.options.size + row, ceiling);
    if (slot < 0) continue;
    nodes.widened[slot]++;
    nodes.family[count++] = {slot, in_steps(nodes.total(slot))};
  }
  sort_family(nodes, count);
  const i64 kept = all && nodes.state->spare >= nodes.spare.size / 2 ? count : least(count, FEW_CHILDREN);
  if (all && kept < count) nodes.result->exhausted = 0;
  for (i64 k = kept; k < count; k++) nodes.spare[nodes.state->spare++] = nodes.family[k].slot;
  open_family(engine, parent, kept);
}

}  // namespace placement
