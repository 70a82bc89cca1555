// What openings are cut into: typed rooms, the walls they share and those that lie outside.
#pragma once

#include "plain/lists.hpp"
#include "plain/rects.hpp"
#include "plain/tables.hpp"

namespace openings {

// Least wall between two openings.
constexpr i64 JAMB_MM = 100;
// What a place costs: a leaf that meets a leaf or another door's square, or two openings in one place; two doors' squares that overlap in a
// furnished room; too little wall beside a latch; a place other than the middle.
constexpr f64 COLLISION = 1000.0, CROWDED = 10.0, CORNERED = 20.0, SHIFTED = 0.5;
// Distance of the places tried along a wall.
constexpr i64 STEP_MM = 100;
constexpr i64 NONE = -1;

// What a room is, as bits of `HouseRoom::is`.
enum Trait : i64 {
  HALLWAY = 1,
  PASSAGE = 2,  // between two of these an opening has no leaf
  SWINGS_IN = 4,
  MUST_SWING_OUT = 8,
  OUTDOOR = 16,
  WINDOWS = 32,
  HABITABLE = 64,
  SMALL_PANES = 128,
  LATCHES = 256,  // wall beside latches is asked for in it
};

// A wall that a room keeps whole, mm; `across` is 0 where it faces none.
struct Wish {
  i64 length, depth, under_windows, round_corners, across;
};

// A room as the host sends it; `cars` is how many a garage door is to be wide, 0 without one.
struct HouseRoom {
  Rect rect;
  i64 is, cars;
  i32 first_wish, wishes;
  i32 first_stretch, stretches;

  bool has(i64 traits) const { return (is & traits) == traits; }
};

// A part of a room's wall that lies outside.
struct Stretch {
  i64 wall;
  Interval over;
};

// A wall that two rooms share and get a door in; `wall` is that of `a`, `entered` the room that the door is for.
struct Joint {
  i64 a, b, wall;
  Interval over;
  i64 entered;

  i64 length() const { return over.high - over.low; }
  i64 other(i64 room) const { return room == a ? b : a; }
};

enum class CutKind : i64 { door, passage, window, garage_door };

// An opening: `room` and `wall` say where, `other` is the room on the other side, NONE for outside; `leaf` is the room whose floor a door's
// leaf sweeps, NONE for no floor of the house.
struct Cut {
  CutKind kind;
  i64 number, room, wall, other, centre, width, leaf, main;

  bool operator==(const Cut&) const = default;
  bool is_same(const Cut& cut) const { return kind == cut.kind && number == cut.number; }
  bool has_square() const { return kind == CutKind::door || kind == CutKind::passage; }
  Interval ends() const { return {centre - width / 2, centre + width / 2}; }
  Cut at(i64 place) const {
    Cut moved = *this;
    moved.centre = place;
    return moved;
  }
  Wall wall_of(i64 seen_from) const { return seen_from == room ? static_cast<Wall>(wall) : opposite(static_cast<Wall>(wall)); }
};

// What the host sends first; rooms, wishes, stretches, joints and openings that are there follow.
struct Header {
  i32 rooms, wishes, stretches, joints, cuts;
  i32 latch;  // wall from a door's latch to the next line of its rooms that ask for it, mm; 0 none
  i64 jamb, least_jamb, hallway;  // of walls as thick as these
  i64 leaf, entrance;             // widths of doors
  i64 entrance_room, entrance_wall;
};

struct House {
  Header header;
  Span<HouseRoom> rooms;
  Span<Wish> wishes;
  Span<Stretch> stretches;
  Span<Joint> joints;
  Span<Cut> cuts;

  Span<Stretch> outside(i64 room) const { return part_of(stretches, {rooms[room].first_stretch, rooms[room].stretches}); }
  // The stretch of an outside wall that a point of it lies in, if any.
  const Stretch* stretch_at(i64 room, i64 wall, i64 centre) const;
  // The wall that an opening between two rooms may stand in, if there is one.
  const Joint* joint_of(const Cut& cut) const;
};

House read(Bytes sent);

// Cuts doors, passages, garage doors and windows; the answer is the openings in their order.
Bytes open_walls(Bytes request);

// Where else in its wall the last of the openings could stand: its ends first, then its quarters, then every STEP_MM.
Bytes door_places(Bytes request);

}  // namespace openings
