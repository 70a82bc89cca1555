// The problem of the bodies alone: without the squares of persons, of whom the walk tells whether they can use everything.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Returns a problem with rows and choices of its own, those of persons' squares made void; all else it shares.
Work without_persons(const Work& work);

}  // namespace placement
