// Back towards where it was wished: every body as far as all rules and the walk still hold, in whole millimetres.
//
// A walkable placement was found with more kept free than the rules ask: a square at every use side, a piece of floor, a person's
// width between whole pairs. What of that nobody needs is given back here, one body after the other, along both axes at once and
// along each, until nothing moves any more.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Tells whether bounds, rows and choices hold at integer positions, mm.
bool holds(const Work& work, const Table<i64>& positions);

// Brings the bodies of the assembled problem back towards their wishes; what stands free of another stays so.
//
// Integer positions, mm, are in grid.positions; the result is left where a search leaves it. Returns whether all rules and the walk
// held at those positions; if not, nothing is changed. `walks` is how many walks may be tried, and becomes how many are left.
bool pull_back(const Engine& engine, i64& walks);

}  // namespace placement
