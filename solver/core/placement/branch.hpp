// A node's children: which choice to branch on, what each of its options costs, and what widening the way costs.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr i64 TRIED_CHOICES = 4;  // how many of the most violated choices are tried at a node
constexpr i64 WIDE_CHILDREN = 12;  // children kept of one widening
constexpr i64 DEAD = -1;  // a choice of the node has no option left

// Writes the violated choices to try to nodes.worst; returns how many.
//
// Those with the fewest options left within reach come first, then the most violated, then the lowest number. A choice with one
// option left is written alone; DEAD is returned where one has none.
i64 find_violated(const Engine& engine, i64 slot);

// Opens the children of the first of `count` choices that has only one, else of the choice whose cheapest child is dearest.
void branch(const Engine& engine, i64 parent, i64 count, f64 ceiling);

// Opens the placements in which one of the pairs that block the way leaves room for a person.
void widen(const Engine& engine, i64 parent, f64 ceiling);

}  // namespace placement
