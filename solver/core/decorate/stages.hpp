// How a room is decorated: what lies on things, what hangs on walls, what stands on the floor.
#pragma once

#include "decorate/room.hpp"

namespace decorate {

// Lays the rows of their word on carriers of one word; what lies on several, once on the first that takes it.
void lay(DecoratedRoom& room, Span<i64> carriers);

// Lays the rows of what a piece holds on the boards inside it and in its drawers, from one that is drawn on.
void fill(DecoratedRoom& room, i64 piece);

// Hangs the rows of a piece on the wall behind it; outdoors, and in rooms that are no rectangles, none.
void hang(DecoratedRoom& room, i64 piece);

// Hangs the rows of a room's type on its walls, on the longest that has a place first.
void hang_free(DecoratedRoom& room);

// Puts the rows of the room's type, and those for every indoor room, on its floor.
void stand(DecoratedRoom& room);

}  // namespace decorate
