// Work space for one room, allocated once, and what the host sees of it.
#pragma once

#include "placement/engine.hpp"
#include "placement/fill.hpp"

namespace placement {

// How large a room's problem may get: variables along an axis, parts, choices, fixed rows, pulls, and so on.
struct Sizes {
  i64 pieces, variables, choices, rows, pulls, walls, doors, decisions, states;
};

// Bounds of what a room's problem can need.
Sizes sizes_of(const Room& room);

// What the host sends: how many rows the room's tables have, and then the tables in the order of `Room`, doorways in place of doors, and
// what `derive` needs in place of what it derives.
struct RoomRequest {
  i64 zones, doors, pieces, sides, candidates, links;
};

// An array of 8-byte numbers that the host sees: where it is, and its shape (columns 0: it has one dimension).
struct Shown {
  i32 address, rows, columns;
};

// What the host sees, in the order of solver/placement/layout.py.
constexpr i32 SHOWN = 34;

// A room's work space with what calls hand over and bring back.
struct Desk {
  Shown shown[SHOWN];
  Engine engine;
  Decisions decisions;
  Span<i64> fates;
  Span<i64> limits, group, report;
  Rows<DifferenceRow> taken;  // what `find_taken` found
  Span<f64> added;  // what tidying costs
};

// A room that was sent, and the doorways of its doors.
struct SentRoom {
  Room room;
  Span<Doorway> doorways;
};

// Reads a room that was sent, where it lies.
SentRoom room_of(RoomRequest* request);

// Returns space for a room, and the room in it.
Desk* new_desk(const Room& room, const Sizes& sizes);

}  // namespace placement
