// A room from what it is to what stands in it: furnished, made (placement/making.hpp), and told as bodies, too.
#pragma once

#include "placement/making.hpp"
#include "plain/told_body.hpp"
#include "rooms/asking.hpp"

namespace rooms {

// What a wanted piece is called by: see furnish::PieceRow.
struct NameRow {
  i64 spec, number, floor_side;
};

// Makes a room. Behind placement's answer: how many names follow, the names, and of each piece that stands its way to stand (with the
// numbers of wanted pieces) and its body; as many as stand.
//
//   type_rows: TypeHeader and its tables (room_type.hpp of furnish).
//   room_rows: RoomHeader, openings, zones, floor before doors (room.hpp of furnish), PlaceHeader, doorways.
//   tidy: whether slivers are tidied away.
//   budget: work that each width of its ways may cost.
Bytes made_room(Bytes type_rows, Bytes room_rows, bool tidy, f64 budget);

}  // namespace rooms
