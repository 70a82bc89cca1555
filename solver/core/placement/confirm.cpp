#include "placement/confirm.hpp"

#include "plain/lists.hpp"
#include "plain/tables.hpp"

namespace placement {

// Rows taken with more slack than this at the search's optimum, mm, are left out: they cannot bind at the same optimum, and whatever the
// solver returns is snapped and checked against all of them.
constexpr f64 NEAR_MM = 50;
constexpr f64 ACTIVE = 1e-6;  // a row with less slack, m, holds what it is about; a multiplier above it is one
constexpr i64 NONE = -1;

// A row between two columns, or NONE: value of `after` less that of `before`, m.
struct FinalRow {
  DifferenceRow row;
  i64 choice, before, after;
  f64 low, high;

  f64 at(const f64* x) const { return (after == NONE ? 0.0 : x[after]) - (before == NONE ? 0.0 : x[before]); }
};

// p_j - p_i: the columns of those that may move, and what the others are, m.
struct Difference {
  i64 before, after;
  f64 rest;
};

// One axis of the problem; the first `columns` rows are the bounds.
struct FinalAxis {
  i64 axis;
  i32 columns;
  Span<i64> column;  // by variable, or NONE
  Span<f64> start, linear;
  Table<f64> squares;
  List<FinalRow> rows;
};

static Difference difference(const Work& work, const FinalAxis& own, i64 i, i64 j) {
  Difference found = {NONE, NONE, 0.0};
  if (i == j) return found;
  if (i != ORIGIN) {
    found.before = own.column[i];
    if (found.before == NONE) found.rest -= static_cast<f64>(work.low.at(own.axis, i)) / 1000;
  }
  if (j != ORIGIN) {
    found.after = own.column[j];
    if (found.after == NONE) found.rest += static_cast<f64>(work.low.at(own.axis, j)) / 1000;
  }
  return found;
}

// Adds weight (p_j - p_i - offset)^2.
static void add_square(const Work& work, const FinalAxis& own, i64 i, i64 j, const PullCost& cost) {
  const auto [before, after, rest] = difference(work, own, i, j);
  const i64 columns[] = {before, after};
  const f64 signs[] = {-1.0, 1.0};
  for (i32 k = 0; k < 2; k++) {
    if (columns[k] == NONE) continue;
    own.linear[columns[k]] += 2 * cost.weight * signs[k] * (rest - cost.offset);
    for (i32 l = 0; l < 2; l++) {
      if (columns[l] != NONE) own.squares.at(columns[k], columns[l]) += 2 * cost.weight * signs[k] * signs[l];
    }
  }
}

static void add_row(const Work& work, FinalAxis& own, const DifferenceRow& row, i64 choice) {
  if (row.axis != own.axis) return;
  const auto [before, after, rest] = difference(work, own, row.i, row.j);
  if (before == NONE && after == NONE) return;
  own.rows.add({row, choice, before, after, static_cast<f64>(row.s) / 1000 - rest, INFINITE});
}

static void add_bounds(const Desk& desk, FinalAxis& own) {
  const Work& work = desk.engine.work;
  for (i32 v = 0; v < own.column.size; v++) {
    if (own.column[v] == NONE) continue;
    const i64 low = work.low.at(own.axis, v), high = work.high.at(own.axis, v);
    own.start[own.column[v]] = desk.engine.nodes.best.at(own.axis, v);
    own.rows.add({{own.axis, ORIGIN, v, low}, NONE, NONE, own.column[v], static_cast<f64>(low) / 1000, static_cast<f64>(high) / 1000});
  }
}

static void add_terms(const Work& work, const FinalAxis& own) {
  for (i32 v = 0; v < own.column.size; v++) {
    const f64 weight = work.anchor_weight.at(own.axis, v);
    if (weight > 0) add_square(work, own, ORIGIN, v, {work.anchor_at.at(own.axis, v), weight});
  }
  for (i64 k = 0; k < work.counts->pulls; k++) {
    const PullRow& pull = work.pulls[k];
    if (pull.axis == own.axis) add_square(work, own, pull.i, pull.j, work.pull_costs[k]);
  }
}

// How far a row is satisfied at the search's optimum, mm.
static f64 slack_of(const Nodes& nodes, const DifferenceRow& row) {
  const f64 after = row.j == ORIGIN ? 0.0 : nodes.best.at(row.axis, row.j) * 1000;
  const f64 before = row.i == ORIGIN ? 0.0 : nodes.best.at(row.axis, row.i) * 1000;
  return after - before - static_cast<f64>(row.s);
}

static FinalAxis lay_axis(const Desk& desk, const Span<DifferenceRow>& taken, i64 axis) {
  const Work& work = desk.engine.work;
  FinalAxis own = {};
  own.axis = axis;
  own.column = reserved<i64>(static_cast<i32>(work.sizes[axis]));
  for (i32 v = 0; v < own.column.size; v++) own.column[v] = work.low.at(axis, v) < work.high.at(axis, v) ? own.columns++ : NONE;
  own.start = reserved<f64>(own.columns);
  own.linear = zeroes<f64>(own.columns);
  own.squares = {zeroes<f64>(own.columns * own.columns).data, own.columns, own.columns};
  add_bounds(desk, own);
  add_terms(work, own);
  for (i64 k = 0; k < work.counts->rows; k++) add_row(work, own, work.rows[k], NONE);
  for (i32 k = 0; k < taken.size; k++) {
    if (slack_of(desk.engine.nodes, taken[k]) <= NEAR_MM) add_row(work, own, taken[k], k);
  }
  return own;
}

// The rows' multipliers at the search's optimum: each goes to the first row between the same columns that binds there.
static Span<f64> multipliers_of(const Nodes& nodes, const FinalAxis& own) {
  const Span<f64> values = zeroes<f64>(own.rows.size());
  for (i64 n = 0; n < nodes.result->forces; n++) {
    const ForceRow& force = nodes.best_forces[n];
    if (force.axis != own.axis) continue;
    i32 k = 0;
    for (; k < own.rows.size(); k++) {
      const FinalRow& row = own.rows[k];
      if (row.before == force.i && row.after == force.j && row.at(own.start.data) - row.low <= ACTIVE) break;
    }
    if (k < own.rows.size()) {
      values[k] -= nodes.best_multipliers[n];
    } else if (force.j == ORIGIN && force.i != ORIGIN && own.rows[force.i].high - own.start[force.i] <= ACTIVE) {
      values[force.i] += nodes.best_multipliers[n];
    }
  }
  return values;
}

struct Entries;

// Numbers one behind the other.
class Numbers {
 public:
  void add(i64 value) { all_.add(value); }
  void add(f64 value) { all_.add(__builtin_bit_cast(i64, value)); }
  void add(const Span<f64>& values) {
    for (const f64 value : values) add(value);
  }
  void add(const Numbers& others) { all_.add_all(others.all_.all()); }
  void add(const Entries& matrix);
  i32 size() const { return all_.size(); }
  i64* begin() const { return all_.begin(); }

