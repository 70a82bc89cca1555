#include "placement/grow.hpp"

#include "placement/assembly.hpp"
#include "placement/beside.hpp"
#include "placement/memo.hpp"
#include "placement/nodes.hpp"
#include "placement/options.hpp"
#include "placement/search.hpp"

namespace placement {

constexpr i64 EXPANDED = -1;  // decision of a heap entry that stands for the state itself

static bool before(const Tree& tree, i64 a, i64 b) {
  const HeapEntry &one = tree.heap[a], &two = tree.heap[b];
  if (one.rank != two.rank) return one.rank < two.rank;
  if (one.bound != two.bound) return one.bound < two.bound;
  if ((one.decision == EXPANDED) != (two.decision == EXPANDED)) return one.decision == EXPANDED;
  return one.age < two.age;
}

static void exchange(const Tree& tree, i64 a, i64 b) {
  swap(tree.heap[a], tree.heap[b]);
  swap(tree.heap_cost[a], tree.heap_cost[b]);
}

static void sift_up(const Tree& tree, i64 at) {
  while (at > 0 && before(tree, at, (at - 1) / 2)) {
    exchange(tree, at, (at - 1) / 2);
    at = (at - 1) / 2;
  }
}

// Adds an entry; false where the heap is full.
static bool push(const Tree& tree, f64 bound, i64 state, i64 decision, f64 cost, i64 depth) {
  Counters& counters = *tree.counters.data;
  const i64 at = counters.heaped;
  if (at >= tree.heap.size) return false;
  tree.heap[at] = {counters.diving ? -depth : 0, in_steps(bound), counters.order, state, decision};
  tree.heap_cost[at] = cost;
  counters.order++;
  counters.heaped++;
  sift_up(tree, at);
  return true;
}

// Moves the least entry to the place behind the heap's end.
static void pop(const Tree& tree) {
  const i64 last = tree.counters->heaped - 1;
  exchange(tree, 0, last);
  tree.counters->heaped = last;
  i64 at = 0;
  while (true) {
    i64 first = at;
    for (i64 child = 2 * at + 1; child < least(2 * at + 3, last); child++) {
      if (before(tree, child, first)) first = child;
    }
    if (first == at) return;
    exchange(tree, at, first);
    at = first;
  }
}

// Sorts the heap by depth first from now on.
static void dive(const Tree& tree) {
  tree.counters->diving = 1;
  tree.counters->closed = 0;
  for (i64 k = 0; k < tree.counters->heaped; k++) {
    tree.heap[k].rank = -tree.depths[tree.heap[k].state];
    sift_up(tree, k);
  }
}

constexpr f64 CUBIC_FROM = 5;  // from so many times 20 variables an axis on factors cost the most; measured
constexpr f64 MANY_ZONES = 5;  // beyond so many times 20 zones the walk costs more than a QP; measured

// What a search in the problem laid out costs.
static Effort effort_of(const Engine& engine, bool walk) {
  const Work& work = engine.work;
  const f64 size = static_cast<f64>(work.sizes[0] + work.sizes[1]) / 40;
  const f64 of_a_qp = 1 + size * size * most(1.0, size / CUBIC_FROM);  // a dense QP grows with its square, factors with the cube
  const f64 many = walk ? most(0.0, static_cast<f64>(engine.room.zones.size) / 20 - MANY_ZONES) : 0;
  // The cells that a walk is looked for in grow with the square of the zones. Reading the choices costs, too.
  return {of_a_qp + many * many, static_cast<f64>(work.counts->choices) / 4};
}

i64 affordable_qps(const Engine& engine, const Effort& effort) { return whole(most(engine.tree.budget[0] / effort.of_a_qp, 0.0)); }

// Pays for the search whose result is there; tells whether a placement was found.
static bool pay(const Engine& engine, const Effort& effort) {
  const SearchResult& result = *engine.nodes.result.data;
  f64& left = engine.tree.budget[0];
  left = left - static_cast<f64>(result.solves) * effort.of_a_qp - effort.reading;
  engine.tree.counters->solved_qps += result.solves;
  return result.found == 1;
}

// Lays decisions out, to the end of their problem or as far as it may hold; false where the bounds alone rule them out. `limit` becomes
// what a search is held to, `effort` what a QP of it costs.
static bool lay_out(const Engine& engine, const Decisions& decisions, i64& limit, bool walk, Effort& effort, bool all) {
  *engine.nodes.result.data = {};
  engine.nodes.result->exhausted = 1;
  effort = {};
  if (!assemble(engine.room, engine.work, decisions, all)) return false;
  effort = effort_of(engine, walk);
  limit = least(limit, affordable_qps(engine, effort));
  return true;
}

bool evaluate(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, bool walk) {
  Effort effort;
  if (!lay_out(engine, decisions, limit, walk, effort, true)) return false;
  search(engine, limit, ceiling, walk);
  return pay(engine, effort);
}

bool evaluate_all(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, bool walk) {
  Effort effort;
  if (!lay_out(engine, decisions, limit, walk, effort, true)) return false;
  SearchResult& result = *engine.nodes.result.data;
  search(engine, limit, ceiling, walk, true);
  if (!result.found && !result.exhausted) {
    const i64 solves = result.solves;
    search(engine, limit, ceiling, walk);
    result.exhausted &= result.turned_down == 0;
    result.solves += solves;
  }
  if (result.exhausted) result.turned_down = 0;
  return pay(engine, effort);
}

// Evaluates a state with one piece more. Picks and forces are missing where that is plain.
static bool evaluate_beside(
    const Engine& engine, const Decisions& decisions, i64 state, i64 limit, f64 ceiling, bool walk, Effort& effort) {
  if (!lay_out(engine, decisions, limit, walk, effort, false)) return false;
  const bool is_known = limit > 0 && optimum_of(engine.tree, state) != nullptr;
  if (!is_known || !is_plain_beside(engine, state, ceiling, walk)) search(engine, limit, ceiling, walk);
  return pay(engine, effort);
}

// The same, or recalls what came of it. `closed` becomes whether a placement was turned down for it that closes the wider ways.
static bool weigh(const Engine& engine, const Decisions& decisions, i64 state, i64 limit, f64 ceiling, bool walk, bool& closed) {
  Memo* memo = engine.memo;
  Effort effort;
  if (memo == nullptr) return evaluate_beside(engine, decisions, state, limit, ceiling, walk, effort);
  if (const Effort* known = recall(engine, decisions, limit, ceiling)) return pay(engine, *known);
  const i32 already = memo->closed;
  const bool found = evaluate_beside(engine, decisions, state, limit, ceiling, walk, effort);
  closed = memo->closed > already || (engine.nodes.result->beside && engine.tree.optima[state].closed);
  if (!closed) note(engine, decisions, limit, ceiling, effort);
  return found;
}

// A number for what decides feasibility while no other piece changes: ways of a group that agree in it differ only in their anchors.
static u64 fingerprint(const Room& room, const Decisions& decisions, const Group& group) {
  u64 hash = 0;
  for (i64 piece = group.first; piece < group.last; piece++) {
    const i64 decision = decisions[piece];
    hash = mixed(hash, decision == ABSENT ? ABSENT : 8 * room.candidates[candidate_of(decision)].kin + sides_of(decision));
  }
  return hash;
}

// Tells whether a fingerprint is among the refused; adds it where asked.
static bool refused(const Tree& tree, u64 number, bool add) {
  const i32 mask = tree.refused_table.size - 1;
  i64& count = tree.counters->refused;
  i32 at = static_cast<i32>(number >> 32) & mask;
  for (;; at = (at + 1) & mask) {
    const i32 k = tree.refused_table[at];
    if (k < 0 || k >= count || tree.refused_at[k] != at) break;
    if (tree.refused[k] == number) return true;
  }
  if (add && count < tree.refused.size) {
    tree.refused_table[at] = static_cast<i32>(count);
    tree.refused_at[count] = at;
    tree.refused[count++] = number;
  }
  return false;
}

// Stores a state; returns its number, or -1 where there is no room.
static i64 store(const Tree& tree, const Decisions& decisions, f64 cost, f64 chosen, i64 depth) {
  const i64 k = tree.counters->states;
  if (k >= tree.costs.size) return -1;
  for (i64 piece = 0; piece < decisions.size; piece++) tree.decisions.at(k, piece) = decisions[piece];
  tree.costs[k] = cost;
  tree.preferences[k] = chosen;
  tree.depths[k] = depth;
  tree.counters->states = k + 1;
  return k;
}

// What the pieces of a group from number `first` on will cost at least beside the decisions.
static f64 least_rest(const Room& room, const Decisions& decisions, i64 first, const Group& group) {
  f64 total = 0.0;
  for (i64 piece = first; piece < group.last; piece++) total += least_preference(room, decisions, piece);
  return total;
}

// Tells whether any piece of a group stands in the room already.
static bool any_stands(const Room& room, const Group& group) {
  for (i64 piece = group.first; piece < group.last; piece++) {
    if (room.pieces[piece].required == STANDS) return true;
  }
  return false;
}

// Pushes every way the next piece may join a state; false where the heap is full.
static bool expand(const Engine& engine, i64 state, i64 piece, i64 depth, const Group& group) {
  const Tree& tree = engine.tree;
  const f64 cost = tree.costs[state] + least_rest(engine.room, tree.decisions.row(state), piece + 1, group);
  const i64 count = open_decisions(engine.room, tree.decisions.row(state), piece, tree.found, tree.found_cost);
  for (i64 k = 0; k < count; k++) {
    if (!push(tree, cost + tree.found_cost[k], state, tree.found[k], tree.found_cost[k], depth)) return false;
  }
  return true;
}

// Notes what a way that failed says of others.
static void note_failure(const Engine& engine, u64 number, const SearchLimits& limits) {
  Counters& counters = *engine.tree.counters.data;
  const SearchResult& result = *engine.nodes.result.data;
  const bool impossible = result.turned_down == 0 && result.exhausted == 1;
  if (!result.dear && (limits.lapses < MANY || impossible)) refused(engine.tree, number, true);
  if (result.turned_down > 0) counters.closed = 0;
  counters.lapsed += result.exhausted == 0;
}

// Evaluates a way; pushes the grown state. False where there is no room to store it.
// What costs more than the best complete state found so far is cut off: costs only grow.
static bool try_entry(const Engine& engine, i64 entry, const Costs& start, const Group& group, const SearchLimits& limits, bool walk) {
  const Tree& tree = engine.tree;
  Counters& counters = *tree.counters.data;
  const i64 state = tree.heap[entry].state, depth = tree.depths[tree.heap[entry].state];
  const Decisions trial = tree.trial;
  for (i64 k = 0; k < trial.size; k++) trial[k] = tree.decisions.at(state, k);
  trial[group.first + depth] = tree.heap[entry].decision;
  const u64 number = fingerprint(engine.room, trial, group);
  if (refused(tree, number, false)) return true;
  counters.evaluated++;
  const f64 chosen = tree.preferences[state] + tree.heap_cost[entry];
  const i64 incumbent = counters.incumbent;
  const f64 rest = least_rest(engine.room, trial, group.first + depth + 1, group);
  const f64 ceiling = (incumbent >= 0 ? tree.costs[incumbent] : start.ceiling) - chosen - rest;
  const bool complete = depth + 1 == group.last - group.first;
  bool closed = false;
  engine.grid.state->unfinished = any_stands(engine.room, {group.first + depth + 1, group.last});
  bool found = weigh(engine, trial, state, limits.qps, ceiling, walk, closed);
  if (limits.every_gap && engine.nodes.result->turned_down > 0) {
    found = evaluate_all(engine, trial, limits.qps, found ? engine.nodes.best_cost[0] + NO_DEARER : ceiling, walk);
  }
  engine.grid.state->unfinished = false;
  if (engine.nodes.result->exhausted == 0) counters.closed = 0;  // what was found may cost less
  if (!found) {
    note_failure(engine, number, limits);
    return true;
  }
  const i64 grown = store(tree, trial, engine.nodes.best_cost[0] + chosen, chosen, depth + 1);
  if (grown < 0) return false;
  keep_optimum(engine, grown, closed);
  if (complete && (incumbent < 0 || tree.costs[grown] < tree.costs[incumbent])) counters.incumbent = grown;
  if (counters.deepest < 0 || depth + 1 > tree.depths[counters.deepest]) counters.deepest = grown;
  // What is complete comes before what may cost the same at least.
  return push(tree, tree.costs[grown] + rest - (complete ? COST_TOLERANCE : 0.0), grown, EXPANDED, 0.0, depth + 1);
}

// Empties the tree but for what counts over a whole room.
static void begin(const Tree& tree) {
  const i64 solved = tree.counters->solved_qps, moves = tree.counters->moves_left;
  *tree.counters.data = {};
  tree.counters->solved_qps = solved;
  tree.counters->moves_left = moves;
  tree.counters->closed = 1;
  tree.counters->best = tree.counters->deepest = tree.counters->incumbent = -1;
}

bool best_first(
    const Engine& engine, const Decisions& start, const Costs& start_cost, const Group& group, const SearchLimits& limits, bool walk) {
  const Tree& tree = engine.tree;
  const i64 total = group.last - group.first;
  Counters& counters = *tree.counters.data;
  begin(tree);
  counters.begun = is_begun(tree, start);
  i64 limit = limits.evaluations;
  push(tree, start_cost.all, store(tree, start, start_cost.all, start_cost.preferences, 0), EXPANDED, 0.0, 0);
  while (counters.heaped > 0) {
    pop(tree);
    const i64 entry = counters.heaped;
    const i64 state = tree.heap[entry].state, depth = tree.depths[tree.heap[entry].state];
    if (static_cast<f64>(tree.heap[entry].bound) >= start_cost.ceiling * STEPS) {
      if (counters.diving) continue;
      return false;
    }
    bool stored;
    if (tree.heap[entry].decision != EXPANDED) {
      stored = try_entry(engine, entry, start_cost, group, limits, walk);
    } else if (depth == total) {
      counters.best = state;
      return true;
    } else {
      stored = expand(engine, state, group.first + depth, depth, group);
    }
    if (!stored || tree.budget[0] <= 0) {
      counters.closed = 0;
      return false;
    }
    if (counters.evaluated >= limit || counters.lapsed > limits.lapses) {
      if (counters.diving || limits.lapses < MANY) {
        counters.closed = 0;
        counters.best = counters.incumbent;
        return counters.incumbent >= 0 && tree.costs[counters.incumbent] < start_cost.ceiling;
      }
      dive(tree);
      limit *= 2;
    }
  }
  return false;
}

}  // namespace placement
