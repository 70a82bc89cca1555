#include "placement/dual.hpp"

namespace placement {

constexpr f64 DEPENDENT = 1e-9;  // a constraint whose direction keeps less than this share of its length depends on the active ones
constexpr f64 NEGLIGIBLE = 1e-9;  // a multiplier's rate of change below this is rounding

Programme::Programme(const Programs& programs, const Nodes& nodes, i64 axis, i64 slot)
    : n(programs.size[axis]),
      inverse(programs.inverse.block(axis)),
      bounds(programs.bounds.block(axis)),
      rows(programs.rows.block(axis)),
      s(programs.row_s.row(axis)),
      columns(programs.columns.block(axis)),
      factor(programs.factor.block(axis)),
      forward(programs.vectors.row(axis, 0)),
      rates(programs.vectors.row(axis, 1)),
      x(nodes.x.row(slot, axis)),
      active(nodes.active.row(slot, axis)),
      multiplier(nodes.multiplier.row(slot, axis)),
      active_size(&nodes.active_size.at(slot, axis)),
      cost(&nodes.cost.at(slot, axis)) {}

// The normal of constraint c times column k.
static inline f64 normal_times(const Programme& own, i64 c, i64 k) {
  const Span<f64> column = own.columns.row(k);
  if (c < own.n) return column[c];
  if (c < 2 * own.n) return -column[c - own.n];
  const i64 i = own.rows.at(0, c - 2 * own.n), j = own.rows.at(1, c - 2 * own.n);
  f64 value = 0.0;
  if (j >= 0) value = column[j];
  if (i >= 0) value -= column[i];
  return value;
}

// How far row number r holds, m.
static inline f64 row_slack(const Programme& own, i64 r) {
  const i64 i = own.rows.at(0, r), j = own.rows.at(1, r);
  f64 value = -own.s[r];
  if (j >= 0) value += own.x[j];
  if (i >= 0) value -= own.x[i];
  return value;
}

// How far a constraint holds, m.
static f64 slack_of(const Programme& own, i64 c) {
  if (c < own.n) return own.x[c] - own.bounds.at(0, c);
  if (c < 2 * own.n) return own.bounds.at(1, c - own.n) - own.x[c - own.n];
  return row_slack(own, c - 2 * own.n);
}

// Writes H's inverse times the normal of constraint c to column `at`.
static void write_column(const Programme& own, i64 c, i64 at) {
  const i64 n = own.n;
  f64* column = own.columns.row(at).data;
  if (c < n) {
    const f64* from = own.inverse.row(c).data;
    for (i64 k = 0; k < n; k++) column[k] = from[k];
    return;
  }
  if (c < 2 * n) {
    const f64* from = own.inverse.row(c - n).data;
    for (i64 k = 0; k < n; k++) column[k] = -from[k];
    return;
  }
  const i64 i = own.rows.at(0, c - 2 * n), j = own.rows.at(1, c - 2 * n);
  for (i64 k = 0; k < n; k++) {
    f64 value = 0.0;
    if (j >= 0) value = own.inverse.at(j, k);
    if (i >= 0) value -= own.inverse.at(i, k);
    column[k] = value;
  }
}

// Writes rows first ... q - 1 of the Cholesky factor of N'H^-1 N.
static void factorise(const Programme& own, i64 first, i64 q) {
  for (i64 a = first; a < q; a++) {
    f64* row = own.factor.row(a).data;
    for (i64 b = 0; b <= a; b++) {
      const f64* other = own.factor.row(b).data;
      f64 value = normal_times(own, own.active[a], b);
      for (i64 k = 0; k < b; k++) value -= row[k] * other[k];
      row[b] = a == b ? root(value) : value / other[b];
    }
  }
}

void build_base(const Programme& own) {
  const i64 q = *own.active_size;
  for (i64 a = 0; a < q; a++) write_column(own, own.active[a], a);
  factorise(own, 0, q);
}

// The constraint violated most, ties by lowest number, or -1.
static i64 most_violated(const Programme& own, i64 m) {
  f64 worst = -FEASIBLE;
  i64 found = -1;
  for (i64 k = 0; k < own.n; k++) {
    const f64 value = own.x[k];
    if (value - own.bounds.at(0, k) < worst) {
      worst = value - own.bounds.at(0, k);
      found = k;
    }
    if (own.bounds.at(1, k) - value < worst) {
      worst = own.bounds.at(1, k) - value;
      found = own.n + k;
    }
  }
  for (i64 r = 0; r < m; r++) {
    const f64 slack = row_slack(own, r);
    if (slack < worst) {
      worst = slack;
      found = 2 * own.n + r;
    }
  }
  return found;
}

// Writes y = L^-1 N'H^-1 n_c to `forward` and the multipliers' rates r = L^-T y to `rates`; returns y'y.
static f64 find_directions(const Programme& own, i64 c, i64 q) {
  f64 square = 0.0;
  for (i64 a = 0; a < q; a++) {
    const f64* row = own.factor.row(a).data;
    f64 value = normal_times(own, c, a);
    for (i64 k = 0; k < a; k++) value -= row[k] * own.forward[k];
    value /= row[a];
    own.forward[a] = value;
    square += value * value;
  }
  for (i64 a = q - 1; a >= 0; a--) {
    f64 value = own.forward[a];
    for (i64 k = a + 1; k < q; k++) value -= own.factor.at(k, a) * own.rates[k];
    own.rates[a] = value / own.factor.at(a, a);
  }
  return square;
}

// Takes active constraint number k out; the factor's rows from k on are then void.
static void drop(const Programme& own, i64 k, i64 q) {
  for (i64 a = k; a < q - 1; a++) {
    own.active[a] = own.active[a + 1];
    own.multiplier[a] = own.multiplier[a + 1];
    for (i64 v = 0; v < own.n; v++) own.columns.at(a, v) = own.columns.at(a + 1, v);
  }
}

// Takes a step: the multipliers always, the solution where the new constraint does not depend on the active ones.
static void move(const Programme& own, i64 q, f64 step, bool primal) {
  if (primal) {
    for (i64 v = 0; v < own.n; v++) {
      f64 change = own.columns.at(own.n, v);
      for (i64 a = 0; a < q; a++) change -= own.rates[a] * own.columns.at(a, v);
      own.x[v] += step * change;
    }
  }
  for (i64 a = 0; a < q; a++) own.multiplier[a] -= step * own.rates[a];
}

// Makes constraint c, whose column is number n, active constraint number q.
static void append(const Programme& own, i64 q, i64 c, f64 length, f64 multiplier) {
  for (i64 a = 0; a < q; a++) own.factor.at(q, a) = own.forward[a];
  own.factor.at(q, q) = root(length);
  for (i64 v = 0; v < own.n; v++) own.columns.at(q, v) = own.columns.at(own.n, v);
  own.active[q] = c;
  own.multiplier[q] = multiplier;
  *own.active_size = q + 1;
}

// Steps until constraint c, whose column is number n, holds; false where it never can.
static bool enforce(Programme& own, i64 c) {
  i64 q = *own.active_size;
  const f64 square = normal_times(own, c, own.n);
  f64 added = 0.0;
  f64 slack = slack_of(own, c);
  // With a multiplier of its own already the constraint goes on until it is active, though its slack may be gone with the last step.
  while (slack < -FEASIBLE || added > 0.0) {
    const f64 length = square - find_directions(own, c, q);
    f64 step = INFINITE;
    i64 dropped = -1;
    for (i64 a = 0; a < q; a++) {
      const f64 rate = own.rates[a];
      if (rate > NEGLIGIBLE && own.multiplier[a] < step * rate) {
        step = own.multiplier[a] / rate;
        dropped = a;
      }
    }
    const f64 full = length > DEPENDENT * square ? most(-slack, 0.0) / length : INFINITE;
    if (dropped < 0 && full == INFINITE) return slack >= -FEASIBLE;
    const f64 taken = least(step, full);
    move(own, q, taken, full < INFINITE);
    if (full < INFINITE) *own.cost += taken * length * (0.5 * taken + added);
    added += taken;
    if (full <= step) {
      append(own, q, c, length, added);
      return true;
    }
    own.dropped = true;
    drop(own, dropped, q);
    *own.active_size = --q;
    factorise(own, dropped, q);
    slack = slack_of(own, c);
  }
  return true;
}

Solved continue_dual(Programme& own, i64 m, i64 first, f64 ceiling) {
  i64 c = first;
  for (i64 round = 0; round < 20 * (own.n + m) + 100; round++) {
    if (c < 0) {
      c = most_violated(own, m);
      if (c < 0) return Solved::YES;
    }
    write_column(own, c, own.n);
    if (!enforce(own, c)) return Solved::INFEASIBLE;
    if (*own.cost >= ceiling) return Solved::TOO_DEAR;
    c = -1;
  }
  return Solved::INFEASIBLE;
}

}  // namespace placement
