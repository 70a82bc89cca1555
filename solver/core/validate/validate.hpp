// The stage's answers: of a room what in it breaks a rule, of a storey where one can walk in it, and measures.
#pragma once

#include "plain/memory.hpp"

namespace validate {

struct Bytes {
  u8* data;
  i64 size;
};

// Each takes rows of room.hpp or walk.hpp and answers with rows in the arena; solver/validator writes and reads them.

// A storey, and which of its rooms are to be judged, each with what stands around it and its fronts -> in 8 bytes each how many tiles and
// cells its floor has, whether there is floor that one can come to, and how many rooms were judged; for each room two areas, the free
// centres that can be come to and all of them; of each room judged how much is told; what breaks a rule in them, rows of `Finding`, no
// more than one above `most`, with which judging ends; rows of `Opened` of their fronts; and for all bodies of the storey in turn a byte:
// 1, 2, 4, 8 where the north, south, east, west side can be come to.
Bytes judge_storey(Bytes storey, Bytes asked, i64 most);

// A storey -> how many rectangles the free floor of each room has, 8 bytes each; then all of them.
Bytes free_floors(Bytes storey);

// A storey -> for each room four areas: between its wall lines, clear of walls, that without what bodies cover, all without what furniture
// on the floor covers.
Bytes measure_storey(Bytes storey);

}  // namespace validate
