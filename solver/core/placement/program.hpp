// The quadratic programmes of a problem's two axes: fixed variables taken out, H inverted once, rows over free variables.
//
// minimise the sum of anchors w (p - at)^2 and pulls w (p_j - p_i - offset)^2 along each axis. H is block diagonal (pulls join few
// variables), so that the inversion skips most of it.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Writes row number `at` of its axis, from one over all variables; false where it can never hold.
bool append_row(const Programs& programs, i64 at, const DifferenceRow& row);

// Writes the positions of all variables of an axis from those of the free ones.
void spread(const Work& work, const Programs& programs, i64 axis, const Span<f64>& x, const Table<f64>& positions);

// Builds both programmes; false where bounds or fixed rows can never hold.
bool prepare(const Work& work, const Programs& programs, const Nodes& nodes);

}  // namespace placement
