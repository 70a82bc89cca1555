// The node QP: a dual active-set method on difference rows (Goldfarb & Idnani, Mathematical Programming 27, 1983).
//
// minimise 1/2 x'Hx + f'x subject to x_j - x_i + rest >= 0, along one axis; bounds are such rows, too. H's inverse is given; the solution,
// the active set and the multipliers of the parent node are continued, since one row more leaves them dual feasible.
//
// The parent's columns H^-1 N and the Cholesky factor of N'H^-1 N are built once for all its children: a child appends to them, and
// only one that drops a constraint spoils them.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr f64 FEASIBLE = 1e-9;  // a constraint is violated by more than this, m

enum class Solved { YES, INFEASIBLE, TOO_DEAR };

// One axis's programme with the node that is solved on it.
struct Programme {
  Programme(const Program& program, const Nodes& nodes, i64 axis, i64 slot)
      : of(program),
        x(nodes.x.row(slot, axis)),
        active(nodes.active.row(slot, axis)),
        multiplier(nodes.multiplier.row(slot, axis)),
        node(nodes.axes.at(slot, axis)) {}

  const Program& of;
  Span<f64> x;
  Span<i32> active;  // numbers of rows
  Span<f64> multiplier;
  NodeAxis& node;
  bool dropped = false;  // a constraint was dropped, which spoils the base
};

// Writes the columns and the factor of a node's active set.
void build_base(const Programme& own);

// Continues a node from a dual feasible solution until no constraint is violated.
//
//   own: its base must be built; x, active set, multipliers and cost are changed in place.
//   count: how many rows there are, the bounds among them.
//   first: the row to begin with, or -1.
//   ceiling: the cost at which to stop.
Solved continue_dual(Programme& own, i32 count, i32 first, f64 ceiling);

}  // namespace placement
