// One room, top to bottom.
#pragma once

#include "plain/tables.hpp"

namespace dress {

// A dressing (dressing.hpp: DressingHeader and its tables) and a furnished room (room.hpp: RoomHeader, pieces, openings, zones, doorways)
// -> what decorates it: the stream's state at the end, how many things there are, and the things.
Bytes dress_room(Bytes dressing_rows, Bytes room_rows);

}  // namespace dress
