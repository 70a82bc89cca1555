#include "placement/program.hpp"

#include "placement/assembly.hpp"
#include "plain/pairs.hpp"

namespace placement {

// Numbers the free variables of an axis, writes their bounds, and fixes the others.
static void split(const Work& work, Program& program, i64 axis) {
  const i32 count = static_cast<i32>(work.sizes[axis]), origin = program.column.size - 1;
  i32 n = 0;
  for (i32 v = 0; v < count; v++) n += work.low.at(axis, v) < work.high.at(axis, v);
  program.variables = count;
  program.size = n;
  program.width = (n + 2) / 2 * 2;
  i32 k = 0;
  for (i32 v = 0; v < count; v++) {
    const f64 low = metres(work.low.at(axis, v)), high = metres(work.high.at(axis, v));
    const bool free = work.low.at(axis, v) < work.high.at(axis, v);
    program.column[v] = free ? k : n;
    program.value[v] = free ? 0.0 : low;
    if (!free) continue;
    program.low[k] = low;
    program.high[k] = high;
    program.rows[2 * k] = {n, k, -low};
    program.rows[2 * k + 1] = {k, n, high};
    k++;
  }
  for (; k < program.width; k++) program.low[k] = program.high[k] = 0.0;
  program.column[origin] = n;
  program.value[origin] = 0.0;
}

// Adds a pull to H and f; where one end is fixed it is an anchor.
static void add_pull(const Program& program, const PullRow& pull, const PullCost& cost) {
  const Table<f64>& H = program.inverse;
  const Span<f64> &f = program.start, &value = program.value;
  const f64 w = 2 * cost.weight, offset = cost.offset;
  const i32 a = program.column[pull.i], b = program.column[pull.j], n = program.size;
  if (a < n) {
    H.at(a, a) += w;
    f[a] += w * offset;
    if (b == n) f[a] -= w * value[pull.j];
  }
  if (b < n) {
    H.at(b, b) += w;
    f[b] -= w * offset;
    if (a == n) f[b] -= w * value[pull.i];
  }
  if (a < n && b < n) {
    H.at(a, b) -= w;
    H.at(b, a) -= w;
  }
}

// Writes H into `inverse` and f into `start`.
static void write_objective(const Work& work, const Program& program, i64 axis) {
  for (i32 a = 0; a <= program.size; a++) {
    const Span<f64> row = program.inverse.row(a);
    for (i32 b = 0; b < program.width; b += 2) pair_at(row, b) = Pair{0.0, 0.0};
  }
  for (i32 b = 0; b < program.width; b += 2) pair_at(program.start, b) = Pair{0.0, 0.0};
  for (i32 v = 0; v < work.sizes[axis]; v++) {
    const i32 a = program.column[v];
    if (a == program.size) continue;
    const f64 weight = work.anchor_weight.at(axis, v);
    program.inverse.at(a, a) += 2 * weight;
    program.start[a] -= 2 * weight * work.anchor_at.at(axis, v);
  }
  for (i64 k = 0; k < work.counts->pulls; k++) {
    if (work.pulls[k].axis == axis) add_pull(program, work.pulls[k], work.pull_costs[k]);
  }
}

// Inverts H in place (Gauss-Jordan; H is positive definite) and writes the unconstrained optimum to `start`.
static void invert(const Program& program) {
  const i32 n = program.size, width = program.width;
  const Span<f64> &f = program.start, &kept = program.least;
  for (i32 k = 0; k < n; k++) {
    const Span<f64> row = program.inverse.row(k);
    const f64 pivot = 1 / row[k];
    row[k] = 1.0;
    for (i32 b = 0; b < width; b += 2) pair_at(row, b) *= pivot;
    for (i32 a = 0; a < n; a++) {
      const Span<f64> other = program.inverse.row(a);
      const f64 factor = other[k];
      if (a == k || factor == 0.0) continue;
      other[k] = 0.0;
      for (i32 b = 0; b < width; b += 2) pair_at(other, b) -= factor * pair_at(row, b);
    }
  }
  for (i32 a = 0; a < n; a++) kept[a] = f[a];
  for (i32 a = 0; a < n; a++) {
    const Span<f64> row = program.inverse.row(a);
    f64 value = 0.0;
    for (i32 b = 0; b < n; b++) value -= row[b] * kept[b];
    f[a] = value;
  }
}

// The terms' value along an axis at positions, m.
static f64 cost_at(const Work& work, i64 axis, const Span<f64>& positions) {
  f64 total = 0.0;
  for (i64 v = 0; v < work.sizes[axis]; v++) {
    const f64 weight = work.anchor_weight.at(axis, v);
    if (weight > 0.0) {
      const f64 off = positions[v] - work.anchor_at.at(axis, v);
      total += weight * off * off;
    }
  }
  for (i64 k = 0; k < work.counts->pulls; k++) {
    const PullRow& pull = work.pulls[k];
    if (pull.axis == axis) {
      const f64 off = positions[pull.j] - positions[pull.i] - work.pull_costs[k].offset;
      total += work.pull_costs[k].weight * off * off;
    }
  }
  return total;
}

void spread(const Program& program, const Span<f64>& x, const Span<f64>& positions) {
  for (i32 v = 0; v < program.variables; v++) positions[v] = x[program.column[v]] + program.value[v];
}

bool fix_row(const Engine& engine, const DifferenceRow& row) {
  Program& program = engine.programs[row.axis];
  return write_row(program, 2 * program.size + program.fixed_rows++, row);
}

bool prepare(const Engine& engine) {
  const Work& work = engine.work;
  if (!bounds_hold(work)) return false;
  for (i64 axis = 0; axis < 2; axis++) {
    Program& program = engine.programs[axis];
    split(work, program, axis);
    write_objective(work, program, axis);
    invert(program);
    const Span<f64> positions = engine.nodes.positions.row(axis);
    spread(program, program.start, positions);
    program.start_cost = cost_at(work, axis, positions);
    program.fixed_rows = 0;
  }
  for (i64 k = 0; k < work.counts->rows; k++) {
    if (!fix_row(engine, work.rows[k])) return false;
  }
  return true;
}

}  // namespace placement
