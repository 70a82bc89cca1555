// From decisions to a problem: what each piece adds, and the choices between its parts and those before.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Writes the problem of the decisions; false where the bounds alone rule them out. Unless all of it is asked for, it is also given up at
// the first piece that they leave no way to keep apart.
//
// A piece whose parent is absent is an error of the caller. Choices that the bounds settle are left out. What the last problem
// began with in the same way is kept.
bool assemble(const Room& room, const Work& work, const Decisions& decisions, bool all = true);

// Tells whether all variables have a place within their bounds.
bool bounds_hold(const Work& work);

}  // namespace placement
