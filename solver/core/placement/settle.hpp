// From positions in metres to whole millimetres: the snap, an exact check, the walk, and tidying.
#pragma once

#include "placement/space.hpp"

namespace placement {

// What becomes of positions: the last two are never said of what a search found.
enum class Settled : i32 { not_walkable = 0, walkable = 1, no_whole_place = 2, not_valid = 3 };

// The options that the choices of what the last search found took: the one branched on, else the one that holds with most slack; then
// the wider rows. They are left in desk.taken.
Span<DifferenceRow> find_taken(const Desk& desk);

// Puts what the last search found on whole millimetres.
//
//   walk: whether all is walkable at the search's positions.
//   slide: whether slivers are tidied away.
//
// The result is left in grid.positions, and in desk.added by how much the terms cost more once tidied.
Settled settle(const Desk& desk, bool walk, bool slide);

}  // namespace placement
