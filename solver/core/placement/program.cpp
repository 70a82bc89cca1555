#include "placement/program.hpp"

#include "placement/dual.hpp"

namespace placement {

static f64 metres(i64 mm) { return static_cast<f64>(mm) / 1000; }

bool append_row(const Programs& programs, i64 at, const DifferenceRow& row) {
  const i64 axis = row.axis;
  f64 rest = metres(row.s);
  i64 column_i = -1, column_j = -1;
  if (row.j != ORIGIN && row.i != row.j) {
    column_j = programs.column.at(axis, row.j);
    if (column_j < 0) rest -= programs.value.at(axis, row.j);
  }
  if (row.i != ORIGIN && row.i != row.j) {
    column_i = programs.column.at(axis, row.i);
    if (column_i < 0) rest += programs.value.at(axis, row.i);
  }
  programs.rows.at(axis, 0, at) = column_i;
  programs.rows.at(axis, 1, at) = column_j;
  programs.row_s.at(axis, at) = rest;
  return column_i >= 0 || column_j >= 0 || rest <= FEASIBLE;
}

// Numbers the free variables of an axis and fixes the others.
static void split(const Work& work, const Programs& programs, i64 axis) {
  i64 n = 0;
  for (i64 v = 0; v < work.sizes[axis]; v++) {
    const i64 low = work.low.at(axis, v), high = work.high.at(axis, v);
    programs.value.at(axis, v) = metres(low);
    programs.column.at(axis, v) = low < high ? n : -1;
    if (low < high) {
      programs.bounds.at(axis, 0, n) = metres(low);
      programs.bounds.at(axis, 1, n) = metres(high);
      n++;
    }
  }
  programs.size[axis] = n;
}

// Adds a pull to H and f; where one end is fixed it is an anchor.
static void add_pull(const Programs& programs, const PullRow& pull, const PullCost& cost) {
  const Table<f64> H = programs.inverse.block(pull.axis);
  const Span<f64> f = programs.start.row(pull.axis);
  const Span<f64> value = programs.value.row(pull.axis);
  const f64 w = 2 * cost.weight, offset = cost.offset;
  const i64 a = programs.column.at(pull.axis, pull.i), b = programs.column.at(pull.axis, pull.j);
  if (a >= 0) {
    H.at(a, a) += w;
    f[a] += w * offset;
    if (b < 0) f[a] -= w * value[pull.j];
  }
  if (b >= 0) {
    H.at(b, b) += w;
    f[b] -= w * offset;
    if (a < 0) f[b] -= w * value[pull.i];
  }
  if (a >= 0 && b >= 0) {
    H.at(a, b) -= w;
    H.at(b, a) -= w;
  }
}

// Writes H into `inverse` and f into `start`.
static void write_objective(const Work& work, const Programs& programs, i64 axis) {
  const i64 n = programs.size[axis];
  const Table<f64> H = programs.inverse.block(axis);
  const Span<f64> f = programs.start.row(axis);
  for (i64 a = 0; a < n; a++) {
    f[a] = 0.0;
    for (i64 b = 0; b < n; b++) H.at(a, b) = 0.0;
  }
  for (i64 v = 0; v < work.sizes[axis]; v++) {
    const i64 a = programs.column.at(axis, v);
    if (a >= 0) {
      const f64 weight = work.anchor_weight.at(axis, v);
      H.at(a, a) += 2 * weight;
      f[a] -= 2 * weight * work.anchor_at.at(axis, v);
    }
  }
  for (i64 k = 0; k < work.counts->pulls; k++) {
    if (work.pulls[k].axis == axis) add_pull(programs, work.pulls[k], work.pull_costs[k]);
  }
}

// Inverts H in place (Gauss-Jordan; H is positive definite) and writes the unconstrained optimum to `start`.
static void invert(const Programs& programs, i64 axis) {
  const i64 n = programs.size[axis];
  const Table<f64> A = programs.inverse.block(axis);
  const Span<f64> f = programs.start.row(axis), kept = programs.vectors.row(axis, 0);
  for (i64 k = 0; k < n; k++) {
    f64* row = A.row(k).data;
    const f64 pivot = 1 / row[k];
    row[k] = 1.0;
    for (i64 b = 0; b < n; b++) row[b] *= pivot;
    for (i64 a = 0; a < n; a++) {
      f64* other = A.row(a).data;
      const f64 factor = other[k];
      if (a != k && factor != 0.0) {
        other[k] = 0.0;
        for (i64 b = 0; b < n; b++) other[b] -= factor * row[b];
      }
    }
  }
  for (i64 a = 0; a < n; a++) kept[a] = f[a];
  for (i64 a = 0; a < n; a++) {
    const f64* row = A.row(a).data;
    f64 value = 0.0;
    for (i64 b = 0; b < n; b++) {
      if (row[b] != 0.0) value -= row[b] * kept[b];
    }
    f[a] = value;
  }
}

// The terms' value along an axis at positions, m.
static f64 cost_at(const Work& work, i64 axis, const Table<f64>& positions) {
  f64 total = 0.0;
  for (i64 v = 0; v < work.sizes[axis]; v++) {
    const f64 weight = work.anchor_weight.at(axis, v);
    if (weight > 0.0) {
      const f64 off = positions.at(axis, v) - work.anchor_at.at(axis, v);
      total += weight * off * off;
    }
  }
  for (i64 k = 0; k < work.counts->pulls; k++) {
    const PullRow& pull = work.pulls[k];
    if (pull.axis == axis) {
      const f64 off = positions.at(axis, pull.j) - positions.at(axis, pull.i) - work.pull_costs[k].offset;
      total += work.pull_costs[k].weight * off * off;
    }
  }
  return total;
}

void spread(const Work& work, const Programs& programs, i64 axis, const Span<f64>& x, const Table<f64>& positions) {
  for (i64 v = 0; v < work.sizes[axis]; v++) {
    const i64 column = programs.column.at(axis, v);
    positions.at(axis, v) = column < 0 ? programs.value.at(axis, v) : x[column];
  }
}

bool prepare(const Work& work, const Programs& programs, const Nodes& nodes) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      if (work.low.at(axis, v) > work.high.at(axis, v)) return false;
    }
    split(work, programs, axis);
    write_objective(work, programs, axis);
    invert(programs, axis);
    spread(work, programs, axis, programs.start.row(axis), nodes.positions);
    programs.start_cost[axis] = cost_at(work, axis, nodes.positions);
    programs.fixed_rows[axis] = 0;
  }
  for (i64 k = 0; k < work.counts->rows; k++) {
    i64& count = programs.fixed_rows[work.rows[k].axis];
    if (!append_row(programs, count, work.rows[k])) return false;
    count++;
  }
  return true;
}

}  // namespace placement
