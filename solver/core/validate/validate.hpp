// The stage's answers: of a room what in it breaks a rule, of a storey where one can walk in it, and measures.
#pragma once

#include "plain/tables.hpp"

namespace validate {

// Each takes rows of room.hpp or walk.hpp and answers with rows in the arena; solver/validator writes and reads them.

// A storey, and the numbers of its rooms that are to be judged, 8 bytes each -> in 8 bytes each how many tiles and cells its floor has,
// whether there is floor that one can come to, how many rooms were judged, and how many looks that took; for each room two areas, the free
// centres that can be come to and all of them; of each room judged how much is told; what breaks a rule in them, rows of `Finding`: of
// bodies, and then of the plan; rows of `Opened`; and for all bodies of the storey in turn a byte: 0, but where it is used from sides and
// not enough of them can be come to 16, and 1, 2, 4, 8 for each of these that can: to the north, south, east, west. After one finding above
// `most`, or more than `most_looks`, nothing more is judged.
Bytes judge_storey(Bytes storey, Bytes asked, i64 most, i64 most_looks);

// A storey -> how many rectangles the free floor of each room has, how many squares its doors and passages, and how many strips its windows
// keep free, 8 bytes each; then of each room all of them.
Bytes free_floors(Bytes storey);

// A storey -> for each room four areas: between its wall lines, clear of walls, that without what bodies cover, all without what furniture
// on the floor covers.
Bytes measure_storey(Bytes storey);

}  // namespace validate
