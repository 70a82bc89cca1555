#include "placement/narrow.hpp"

namespace placement {

constexpr i64 ROUNDS = 40;  // passes over the rows at a node, at most; fewer only prune less

Holds holds_in(const ProofNode& node, const DifferenceRow& row) {
  if (row.i == row.j) return row.s <= 0 ? Holds::EVERYWHERE : Holds::NOWHERE;
  const i64 lowest = bound_of(node.low, row.axis, row.j) - bound_of(node.high, row.axis, row.i);
  const i64 highest = bound_of(node.high, row.axis, row.j) - bound_of(node.low, row.axis, row.i);
  return lowest >= row.s ? Holds::EVERYWHERE : highest < row.s ? Holds::NOWHERE : Holds::DEPENDS;
}

// Settles a choice of which an option holds anywhere, and takes the only option left; false where none is.
static bool choose(const Work& work, const ProofNode& node, i64 choice) {
  i64 left = 0, only = 0;
  for (i64 k = 0; k < work.choice_size[choice]; k++) {
    const Holds holds = holds_in(node, work.options[OPTIONS * choice + k]);
    if (holds == Holds::EVERYWHERE) {
      node.picks[choice] = SETTLED;
      return true;
    }
    if (holds == Holds::DEPENDS && !(node.refused[choice] & (1LL << k))) {
      left++;
      only = k;
    }
  }
  if (left == 1) node.picks[choice] = only;
  return left > 0;
}

// Narrows the intervals by one choice: by what is refused of it, and by the option it took.
static Step decide(const Work& work, const ProofNode& node, i64 choice) {
  Step all = Step::SAME;
  for (i64 k = 0; k < work.choice_size[choice]; k++) {
    if (node.refused[choice] & (1LL << k)) {
      const DifferenceRow& row = work.options[OPTIONS * choice + k];
      const Step step = tighten(node.low, node.high, {row.axis, row.j, row.i, 1 - row.s});
      if (step == Step::IMPOSSIBLE) return step;
      all = most(all, step);
    }
  }
  if (node.picks[choice] == UNDECIDED && !choose(work, node, choice)) return Step::IMPOSSIBLE;
  if (node.picks[choice] >= 0) {
    const Step step = tighten(node.low, node.high, work.options[OPTIONS * choice + node.picks[choice]]);
    return step == Step::IMPOSSIBLE ? step : most(all, step);
  }
  return all;
}

bool narrow(const Work& work, const ProofNode& node) {
  for (i64 round = 0; round < ROUNDS; round++) {
    Step all = Step::SAME;
    for (i64 k = 0; k < work.counts->rows; k++) {
      const Step step = tighten(node.low, node.high, work.rows[k]);
      if (step == Step::IMPOSSIBLE) return false;
      all = most(all, step);
    }
    for (i64 choice = 0; choice < work.counts->choices; choice++) {
      if (node.picks[choice] == SETTLED && !node.refused[choice]) continue;
      const Step step = decide(work, node, choice);
      if (step == Step::IMPOSSIBLE) return false;
      all = most(all, step);
    }
    if (all == Step::SAME) return true;
  }
  return true;
}

}  // namespace placement
