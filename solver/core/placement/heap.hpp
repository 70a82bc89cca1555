// The heap of the best-first search: ways that states may grow by, the least rank, bound and age on top.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr i64 EXPANDED = -1;  // decision of a heap entry that stands for the state itself

// Adds an entry; false where the heap is full.
bool push(const Tree& tree, f64 bound, i64 state, i64 decision, f64 cost, i64 depth);

// Moves the least entry to the place behind the heap's end.
void pop(const Tree& tree);

// Sorts the heap by depth first from now on.
void dive(const Tree& tree);

}  // namespace placement
