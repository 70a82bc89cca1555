// What facing, near and far_from have in common: the openings they name, and the cost of being too far from or too near to them.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

bool names_opening(Span<Name> names);
// The openings of a room that `names` has, in their order, or the doors.
List<Opened> openings_named(const Scope& scope, Span<Name> names, bool doors);

// Which way off the wished distance costs.
enum class Off : i32 { beyond = 1, shortfall = -1 };

// Measures from the middles of the openings that `names` has, or of the doors; nothing where the room has none.
void measure_from(const Subject& subject, Span<Name> names, bool doors, Effect& effect);

// What a candidate costs that is off the wished distance, mm, to the nearest of what is measured from.
f64 off_distance(const Subject& subject, const Effect& effect, const Candidate& candidate, i64 usual, Off which);

}  // namespace furnish
