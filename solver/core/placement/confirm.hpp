// The final problem of a room for a solver outside the core, and what its answer says of the optimum.
//
// Both axes are one problem: minimise 1/2 x'Px + q'x subject to low <= Ax <= high, the choices made as the last search found
// it best. Variables without room to move are left out, and what is known of them goes into the constants. A column is a variable that may
// move, those along x first; a row is a bound of a column, a fixed row or one taken, all along x first. Results are in the arena's top.
#pragma once

#include "placement/settle.hpp"

namespace placement {

// How many numbers follow, columns, rows, entries of P's upper triangle and of A; then by column q and where it was found, by row low,
// high and multiplier; then of P and of A where each column ends, each entry's row, and each entry. Numbers take 8 bytes each.
struct FinalProblem {
  i64 size, columns, rows, squares, entries;
};

FinalProblem* final_problem(const Desk& desk);

// What holds something: a difference row, or a bound as a row to or from the origin; the number of the choice that took it, or -1.
struct HoldingRow {
  DifferenceRow row;
  i64 choice, is_bound;
  f64 per_m;  // what a metre more room would save
};

// What holds at an answer: so many HoldingRow follow.
struct Holding {
  i64 rows;
};

// Says what holds at an answer, its multipliers `y` by row.
Holding* holding(const Desk& desk, const f64* y);

}  // namespace placement
