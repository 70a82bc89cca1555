#include "placement/house.hpp"

#include "plain/tables.hpp"

namespace placement {

namespace {

// A matrix by columns: where each ends, and each entry's row and value.
struct Columns {
  Span<const i64> ends, rows;
  Span<const f64> values;

  i64 begin(i64 column) const { return column == 0 ? 0 : ends[column - 1]; }
};

// The parts of a final problem.
struct Parts {
  Span<const f64> linear, start, low, high, multipliers;
  Columns squares, differences;
};

// Takes tables of numbers that lie one behind the other.
struct TableReader {
  const i64* at;

  template <class T> Span<const T> take(i64 count) {
    const T* found = reinterpret_cast<const T*>(at);
    at += count;
    return {found, static_cast<i32>(count)};
  }
};

}  // namespace

static const FinalProblem& problem_at(i64 address) { return *reinterpret_cast<const FinalProblem*>(static_cast<unsigned long>(address)); }

static Parts parts_of(const FinalProblem& problem) {
  TableReader from = {reinterpret_cast<const i64*>(&problem + 1)};
  Parts own;
  own.linear = from.take<f64>(problem.columns);
  own.start = from.take<f64>(problem.columns);
  own.low = from.take<f64>(problem.rows);
  own.high = from.take<f64>(problem.rows);
  own.multipliers = from.take<f64>(problem.rows);
  own.squares.ends = from.take<i64>(problem.columns);
  own.squares.rows = from.take<i64>(problem.squares);
  own.squares.values = from.take<f64>(problem.squares);
  own.differences.ends = from.take<i64>(problem.columns);
  own.differences.rows = from.take<i64>(problem.entries);
  own.differences.values = from.take<f64>(problem.entries);
  return own;
}

namespace {

// The house's problem while it is written: what comes next of each part.
class Joined {
 public:
  explicit Joined(const HouseProblem& sizes) {
    Writer writer(sizes.bytes);
    writer.put(Span<const HouseProblem>{&sizes, 1});
    whole_ = reinterpret_cast<HouseProblem*>(writer.written().data);
    linear_ = reinterpret_cast<f64*>(whole_ + 1);
    start_ = linear_ + sizes.columns;
    low_ = start_ + sizes.columns;
    high_ = low_ + sizes.rows;
    multipliers_ = high_ + sizes.rows;
    squares_.values = multipliers_ + sizes.rows;
    differences_.values = squares_.values + sizes.squares;
    i32* index = reinterpret_cast<i32*>(differences_.values + sizes.entries);
    squares_.begins = index;
    squares_.rows = index + sizes.columns + 1;
    differences_.begins = squares_.rows + sizes.squares;
    differences_.rows = differences_.begins + sizes.columns + 1;
    *squares_.begins = *differences_.begins = 0;
  }

  void add(const Parts& room) {
    add_matrix(squares_, room.squares, columns_);
    add_matrix(differences_, room.differences, rows_);
    columns_ += room.linear.size;
    rows_ += room.low.size;
    add_values(linear_, room.linear);
    add_values(start_, room.start);
    add_values(low_, room.low);
    add_values(high_, room.high);
    add_values(multipliers_, room.multipliers);
  }

  HouseProblem* whole() const { return whole_; }

 private:
  struct Matrix {
    f64* values;
    i32* begins;  // where the next column begins
    i32* rows;
  };

  static void add_values(f64*& at, const Span<const f64>& values) {
    for (const f64 value : values) *at++ = value;
  }

  static void add_matrix(Matrix& into, const Columns& own, i64 first_row) {
    const i32 before = *into.begins;
    for (const i64 end : own.ends) *++into.begins = before + static_cast<i32>(end);
    for (const i64 row : own.rows) *into.rows++ = static_cast<i32>(first_row + row);
    add_values(into.values, own.values);
  }

  HouseProblem* whole_;
  i64 columns_ = 0, rows_ = 0;
  f64 *linear_, *start_, *low_, *high_, *multipliers_;
  Matrix squares_, differences_;
};

}  // namespace

HouseProblem* join(const Span<const i64>& problems) {
  HouseProblem sizes = {};
  for (const i64 address : problems) {
    const FinalProblem& room = problem_at(address);
    sizes.columns += room.columns;
    sizes.rows += room.rows;
    sizes.squares += room.squares;
    sizes.entries += room.entries;
  }
  const i64 values = 2 * sizes.columns + 3 * sizes.rows + sizes.squares + sizes.entries;
  sizes.bytes = sizeof(HouseProblem) + 8 * values + 4 * (2 * sizes.columns + 2 + sizes.squares + sizes.entries);
  if (sizes.bytes > 1 << 30) fail(Failure::memory_full);
  Joined joined(sizes);
  for (const i64 address : problems) joined.add(parts_of(problem_at(address)));
  return joined.whole();
}

static Judgement judge_room(const Parts& room, const f64* x, const f64* y) {
  const i32 columns = room.linear.size, rows = room.low.size;
  const Span<f64> squared = zeroes<f64>(columns), drawn = zeroes<f64>(columns), at = zeroes<f64>(rows);
  Judgement found = {};
  f64 worth = 0.0;
  for (i32 column = 0; column < columns; column++) {
    for (i64 k = room.squares.begin(column); k < room.squares.ends[column]; k++) {
      const i64 row = room.squares.rows[k];
      squared[column] += room.squares.values[k] * x[row];
      if (row != column) squared[row] += room.squares.values[k] * x[column];
    }
    for (i64 k = room.differences.begin(column); k < room.differences.ends[column]; k++) {
      at[room.differences.rows[k]] += room.differences.values[k] * x[column];
      drawn[column] += room.differences.values[k] * y[room.differences.rows[k]];
    }
  }
  for (i32 column = 0; column < columns; column++) {
    worth += x[column] * (squared[column] + room.linear[column]);
    found.drawn = most(found.drawn, absolute(drawn[column] + squared[column] + room.linear[column]));
    found.moved = most(found.moved, absolute(x[column] - room.start[column]));
  }
  for (i32 k = 0; k < rows; k++) {
    found.broken = most(found.broken, most(room.low[k] - at[k], at[k] - room.high[k]));
    worth += (y[k] <= 0 ? room.low[k] : room.high[k] == INFINITE ? 0.0 : room.high[k]) * y[k];
  }
  found.gap = absolute(worth);
  return found;
}

Judgement* judge(const Span<const i64>& problems, const f64* x, const f64* y) {
  const Span<Judgement> found = reserved<Judgement>(problems.size);
  for (i32 k = 0; k < problems.size; k++) {
    const FinalProblem& room = problem_at(problems[k]);
    found[k] = judge_room(parts_of(room), x, y);
    x += room.columns;
    y += room.rows;
  }
  return found.data;
}

}  // namespace placement
