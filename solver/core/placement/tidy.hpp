// No slivers: gaps too narrow for a hand are closed, or opened for a person to reach in, where all rules and the walk still hold.
//
// A piece slides with all that is attached to it, alone or with what it touches. Whole millimetres; limits are counts.
#pragma once

#include "placement/space.hpp"

namespace placement {

// Slides bodies so that fewer slivers are left.
//
//   desk: its problem is valid and walkable at
//   positions: mm; the slid ones are written there.
//
// Returns by how much the bodies' terms cost more there; at most MOST_COST.
f64 tidy(const Desk& desk, const Table<i64>& positions);

}  // namespace placement
