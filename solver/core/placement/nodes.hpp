// The tree's open nodes: their slots, the families of children that become nodes, and which node is next.
#pragma once

#include "placement/engine.hpp"
#include "plain/pairs.hpp"

namespace placement {

// Costs and slacks are compared in steps of a nanometre or its like, so that rounding decides no tie.
constexpr f64 STEPS = 1e9;

inline i64 in_steps(f64 value) { return whole(value * STEPS); }

// The spare slot on top.
inline i64 next_slot(const Nodes& nodes) {
  const i64 top = nodes.state->spare - 1;
  return top < nodes.state->untouched ? top : nodes.spare[top];
}

// Takes the spare slot on top.
inline void take_slot(const Nodes& nodes) {
  nodes.state->spare--;
  nodes.state->untouched = least(nodes.state->untouched, nodes.state->spare);
}

// Copies the places and multipliers that a node knows of an axis.
inline void copy_axis(const Engine& engine, i64 parent, i64 slot, i64 axis) {
  const Nodes& nodes = engine.nodes;
  const Span<f64> x = nodes.x.row(parent, axis), own_x = nodes.x.row(slot, axis);
  for (i32 v = 0; v < engine.programs[axis].width; v += 2) pair_at(own_x, v) = pair_at(x, v);
  for (i32 k = 0; k < nodes.axes.at(parent, axis).active; k++) {
    nodes.active.at(slot, axis, k) = nodes.active.at(parent, axis, k);
    nodes.multiplier.at(slot, axis, k) = nodes.multiplier.at(parent, axis, k);
  }
}

// Sorts the first members of a family by cost, stably.
void sort_family(const Nodes& nodes, i64 count);

// Opens the first members of a family, the cheapest on top.
void open_family(const Engine& engine, i64 parent, i64 count);

// Brings the cheapest open node to the top, of equal ones the upper; not where slots run short, since depth needs fewer.
void cheapest_on_top(const Nodes& nodes);

}  // namespace placement
