// A node's children: which choice to branch on, what each of its options costs, and what widening the way costs.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr i64 MOST_FAMILY = 256;  // children of one node
constexpr i64 FEW_CHILDREN = 12;  // kept of one widening, the cheapest, where not all are asked for or slots run short
constexpr i64 ALL_HOLD = -1;  // no choice of the node is violated
constexpr i64 DEAD = -2;  // a choice of the node has no option left

// The violated choice to branch on, ALL_HOLD, or DEAD.
//
// One with a single option left comes first, then those with the fewest options within reach, then the most violated, then the lowest
// number. That the cheapest children of several be compared costs more QPs than it saves (measured).
i64 find_violated(const Engine& engine, i64 slot);

// Opens a choice's children.
void branch(const Engine& engine, i64 parent, i64 choice, f64 ceiling);

// Siblings share placements: those in which the rows of both hold. Where the best of the open node is one of them, which is searched for
// below that sibling anyway, opens those of its placements in which that row does not hold; tells whether it did.
bool leave_sibling(const Engine& engine, i64 parent, f64 ceiling);

// Opens the placements in which one of the pairs that block the way leaves room for a person: all such, or the likely ones.
void widen(const Engine& engine, i64 parent, f64 ceiling, bool all);

}  // namespace placement
