// The stage's answers: of a room what in it breaks a rule, of a storey where one can walk in it, and measures.
#pragma once

#include "plain/memory.hpp"

namespace validate {

struct Bytes {
  u8* data;
  i64 size;
};

// Each takes rows of room.hpp or walk.hpp and answers with rows in the arena; solver/validator writes and reads them.

// A room -> what in it breaks a rule: rows of `Finding`, no more than one above `most`.
Bytes judge_room(Bytes room, i64 most);

// A storey -> for each room two areas, the free centres that can be come to and all of them; then for all of its bodies in turn a byte: 1,
// 2, 4, 8 where the north, south, east, west side can be come to; at the end, 8 bytes each: how many tiles and cells there are, and whether
// there is floor that one can come to.
Bytes walk_storey(Bytes storey);

// A storey -> how many rectangles the free floor of each room has, 8 bytes each; then all of them.
Bytes free_floors(Bytes storey);

// A storey -> for each room four areas: between its wall lines, clear of walls, that without what bodies cover, all without what furniture
// on the floor covers.
Bytes measure_storey(Bytes storey);

// A room, what stands around it and its fronts -> rows of `Opened`, in their order.
Bytes open_fronts(Bytes room);

}  // namespace validate
