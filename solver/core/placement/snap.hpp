// Projection onto whole millimetres: every hard row becomes exactly true in whole numbers.
//
// Difference constraints with whole data have a whole solution whenever they have any. The latest positions come from a backward sweep;
// then every position is rounded, clamped to the latest and pushed forward along the rows. Nothing moves by more than about the rounding.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Writes whole positions, mm, near `positions`, m, at which bounds, fixed rows and the rows taken hold.
//
// Returns whether there are any: what a search found always has them.
bool snap(const Work& work, const Span<DifferenceRow>& taken, const Table<f64>& positions, const Table<i64>& snapped);

}  // namespace placement
