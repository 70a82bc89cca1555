// A run of pieces along one wall, round a corner or at two opposite walls, planned as a whole: counter, sink, stove, refrigerator.
//
// Pieces that are put one by one end at each other's wrong side; so whole runs are drawn by seed, the best of them is varied, and what is
// best of all is taken: nearest to a working triangle, with worktop where it is wanted, and with what is wanted in it.
#pragma once

#include "furnish/candidates.hpp"
#include "furnish/preferences.hpp"

namespace furnish {

// Where each piece of the best run drawn is meant to stand, by its word; `kind` is -1 for what is not in it. Empty where none fits.
Span<Candidate> planned_run(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted,
                            Stream& stream);

}  // namespace furnish
