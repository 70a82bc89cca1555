// The quadratic programmes of a problem's two axes: fixed variables taken out, H inverted once, rows over free variables.
//
// minimise the sum of anchors w (p - at)^2 and pulls w (p_j - p_i - offset)^2 along each axis. H is block diagonal (pulls join few
// variables), so that the inversion skips most of it.
#pragma once

#include "placement/dual.hpp"

namespace placement {

inline f64 metres(i64 mm) { return static_cast<f64>(mm) / 1000; }

// Writes a row over all variables of an axis as its row number `at`; false where it can never hold.
inline bool write_row(const Program& program, i32 at, const DifferenceRow& row) {
  const i32 origin = program.column.size - 1;
  i32 i = origin, j = origin;
  if (row.i != row.j) {
    if (row.i != ORIGIN) i = static_cast<i32>(row.i);
    if (row.j != ORIGIN) j = static_cast<i32>(row.j);
  }
  const FreeRow found = {program.column[i], program.column[j], program.value[j] - metres(row.s) - program.value[i]};
  program.rows[at] = found;
  return found.i != found.j || found.rest >= -FEASIBLE;
}

// Adds a row that holds at every node; false where it can never hold.
bool fix_row(const Engine& engine, const DifferenceRow& row);

// Writes the positions of all variables of an axis from those of the free ones.
void spread(const Program& program, const Span<f64>& x, const Span<f64>& positions);

// Builds both programmes; false where bounds or fixed rows can never hold.
bool prepare(const Engine& engine);

}  // namespace placement
