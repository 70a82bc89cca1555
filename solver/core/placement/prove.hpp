// Whether decided pieces can be used together at all: branch and bound over where they stand, in whole millimetres.
//
// A node holds an interval for every variable. Rows and choices narrow it; where a body covers floor wherever in its interval it
// stands, that floor is certainly taken. If the rest has no component that meets all doors and use sides and is large enough, nobody
// can walk in any placement of the node. A node that is left is parted: by a choice, then by the widest interval.
#pragma once

#include "placement/engine.hpp"

namespace placement {

enum class Verdict : i32 { UNKNOWN, IMPOSSIBLE, POSSIBLE };

// Space for the open nodes of a proof.
struct ProofNodes {
  Cube<i64> low, high;  // by node: the variables' intervals
  Table<i64> picks;  // by node and choice: the option it took, or what is below
  Table<i64> refused;  // by node and choice: bits of the options that do not hold
};

// Proves that the assembled pieces, with persons' squares at their use sides, cannot be used together, or finds where they can.
//
//   allowed: nodes that may still be looked at; counted down.
//
// POSSIBLE leaves a walkable placement in grid.positions.
Verdict prove(const Engine& engine, const ProofNodes& nodes, i64& allowed);

}  // namespace placement
