// Exact search over the choices: branch only on violated ones, bound by the QP of the rows taken so far.
//
// Root = bounds and fixed rows. At a node one violated choice is branched on: each option appends one row to one axis, and that axis is
// solved on from the parent's active set. What is infeasible or dearer than the incumbent is pruned; ties go to the option that misses
// least, then to the lowest number. The search goes down to the cheapest child, and where there is none to the cheapest open node. A
// placement at which every choice holds must also pass the walk, where one is asked for; what blocks it is widened. The search stops on a
// count of QPs, never on time.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr f64 COST_TOLERANCE = 1e-9;  // a placement is cheaper by more than this

// Finds the cheapest placement of the problem in `work` at which every choice holds.
//
//   engine: the outcome is left in nodes.result, best_cost, best and best_picks.
//   limit: QPs after which to stop; `exhausted` is then 0.
//   ceiling: only placements cheaper than this count.
//   walk: whether doors and use sides must be joined.
//   all: whether all ways to open the walk are tried where it turns a placement down, not the likely ones alone.
void search(const Engine& engine, i64 limit, f64 ceiling, bool walk, bool all = false);

// Tells whether the placement in nodes.positions, rounded to millimetres, is walkable.
bool passes(const Engine& engine);

}  // namespace placement
