#include "placement/beside.hpp"

#include "placement/program.hpp"
#include "placement/search.hpp"

namespace placement {

namespace {

// The last piece laid out, and what there was without it.
class Beside {
 public:
  Beside(const Work& work, const Table<f64>& places, const Mark& before) : work_(work), places_(places), before_(before) {}

  // Puts the new variables where their own terms cost least: at their anchors, or where what is before them wishes them.
  void put() {
    for (i64 axis = 0; axis < 2; axis++) {
      for (i64 v = before_.sizes[axis]; v < work_.sizes[axis]; v++) {
        const f64 weight = work_.anchor_weight.at(axis, v), wished = weight > 0.0 ? work_.anchor_at.at(axis, v) : pulled_to(axis, v);
        f64& at = places_.at(axis, v);
        at = least(most(wished, metres(work_.least.at(axis, v))), metres(work_.most.at(axis, v)));
        if (weight > 0.0) least_ += weight * (at - wished) * (at - wished);
      }
    }
    cost_ = least_;
    for (i64 k = before_.pulls; k < work_.counts->pulls; k++) {
      const PullRow& pull = work_.pulls[k];
      const PullCost& cost = work_.pull_costs[k];
      const auto [axis, i, j] = pull;
      const f64 off = places_.at(axis, j) - places_.at(axis, i) - cost.offset;
      const f64 lowest = metres(work_.least.at(axis, j) - work_.most.at(axis, i)) - cost.offset;
      const f64 highest = metres(work_.most.at(axis, j) - work_.least.at(axis, i)) - cost.offset;
      const f64 gap = most(most(lowest, -highest), 0.0);
      cost_ += cost.weight * off * off;
      least_ += cost.weight * gap * gap;
    }
  }

  f64 cost() const { return cost_; }     // of the new terms there
  f64 least_cost() const { return least_; }  // of the new terms, wherever all variables are

  // Tells whether all that is new holds there.
  bool holds() const {
    for (i64 axis = 0; axis < 2; axis++) {
      for (i64 v = 0; v < work_.sizes[axis]; v++) {
        const f64 at = places_.at(axis, v);
        if (at < metres(work_.low.at(axis, v)) - FEASIBLE || at > metres(work_.high.at(axis, v)) + FEASIBLE) return false;
      }
    }
    for (i64 k = before_.rows; k < work_.counts->rows; k++) {
      if (slack_of(work_.rows[k]) < -FEASIBLE) return false;
    }
    for (i64 choice = before_.choices; choice < work_.counts->choices; choice++) {
      if (!is_kept(choice)) return false;
    }
    return true;
  }

 private:
  f64 slack_of(const DifferenceRow& row) const {
    return row.i == row.j ? -metres(row.s) : place_of(places_, row.axis, row.j) - place_of(places_, row.axis, row.i) - metres(row.s);
  }

  bool is_kept(i64 choice) const {
    for (i64 k = OPTIONS * choice; k < OPTIONS * choice + work_.choice_size[choice]; k++) {
      if (slack_of(work_.options[k]) >= -FEASIBLE) return true;
    }
    return false;
  }

  // Where the first pull on a variable has it beside one before.
  f64 pulled_to(i64 axis, i64 v) const {
    for (i64 k = before_.pulls; k < work_.counts->pulls; k++) {
      const PullRow& pull = work_.pulls[k];
      if (pull.axis == axis && pull.j == v) return places_.at(axis, pull.i) + work_.pull_costs[k].offset;
    }
    return 0.0;
  }

  const Work& work_;
  const Table<f64>& places_;
  const Mark before_;
  f64 cost_ = 0.0, least_ = 0.0;
};

}  // namespace

void begin_empty(const Tree& tree) {
  for (i64& decision : tree.begun) decision = ABSENT;
  tree.optima[0] = {0.0, 1, 0};
}

static void copy(const Table<f64>& from, const Table<f64>& to) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < to.columns; v++) to.at(axis, v) = from.at(axis, v);
  }
}

void begin_with(const Tree& tree, i64 state) {
  if (state >= tree.optima.size) return;
  for (i64 piece = 0; piece < tree.begun.size; piece++) tree.begun[piece] = tree.decisions.at(state, piece);
  tree.optima[0] = tree.optima[state];
  copy(tree.places.block(state), tree.places.block(0));
}

bool is_begun(const Tree& tree, const Decisions& decisions) {
  for (i64 piece = 0; piece < decisions.size; piece++) {
    if (tree.begun[piece] != decisions[piece]) return false;
  }
  return true;
}

void keep_optimum(const Engine& engine, i64 state, bool closed) {
  if (state >= engine.tree.optima.size) return;
  engine.tree.optima[state] = {engine.nodes.best_cost[0], engine.nodes.result->exhausted, closed};
  copy(engine.nodes.best, engine.tree.places.block(state));
}

const Optimum* optimum_of(const Tree& tree, i64 state) {
  if (state >= tree.optima.size || (state == 0 && !tree.counters->begun)) return nullptr;
  return tree.optima[state].proven ? &tree.optima[state] : nullptr;
}

// Tells whether the last piece laid out is no matter for who walks: it is in nobody's way, and nobody has to come to it.
static bool is_walked_past(const Engine& engine, i64 piece, const Mark& before) {
  const Work& work = engine.work;
  const SidesRow& sides = engine.room.sides[work.taken_side[piece]];
  if ((sides.stands | sides.all_of | sides.any_of) != 0 || engine.room.pieces[piece].required == STANDS) return false;
  for (i64 k = before.parts; k < work.counts->parts; k++) {
    if (is_in_the_way(work.parts[k])) return false;
  }
  return true;
}

bool is_plain_beside(const Engine& engine, i64 state, f64 ceiling, bool walk) {
  const Work& work = engine.work;
  const Nodes& nodes = engine.nodes;
  const i64 last = work.counts->assembled - 1;
  if (engine.tree.decisions.at(state, last) != ABSENT) return false;  // something stands that comes behind what is added
  const Optimum& optimum = engine.tree.optima[state];
  const Mark before = last > 0 ? work.marks[last - 1] : Mark{};
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < before.sizes[axis]; v++) nodes.positions.at(axis, v) = engine.tree.places.at(state, axis, v);
  }
  Beside beside(work, nodes.positions, before);
  beside.put();
  SearchResult& result = *nodes.result.data;
  result.exhausted = result.beside = 1;
  result.solves = 1;  // it costs about as much as a QP
  result.dear = optimum.cost + beside.least_cost() >= ceiling - COST_TOLERANCE;
  if (result.dear) return true;
  result.found = beside.cost() <= beside.least_cost() + COST_TOLERANCE && beside.holds();
  if (result.found && walk) result.found = is_walked_past(engine, last, before) || passes(engine);
  if (!result.found) return false;
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) nodes.best.at(axis, v) = nodes.positions.at(axis, v);
  }
  nodes.best_cost[0] = optimum.cost + beside.cost();
  return true;
}

}  // namespace placement