 private:
  List<i64> all_;
};

// A matrix given by its entries, column by column: where each column ends, and each entry's row and value.
struct Entries {
  Numbers ends, rows, values;

  void add(i64 row, f64 value) {
    rows.add(row);
    values.add(value);
  }
  void end_column() { ends.add(static_cast<i64>(rows.size())); }
};

void Numbers::add(const Entries& matrix) {
  add(matrix.ends);
  add(matrix.rows);
  add(matrix.values);
}

static void add_upper_squares(Entries& into, const FinalAxis& own, i64 first) {
  for (i32 column = 0; column < own.columns; column++) {
    for (i32 row = 0; row <= column; row++) {
      if (own.squares.at(row, column) != 0) into.add(first + row, own.squares.at(row, column));
    }
    into.end_column();
  }
}

static void add_differences(Entries& into, const FinalAxis& own, i64 first) {
  for (i32 column = 0; column < own.columns; column++) {
    for (i32 k = 0; k < own.rows.size(); k++) {
      if (own.rows[k].before == column) into.add(first + k, -1.0);
      if (own.rows[k].after == column) into.add(first + k, 1.0);
    }
    into.end_column();
  }
}

FinalProblem* final_problem(const Desk& desk) {
  const Span<DifferenceRow> taken = find_taken(desk);
  const FinalAxis axes[] = {lay_axis(desk, taken, 0), lay_axis(desk, taken, 1)};
  Entries squares, differences;
  i64 columns = 0, rows = 0;
  for (const FinalAxis& own : axes) {
    add_upper_squares(squares, own, columns);
    add_differences(differences, own, rows);
    columns += own.columns;
    rows += own.rows.size();
  }
  Numbers all;
  const i64 head[] = {0, columns, rows, squares.rows.size(), differences.rows.size()};
  for (const i64 number : head) all.add(number);
  for (const FinalAxis& own : axes) all.add(own.linear);
  for (const FinalAxis& own : axes) all.add(own.start);
  for (const FinalAxis& own : axes) {
    for (const FinalRow& row : own.rows) all.add(row.low);
  }
  for (const FinalAxis& own : axes) {
    for (const FinalRow& row : own.rows) all.add(row.high);
  }
  for (const FinalAxis& own : axes) all.add(multipliers_of(desk.engine.nodes, own));
  all.add(squares);
  all.add(differences);
  all.begin()[0] = all.size();
  return reinterpret_cast<FinalProblem*>(all.begin());
}

// Adds what holds along one axis.
static void add_holding(const Work& work, const FinalAxis& own, const f64* y, List<HoldingRow>& holding) {
  for (i32 k = 0; k < own.rows.size(); k++) {
    const FinalRow& row = own.rows[k];
    const bool is_bound = k < own.columns;
    if (y[k] < -ACTIVE) {
      holding.add({row.row, row.choice, is_bound, -y[k]});
    } else if (y[k] > ACTIVE && is_bound) {
      holding.add({{own.axis, row.row.j, ORIGIN, -work.high.at(own.axis, row.row.j)}, NONE, 1, y[k]});
    }
  }
}

Holding* holding(const Desk& desk, const f64* y) {
  List<HoldingRow> found;
  const Span<DifferenceRow> taken = find_taken(desk);
  for (i64 axis = 0; axis < 2; axis++) {
    const FinalAxis own = lay_axis(desk, taken, axis);
    add_holding(desk.engine.work, own, y, found);
    y += own.rows.size();
  }
  const i64 count = found.size();
  Writer writer(static_cast<i64>(sizeof(Holding)) + bytes_of(found.all()));
  writer.put(Span<const i64>{&count, 1});
  writer.put(found.all());
  return reinterpret_cast<Holding*>(writer.written().data);
}

}  // namespace placement
