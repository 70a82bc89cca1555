// Where the way is blocked: the pairs that close it become choices again, with the person's width between them.
//
// A link is a pair of inflated boxes (or a box and a wall) that overlap. Links that touch one another are a pile, for where one of them
// opens another may still close the way. A link, or a pile, that touches the component entered and another one closes a way; so does
// one that touches a component where something is that must be reached, and another one.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr i64 UNTOLD = -1;  // stands for ways to open it that no row tells, and for rows that `wide` has no room for

// The number of a row among those of `wide`, to which it is added where it was not asked for before.
i64 wide_number(const Work& work, const DifferenceRow& row);

// The numbers among `wide`, in the arena, of rows that may open the way. `grid` is as `walkable` left it.
//
//   all: whether one of them must hold wherever the way is open; else only links that open it by themselves count.
Span<i64> wider_rows(const Room& room, const Work& work, const WalkGrid& grid, bool all);

}  // namespace placement
