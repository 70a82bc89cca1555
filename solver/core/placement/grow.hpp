// Best-first search over prefixes: pieces that stand together or not at all are added one by one.
//
// A child's bound is its parent's exact cost plus the way's own preference cost plus the least that the pieces to come will cost by
// preference (every term is >= 0, and walking only gets worse as pieces are added), so the first complete prefix popped is the best. Once
// the limit is spent the search dives: deepest prefixes first, for as many evaluations again.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Assembles and searches; tells whether a placement was found. Pays from the budget, in QPs of a small room.
bool evaluate(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, bool walk);

// The same, and all ways to open the walk are tried; the likely ones alone where all are too many for the limit.
bool evaluate_all(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, bool walk);

constexpr f64 NO_DEARER = 1e-6;  // what is found again may cost more by this

// How many QPs of so much effort the budget holds.
i64 affordable_qps(const Engine& engine, const Effort& effort);

// Finds the cheapest way for the pieces of a group to join the decisions `start`.
//
//   engine: the answer's number is left in counters.best (-1: none), the deepest prefix in `deepest` (-1: none); `closed` tells
//     whether the answer, or that there is none, is exact within the search.
//   start, start_cost: decisions so far and their cost.
//   limits: where lapses are limited, a way that failed also speaks for those that differ from it only in their anchor.
//   walk: whether doors and use sides must be joined.
bool best_first(
    const Engine& engine, const Decisions& start, const Costs& start_cost, const Group& group, const SearchLimits& limits, bool walk);

}  // namespace placement
