// How far the rows let each variable go, and with that which options of a choice are still possible: no QP is spent on others.
//
// Bound propagation over difference rows, as in disjunctive scheduling (Carlier & Pinson, Management Science 35, 1989).
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr f64 ROUNDING = 1e-7;  // an option is given up only if it misses by more than this, m

// Writes to `least` and `most` the positions of an axis's free variables that its first `count` rows behind the bounds leave.
void propagate(Program& program, i32 count);

// A variable's number among the free ones, and where it is if it is fixed.
struct Place {
  i32 column;
  f64 value;
};

inline Place place_of(const Program& program, i64 variable) {
  const i64 at = variable == ORIGIN ? program.column.size - 1 : variable;
  return {program.column[at], program.value[at]};
}

// Tells whether a row over all variables is within reach.
inline bool possible(const Engine& engine, const DifferenceRow& row) {
  if (row.i == row.j) return row.s <= 0;
  const Program& program = engine.programs[row.axis];
  const Place i = place_of(program, row.i), j = place_of(program, row.j);
  const f64 room = static_cast<f64>(-row.s) / 1000 + (program.most[j.column] + j.value) - (program.least[i.column] + i.value);
  return room >= -ROUNDING;
}

}  // namespace placement
