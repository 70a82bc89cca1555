// The node QP: a dual active-set method on difference rows (Goldfarb & Idnani, Mathematical Programming 27, 1983).
//
// minimise 1/2 x'Hx + f'x subject to low <= x <= high and x_j - x_i >= s, along one axis. H's inverse is given; the solution, the
// active set and the multipliers of the parent node are continued, since one row more leaves them dual feasible. Constraint c < n
// is the lower bound of variable c, n <= c < 2n the upper bound of c - n, c >= 2n row c - 2n.
//
// The parent's columns H^-1 N and the Cholesky factor of N'H^-1 N are built once for all its children: a child appends to them, and
// only one that drops a constraint spoils them.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr f64 FEASIBLE = 1e-9;  // a constraint is violated by more than this, m

enum class Solved { YES, INFEASIBLE, TOO_DEAR };

// One axis's programme with the node that is solved on it: what is needed of `Programs` and `Nodes`, taken out once.
struct Programme {
  Programme(const Programs& programs, const Nodes& nodes, i64 axis, i64 slot);

  i64 n;  // free variables
  Table<f64> inverse, bounds;
  Table<i64> rows;
  Span<f64> s;
  Table<f64> columns;  // number q: of active constraint q; number n: of the one that is being enforced
  Table<f64> factor;
  Span<f64> forward, rates;  // L^-1 N'H^-1 n_c, and how fast the multipliers change
  Span<f64> x;
  Span<i64> active;
  Span<f64> multiplier;
  i64* active_size;
  f64* cost;
  bool dropped = false;  // a constraint was dropped, which spoils the base
};

// Writes the columns and the factor of a node's active set.
void build_base(const Programme& own);

// Continues a node from a dual feasible solution until no constraint is violated.
//
//   own: its base must be built; x, active set, multipliers and cost are changed in place.
//   m: how many rows there are.
//   first: the constraint to begin with, or -1.
//   ceiling: the cost at which to stop.
Solved continue_dual(Programme& own, i64 m, i64 first, f64 ceiling);

}  // namespace placement
