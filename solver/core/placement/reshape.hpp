// A room as it was asked for, and what is asked of it instead: without a piece, without walking, or with floor to be kept empty.
#pragma once

#include "placement/room.hpp"

namespace placement {

// A room, and what its pieces and candidates were numbered in the room first asked for; -1 for floor that was added.
struct NumberedRoom {
  Room room;
  Span<i64> pieces, candidates;
};

// Without what is left out already.
NumberedRoom numbered(const Room& room);

// Leaves out a piece, and every way to stand that needs it.
NumberedRoom without_piece(const NumberedRoom& from, i64 piece);

// Asks for no use sides and no floor.
NumberedRoom without_walking(const NumberedRoom& from);

// Asks for floor that bodies keep out of and people do not, before all other pieces, in one of several shapes: they are meant for a person
// of 0.6 m, and `wider` mm wider.
NumberedRoom with_empty_floor(const NumberedRoom& from, i64 wider);

}  // namespace placement
