#include "placement/reach.hpp"

#include "plain/pairs.hpp"

namespace placement {

constexpr f64 ROUNDING = 1e-7;  // an option is given up only if it misses by more than this, m
constexpr i32 PASSES = 2;  // sweeps over the rows; more sharpen the bounds for more than that saves (measured)

void propagate(const Program& program, i32 count) {
  const i32 n = program.size;
  const Span<f64> &least = program.least, &most = program.most;
  for (i32 v = 0; v < program.width; v += 2) {
    pair_at(least, v) = pair_at(program.low, v);
    pair_at(most, v) = pair_at(program.high, v);
  }
  for (i32 pass = 0; pass < PASSES; pass++) {
    bool changed = false;
    for (i32 r = 2 * n; r < 2 * n + count; r++) {
      const auto [i, j, rest] = program.rows[r];
      const f64 lowest = least[i] - rest, highest = most[j] + rest;
      const bool is_higher = least[j] < lowest - ROUNDING, is_lower = most[i] > highest + ROUNDING;
      if (!is_higher && !is_lower) continue;
      if (is_higher && j < n) {
        least[j] = lowest;
        changed = true;
      }
      if (is_lower && i < n) {
        most[i] = highest;
        changed = true;
      }
    }
    if (!changed) return;
  }
}

// A variable's number among the free ones, and where it is if it is fixed.
struct Place {
  i32 column;
  f64 value;
};

static Place place_of(const Program& program, i64 variable) {
  const i64 at = variable == ORIGIN ? program.column.size - 1 : variable;
  return {program.column[at], program.value[at]};
}

bool possible(const Engine& engine, const DifferenceRow& row) {
  if (row.i == row.j) return row.s <= 0;
  const Program& program = engine.programs[row.axis];
  const Place i = place_of(program, row.i), j = place_of(program, row.j);
  const f64 room = static_cast<f64>(-row.s) / 1000 + (program.most[j.column] + j.value) - (program.least[i.column] + i.value);
  return room >= -ROUNDING;
}

}  // namespace placement
