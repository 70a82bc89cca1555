// The rooms of a programme, and what each is to the plan.
#pragma once

#include "homes/widths.hpp"

namespace homes {

// What a room is, as bits of `PlannedRoom::is`.
enum Trait : i64 {
  WAY_THROUGH = 1,
  HABITABLE = 2,
  WET = 4,
  GARAGE = 8,
  DINING = 16,  // one eats at a table there
  BED = 32,
  TOILET = 64,
};

// A room as the host sends it.
struct PlannedRoom {
  RoomSize size;
  i64 is;
  i64 owner;    // the room it belongs to (its bathroom), -1 for all others
  u64 through;  // of a garage, the rooms that are no ways through behind which it may lie, as bits

  bool has(i64 traits) const { return (is & traits) == traits; }
  bool owned() const { return owner >= 0; }
  // One lives in it and walks through it.
  bool living() const { return has(WAY_THROUGH | HABITABLE); }
  // One comes in by it: a way through that is no living space.
  bool entry() const { return has(WAY_THROUGH) && !has(HABITABLE); }
  bool small() const { return has(WET) && !has(HABITABLE); }
};

// Rooms by index.
struct RoomList {
  i32 rooms[MOST_ROOMS];
  i32 size = 0;

  void add(i32 room) { rooms[size++] = room; }
  i32 take() { return rooms[--size]; }
  bool has(i32 room) const {
    for (i32 i = 0; i < size; i++) {
      if (rooms[i] == room) return true;
    }
    return false;
  }
  Span<i32> all() { return {rooms, size}; }
  Span<const i32> all() const { return {rooms, size}; }
};

}  // namespace homes
