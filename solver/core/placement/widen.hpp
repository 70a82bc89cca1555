// Where the way is blocked: the pairs that close it become choices again, with the person's width between them.
//
// A link is a pair of inflated boxes (or a box and a wall) that overlap in a rectangle which touches the component entered and
// another one.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Appends the rows that might open the way to `wide`; returns the number of the first. `grid` is as `walkable` left it.
i64 add_wider_rows(const Room& room, const Work& work, const WalkGrid& grid);

}  // namespace placement
