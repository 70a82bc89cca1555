// Intervals of the variables, narrowed by rows and choices: the nodes of a proof.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr i64 UNDECIDED = -1;  // of a choice: no option taken yet
constexpr i64 SETTLED = -2;  // of a choice: one of its options holds anywhere in the intervals

struct ProofNode {
  Table<i64> low, high;
  Span<i64> picks, refused;
};

enum class Holds { NOWHERE = -1, DEPENDS = 0, EVERYWHERE = 1 };

// Where in the intervals of a node a row holds.
Holds holds_in(const ProofNode& node, const DifferenceRow& row);

enum class Step { IMPOSSIBLE, SAME, CHANGED };

// Narrows two intervals to p_j - p_i >= s.
inline Step tighten(const Table<i64>& low, const Table<i64>& high, const DifferenceRow& row) {
  if (row.i == row.j) return row.s > 0 ? Step::IMPOSSIBLE : Step::SAME;
  const i64 first = bound_of(low, row.axis, row.i), last = bound_of(high, row.axis, row.j);
  if (last - first < row.s) return Step::IMPOSSIBLE;
  Step step = Step::SAME;
  if (row.j != ORIGIN && low.at(row.axis, row.j) < first + row.s) {
    low.at(row.axis, row.j) = first + row.s;
    step = Step::CHANGED;
  }
  if (row.i != ORIGIN && high.at(row.axis, row.i) > last - row.s) {
    high.at(row.axis, row.i) = last - row.s;
    step = Step::CHANGED;
  }
  return step;
}

// Narrows the intervals until nothing changes; false where a row or a choice cannot hold.
bool narrow(const Work& work, const ProofNode& node);

}  // namespace placement
