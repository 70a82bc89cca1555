// Where a square can walk on a storey: its centre is free where the square meets no body and no wall.
#pragma once

#include "validate/floor.hpp"
#include "validate/room.hpp"

namespace validate {

constexpr i64 HEADROOM = 2 * PER_METRE;  // what hangs higher is walked under: the height of a door

struct StoreyRow {
  i64 half_wall;
  i64 reach;         // half the square's side, less a step: gaps of exactly the side pass
  i64 deepest_wall;  // so far two rooms' wall lines may lie apart at an opening that goes through both
  i32 rooms, entrances, turns, most_boxes, kinds, unused;
};

// A room and where it lies.
struct Placed {
  Room room;
  i64 x, z;
};

struct Storey {
  i64 half_wall;
  i64 reach;
  i64 deepest_wall;
  i32 most_boxes;
  Span<Rect> entrances;  // a step of floor along every door that one comes in by; none: the largest free floor is come to
  Span<Placed> rooms;
  Span<Rect> bridges;  // floor inside doorways between walls that lie apart
};

struct Walk {
  List<Grid> tiles;
  Span<bool> entered;  // by component: whether one can come to it
};

Storey read_storey(Reader& reader);
Walk walk_of(const Storey& storey);

// The tiles on which a room and its bodies stand or can be touched, of a house of any number.
Walk near(const Walk& walk, const Storey& storey, const Placed& placed);

// The area of a room's free centres: those that can be come to, and all. What lies in doorways does not count.
struct WalkedRoom {
  Area entered;
  Area any;
};
WalkedRoom walked_floor(const Storey& storey, const Walk& walk, const Placed& placed);

// Whether the square can come to touch a side of a box, its centre within the side's extent.
bool touches(const Walk& walk, const Rect& box, Wall side, i64 reach);

// What is said of how a body is used: 0 where enough of its use sides can be come to, else 16 and a bit of each wall that those which can
// be come to look to.
u8 missed_sides(const Storey& storey, const Walk& walk, const Placed& placed, const Body& body);

// What the square sweeps of a room's clear floor, in rectangles that do not overlap.
void find_swept_floor(const Storey& storey, const Walk& walk, const Placed& placed, List<Rect>& found);

}  // namespace validate
