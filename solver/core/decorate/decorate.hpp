// One room, top to bottom.
#pragma once

#include "plain/tables.hpp"

namespace decorate {

// What decorates (decorating.hpp: DecoratingHeader and its tables) and a furnished room (room.hpp: RoomHeader, pieces, openings, zones,
// doorways) -> what decorates it: the stream's state at the end, how many things there are, and the things.
Bytes decorate_room(Bytes catalog_rows, Bytes room_rows);

}  // namespace decorate
