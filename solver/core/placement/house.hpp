// The final problems of a house's rooms as one block-diagonal problem, as a solver outside the core takes it, and what its answer says of
// each room's optimum.
#pragma once

#include "placement/confirm.hpp"

namespace placement {

// A house's problem: the parts of FinalProblem, of all rooms one behind the other, then the matrices' indices as 32-bit numbers. Behind
// these numbers: q and where the optimum was found, by column; low, high and multiplier by row; P's entries and A's. Then as i32: where
// each column of P begins and the last ends, its entries' rows; the same of A. `bytes` is all of that.
struct HouseProblem {
  i64 bytes, columns, rows, squares, entries;
};

// How exactly an answer is a room's optimum.
struct Judgement {
  f64 broken;  // by how much it breaks a row, m
  f64 drawn;  // by how much anything is still drawn, m^-1
  f64 gap;  // by how much its cost and the dual's value differ
  f64 moved;  // how far it is from where the optimum was found, m
};

// Joins the problems that lie at some addresses, one a room.
HouseProblem* join(const Span<const i64>& problems);

// Judges an answer: `x` by column, m, `y` by row. One row a room.
Judgement* judge(const Span<const i64>& problems, const f64* x, const f64* y);

}  // namespace placement
