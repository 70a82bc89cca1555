// What a room of a type wants: pieces with their candidates and links.
#pragma once

#include "furnish/comfort.hpp"
#include "furnish/preferences.hpp"
#include "plain/tables.hpp"

namespace furnish {

// What a room wants, and the stream's state at the end.
struct Wanted {
  u64 stream;
  List<CountedPiece> counted;
  WantedRows rows;
};

// Reads a room: RoomHeader, openings, zones, floor before doors (room.hpp).
Scope read_room(Reader& reader, RoomHeader& header);

Wanted wanted_in(const RoomType& type, const RoomHeader& room, const Scope& scope);

// Two numbers of one piece: of a type its place there and how many copies are wanted.
struct CountRow {
  i32 spec;
  i32 copies;
};

// What a stage answers: one number of 8 bytes, how many rows of each table there are, and the tables.
Bytes answer_rows(u64 first, Span<CountRow> counts, const WantedRows& rows);

// A room type (room_type.hpp: TypeHeader and its tables) and a room -> the rows of what it wants, in the arena: the stream's state and the
// counts of what follows, then how many of each piece, pieces, candidates, links.
Bytes furnish_room(Bytes type_rows, Bytes room_rows);

}  // namespace furnish
