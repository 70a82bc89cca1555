// How far the rows let each variable go, and with that which options of a choice are still possible: no QP is spent on others.
//
// Bound propagation over difference rows, as in disjunctive scheduling (Carlier & Pinson, Management Science 35, 1989).
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Writes to `least` and `most` the positions of an axis's free variables that its first `count` rows behind the bounds leave.
void propagate(Program& program, i32 count);

// Tells whether a row over all variables is within reach.
bool possible(const Engine& engine, const DifferenceRow& row);

}  // namespace placement
