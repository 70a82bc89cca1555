// From a decision to variables, bounds, parts, terms and rows: what a piece adds to a problem.
//
// Rigid companions share their parent's variables, so that nothing has to be searched between them. A stand is a person's square
// before a use side.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Adds a piece at its candidate: its body, the persons' squares of its choice of sides, and the terms of its relations.
void add_piece(const Room& room, const Work& work, i64 piece, i64 candidate, i64 side);

}  // namespace placement
