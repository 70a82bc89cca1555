// A room as it was asked for, and what is asked of it instead: without a piece, or without walking.
#pragma once

#include "placement/room.hpp"

namespace placement {

// A room, and what its pieces and candidates were numbered in the room first asked for.
struct NumberedRoom {
  Room room;
  Span<i64> pieces, candidates;
};

NumberedRoom numbered(const Room& room);

// Leaves out a piece, and every way to stand that needs it.
NumberedRoom without_piece(const NumberedRoom& from, i64 piece);

// Asks for no use sides and no floor.
NumberedRoom without_walking(const NumberedRoom& from);

}  // namespace placement
