// Candidates that need no other piece: along the clear stretches of each wall, in corners, and free in the room.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

// How many rotations differ: four for what has a front, two for what is only longer one way, else one.
i32 rotation_count(const Kind& kind);

// The candidate with its back at a wall, its middle at a coordinate along it.
Candidate at_wall(const Scope& scope, const RoomType& type, i32 kind, Wall wall, i64 middle, f64 cost);

// The ways a piece may stand by itself, each with its variant's cost. Where no wall has a clear stretch for any variant, every wall is
// tried nevertheless: placement says why it is not there.
List<Candidate> own_candidates(const Subject& subject, const WallOccupancy& walls, Span<Effect> effects);

}  // namespace furnish
