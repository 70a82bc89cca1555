// From what a room wants to what placement is asked.
#pragma once

#include "furnish/furnish.hpp"
#include "placement/room.hpp"

namespace rooms {

// What Python sends of a room behind what furnish reads; doorways follow.
struct PlaceHeader {
  i64 robot;  // how wide the person is, mm
  i64 cover;  // mm2 of floor to be covered, or 0
  i64 doorways;
};

// A room that is furnished: as it was sent, and what it wants.
struct WantingRoom {
  furnish::RoomType type;
  furnish::Scope scope;
  PlaceHeader header;
  Span<Doorway> doorways;
  furnish::WantedRows wanted;

  // Width, depth and height of what stands that way, mm.
  void size_of(const furnish::Candidate& way, i64 (&size)[3]) const;
};

// The room for its person, whose use sides must all be reached.
placement::Room asked_room(const WantingRoom& room);

}  // namespace rooms
