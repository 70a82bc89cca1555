#include "placement/dual.hpp"

#include "plain/pairs.hpp"

namespace placement {

constexpr f64 DEPENDENT = 1e-9;  // a constraint whose direction keeps less than this share of its length depends on the active ones
constexpr f64 NEGLIGIBLE = 1e-9;  // a multiplier's rate of change below this is rounding

// The normal of a row times a row of numbers by free variable.
static inline f64 normal_times(const FreeRow& row, const Span<f64>& numbers) { return numbers[row.j] - numbers[row.i]; }

// How far a row holds, m.
static inline f64 slack_of(const Programme& own, const FreeRow& row) { return row.rest + own.x[row.j] - own.x[row.i]; }

// Writes H's inverse times the normal of row c to column number `at`.
static void write_column(const Program& of, i32 c, i32 at) {
  const Span<f64> plus = of.inverse.row(of.rows[c].j), minus = of.inverse.row(of.rows[c].i), column = of.columns.row(at);
  for (i32 v = 0; v < of.width; v += 2) pair_at(column, v) = pair_at(plus, v) - pair_at(minus, v);
}

// Writes rows first ... q - 1 of the Cholesky factor of N'H^-1 N.
static void factorise(const Programme& own, i32 first, i32 q) {
  for (i32 a = first; a < q; a++) {
    const FreeRow& constraint = own.of.rows[own.active[a]];
    const Span<f64> row = own.of.factor.row(a);
    for (i32 b = 0; b <= a; b++) {
      const Span<f64> other = own.of.factor.row(b);
      f64 value = normal_times(constraint, own.of.columns.row(b));
      for (i32 k = 0; k < b; k++) value -= row[k] * other[k];
      row[b] = a == b ? root(value) : value / other[b];
    }
  }
}

void build_base(const Programme& own) {
  const i32 q = own.node.active;
  for (i32 a = 0; a < q; a++) write_column(own.of, own.active[a], a);
  factorise(own, 0, q);
}

// Tells whether a free variable is beyond its bounds.
static bool is_out_of_bounds(const Programme& own) {
  const Program& of = own.of;
  Pair worst = {0.0, 0.0};
  for (i32 v = 0; v < of.width; v += 2) {
    const Pair x = pair_at(own.x, v);
    worst = least_of(worst, least_of(x - pair_at(of.low, v), pair_at(of.high, v) - x));
  }
  return worst[0] < -FEASIBLE || worst[1] < -FEASIBLE;
}

// The row violated most, ties by lowest number, or -1.
static i32 most_violated(const Programme& own, i32 count) {
  f64 worst = -FEASIBLE;
  i32 found = -1;
  for (i32 c = is_out_of_bounds(own) ? 0 : 2 * own.of.size; c < count; c++) {
    const f64 slack = slack_of(own, own.of.rows[c]);
    if (slack < worst) {
      worst = slack;
      found = c;
    }
  }
  return found;
}

// Writes y = L^-1 N'H^-1 n_c to row q of the factor, which is row q of it should c become active, and the multipliers' rates L^-T y to
// `rates`; returns y'y.
static f64 find_directions(const Programme& own, const FreeRow& c, i32 q) {
  const Table<f64>& factor = own.of.factor;
  const Span<f64> y = factor.row(q), rates = own.of.rates;
  f64 square = 0.0;
  for (i32 a = 0; a < q; a++) {
    const Span<f64> row = factor.row(a);
    f64 value = normal_times(c, own.of.columns.row(a));
    for (i32 k = 0; k < a; k++) value -= row[k] * y[k];
    value /= row[a];
    y[a] = value;
    square += value * value;
  }
  for (i32 a = q - 1; a >= 0; a--) {
    f64 value = y[a];
    for (i32 k = a + 1; k < q; k++) value -= factor.at(k, a) * rates[k];
    rates[a] = value / factor.at(a, a);
  }
  return square;
}

// Takes active constraint number k out, the column behind the active ones moving up, too; the factor's rows from k on are then void.
static void drop(const Programme& own, i32 k, i32 q) {
  for (i32 a = k; a < q; a++) {
    const Span<f64> column = own.of.columns.row(a), next = own.of.columns.row(a + 1);
    for (i32 v = 0; v < own.of.width; v += 2) pair_at(column, v) = pair_at(next, v);
  }
  for (i32 a = k; a < q - 1; a++) {
    own.active[a] = own.active[a + 1];
    own.multiplier[a] = own.multiplier[a + 1];
  }
}

// Takes a step: the multipliers always, the solution where the new constraint does not depend on the active ones.
static void move(const Programme& own, i32 q, f64 step, bool primal) {
  const Program& of = own.of;
  for (i32 v = 0; primal && v < of.width; v += 2) {
    Pair change = pair_at(of.columns.row(q), v);
    for (i32 a = 0; a < q; a++) change -= of.rates[a] * pair_at(of.columns.row(a), v);
    pair_at(own.x, v) += step * change;
  }
  for (i32 a = 0; a < q; a++) own.multiplier[a] -= step * of.rates[a];
}

// Steps until row c holds; false where it never can.
static bool enforce(Programme& own, i32 c) {
  const FreeRow& row = own.of.rows[c];
  i32 q = own.node.active;
  write_column(own.of, c, q);
  const f64 square = normal_times(row, own.of.columns.row(q));
  f64 added = 0.0;
  f64 slack = slack_of(own, row);
  // With a multiplier of its own already the constraint goes on until it is active, though its slack may be gone with the last step.
  while (slack < -FEASIBLE || added > 0.0) {
    const f64 length = square - find_directions(own, row, q);
    f64 step = INFINITE;
    i32 dropped = -1;
    for (i32 a = 0; a < q; a++) {
      const f64 rate = own.of.rates[a];
      if (rate > NEGLIGIBLE && own.multiplier[a] < step * rate) {
        step = own.multiplier[a] / rate;
        dropped = a;
      }
    }
    const f64 full = length > DEPENDENT * square ? most(-slack, 0.0) / length : INFINITE;
    if (dropped < 0 && full == INFINITE) return slack >= -FEASIBLE;
    const f64 taken = least(step, full);
    move(own, q, taken, full < INFINITE);
    if (full < INFINITE) own.node.cost += taken * length * (0.5 * taken + added);
    added += taken;
    if (full <= step) {
      own.of.factor.at(q, q) = root(length);
      own.active[q] = c;
      own.multiplier[q] = added;
      own.node.active = q + 1;
      return true;
    }
    own.dropped = true;
    drop(own, dropped, q);
    own.node.active = --q;
    factorise(own, dropped, q);
    slack = slack_of(own, row);
  }
  return true;
}

Solved continue_dual(Programme& own, i32 count, i32 first, f64 ceiling) {
  i32 c = first;
  const i32 rounds = 20 * (count - own.of.size) + 100;
  for (i32 round = 0; round < rounds; round++) {
    if (c < 0) {
      c = most_violated(own, count);
      if (c < 0) return Solved::YES;
    }
    if (!enforce(own, c)) return Solved::INFEASIBLE;
    if (own.node.cost >= ceiling) return Solved::TOO_DEAR;
    c = -1;
  }
  return Solved::INFEASIBLE;
}

}  // namespace placement
