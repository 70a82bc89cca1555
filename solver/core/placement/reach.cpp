#include "placement/reach.hpp"

namespace placement {

constexpr f64 ROUNDING = 1e-7;  // an option is given up only if it misses by more than this, m
constexpr i64 PASSES = 6;  // sweeps over the rows; more would only sharpen the bounds

void propagate(const Programs& programs, i64 axis, i64 count) {
  const i64 n = programs.size[axis];
  const Table<f64> bounds = programs.bounds.block(axis), reach = programs.reach.block(axis);
  const Table<i64> rows = programs.rows.block(axis);
  const Span<f64> s = programs.row_s.row(axis);
  for (i64 v = 0; v < n; v++) {
    reach.at(0, v) = bounds.at(0, v);
    reach.at(1, v) = bounds.at(1, v);
  }
  for (i64 pass = 0; pass < PASSES; pass++) {
    bool changed = false;
    for (i64 r = 0; r < count; r++) {
      const i64 i = rows.at(0, r), j = rows.at(1, r);
      const f64 lowest = (i >= 0 ? reach.at(0, i) : 0.0) + s[r];
      const f64 highest = (j >= 0 ? reach.at(1, j) : 0.0) - s[r];
      if (j >= 0 && reach.at(0, j) < lowest - ROUNDING) {
        reach.at(0, j) = lowest;
        changed = true;
      }
      if (i >= 0 && reach.at(1, i) > highest + ROUNDING) {
        reach.at(1, i) = highest;
        changed = true;
      }
    }
    if (!changed) return;
  }
}

// How far a variable goes: to the least (end 0) or the most (end 1); a fixed one stays.
static f64 end_of(const Programs& programs, i64 axis, i64 end, i64 variable) {
  const i64 column = programs.column.at(axis, variable);
  return column < 0 ? programs.value.at(axis, variable) : programs.reach.at(axis, end, column);
}

bool possible(const Programs& programs, const DifferenceRow& row) {
  if (row.i == row.j) return row.s <= 0;
  f64 room = static_cast<f64>(-row.s) / 1000;
  if (row.j != ORIGIN) room += end_of(programs, row.axis, 1, row.j);
  if (row.i != ORIGIN) room -= end_of(programs, row.axis, 0, row.i);
  return room >= -ROUNDING;
}

}  // namespace placement
