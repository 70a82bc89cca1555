// What a room of a type wants: pieces with their candidates and links.
#pragma once

#include "plain/tables.hpp"

namespace furnish {

// A room type (room_type.hpp: TypeHeader and its tables) and a room (room.hpp: RoomHeader, openings, zones) -> the rows of what it wants,
// in the arena: the stream's state and the counts of what follows, then how many of each piece, pieces, candidates, links.
Bytes furnish_room(Bytes type_rows, Bytes room_rows);

}  // namespace furnish
