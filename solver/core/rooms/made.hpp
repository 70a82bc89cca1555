// A room from what it is to what stands in it: furnished, arranged, put on whole millimetres, tidied, and said in rows.
#pragma once

#include "placement/confirm.hpp"
#include "plain/told_body.hpp"
#include "rooms/asking.hpp"

namespace rooms {

// Why a piece was left out: it certainly cannot stand beside those before it, no place was found for it beside them; an optional one found
// no way to stand, the floor is covered enough, the work was spent.
enum Why : i64 { CANNOT_STAND, NOT_FOUND, NO_WAY, COVERED, SPENT };

// The answer's beginning. How many rows follow of names, of pieces that stand (twice: as they were placed, and as bodies) and of those left
// out, and how many numbers of the final problem (confirm.hpp) follow these.
struct MadeRoom {
  i64 names, placed, left_out, problem;
  i64 failed;    // whether the search found nothing, or what breaks a rule: a fault of ours
  i64 walkable;
  i64 proven, best;
  i64 optimal;   // whether the final problem's optimum is proven
  i64 widened;   // whether what stands is not that optimum: it was found again for a wider person, so that the walk outlasts the snap
  i64 solves;    // QPs
  f64 cost;
  f64 spent;     // work, in QPs of a small room
};

// What a wanted piece is called by: see furnish::PieceRow.
struct NameRow {
  i64 spec, number, floor_side;
};

// A piece that stands. Its footprint is in mm; `way` has the numbers of wanted pieces.
struct PlacedRow {
  i64 piece, rotation, wall;
  Rect footprint;
  furnish::Candidate way;
};

// A piece left out: what it counts, its smallest way to stand, and by wall the longest stretch that is free at its depth and height, mm.
struct LeftOutRow {
  i64 piece, why;
  f64 skip_cost;     // infinite where it is required
  i64 parent, kind;  // of that way
  i64 at_walls;      // whether any of its ways is at a wall
  i64 free[4];
};

// Makes a room.
//
//   type_rows: TypeHeader and its tables (room_type.hpp of furnish).
//   room_rows: RoomHeader, openings, zones, floor before doors (room.hpp of furnish), PlaceHeader, doorways.
//   tidy: whether slivers are tidied away.
//   budget: work that each width of its ways may cost.
Bytes made_room(Bytes type_rows, Bytes room_rows, bool tidy, f64 budget);

}  // namespace rooms
