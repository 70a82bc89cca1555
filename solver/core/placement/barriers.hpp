// What no search has to find out: a body that leaves no way past itself parts the room in two.
//
// Where a body is so long that the gaps at its two ends together are narrower than a person, everyone stays on one side of it: the
// side it is used from. So all other use sides, and the doors, lie on that side; each is a fixed row.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Appends a fixed row.
void add_row(const Work& work, const DifferenceRow& row);

// Adds the rows between a new piece, whose parts begin with number `known`, and the pieces before it.
void add_barriers(const Room& room, const Work& work, i64 known);

}  // namespace placement
