// Deals the rooms of a programme to the strips of a skeleton, and changes a deal a little. Rooms that belong together are dealt together:
// a bedroom with its own bathroom, the bathroom with what shares its pipes, kitchen, dining and living room.
#pragma once

#include "homes/drafts.hpp"
#include "homes/programme.hpp"
#include "plain/streams.hpp"

namespace homes {

// Depth of a strip of rooms one deep: bedrooms of 11.5 m2 are then 2.7 to 3.5 m wide. And of one that cars stand in.
constexpr Interval STRIP_DEPTHS = {3300, 4350};
constexpr Interval DEEP_DEPTHS = {5400, 6150};
// How often a small wet room is dealt beside the kitchen.
constexpr f64 AT_KITCHEN = 0.85;
// Divided without rest by the numbers of places that wings may have, mostly.
constexpr i32 TURNS = 12;

// Some chunks.
struct ChunkList {
  Chunk all[MOST_ROOMS];
  i32 size = 0;

  Chunk& add() {
    check_index(size, MOST_ROOMS);
    all[size].size = 0;
    return all[size++];
  }
  Span<Chunk> chunks() { return {all, size}; }
};

// The public rooms, with what is dealt beside them, and the private rooms in chunks.
struct Deal {
  Chunk front, living;
  ChunkList apart;
};

// Deals one programme's rooms.
class Dealer {
 public:
  Dealer(Span<const PlannedRoom> rooms, Columns& columns, Stream& stream);

  Span<const i32> garages() const { return garages_.all(); }

  // A draft of a kind in a rectangle.
  void deal(Kind kind, Draft& draft) const;

 protected:
  i64 depth(Interval depths = STRIP_DEPTHS) const;
  i64 deep() const { return depth(garages_.size ? DEEP_DEPTHS : STRIP_DEPTHS); }
  void rows(Draft& draft) const;
  void chunks(bool shallow, const RoomList& without, Deal& deal) const;
  Chunk entry() const;
  bool is_wet(const Column& column) const { return rooms_[column.rooms[0]].has(WET); }
  bool is_bath(i32 room) const { return rooms_[room].has(TOILET); }
  i64 floor_of(Span<const Column> columns) const;
  i32 cut(const Chunk& behind, const i64* depths) const;
  Chunk either(const Chunk& chunk) const { return stream_.chance(0.5) ? chunk.reversed() : chunk; }
  // Largest first.
  void sort(Span<Chunk> chunks) const;

  Span<const PlannedRoom> rooms_;
  Columns& columns_;
  Stream& stream_;
  RoomList entries_, garages_, public_, small_, others_;

 private:
  void beside_kitchen(Chunk& living, RoomList& rooms) const;
  void join(Chunk& suite, Column column) const;
  Chunk suite(i32 room, RoomList& baths, RoomList& others) const;
  i32 own_bath(i32 room) const;
  Chunk living_order() const;
  i64 length(Span<const Column> strip, i64 depth) const { return floor_div(floor_of(strip), depth); }
  void fill(Chunk* strips, const i64* depths, ChunkList& chunks) const;
  bool fits(const Chunk& chunk, i64 depth) const;
  Chunk front() const;
  void dealt(Deal& deal) const;
  Chunk along_street(const Chunk& front, const Chunk& living) const;
  Chunk with_garages(const Chunk& strip) const;
  bool sleeps(const Column& column) const { return !rooms_[column.rooms[0]].small(); }
  void full(Draft& draft) const;
  void axial(Draft& draft) const;
  void ranch(Draft& draft) const;
};

// Deals to an outline that is no rectangle.
class BentDealer : public Dealer {
 public:
  BentDealer(Span<const PlannedRoom> rooms, Columns& columns, Stream& stream, Outline outline)
      : Dealer(rooms, columns, stream), outline_(outline) {}

  void deal(Kind kind, Draft& draft) const;

 private:
  void wings(i32 wings, Draft& draft) const;
  void in_deep_row(Deal& deal) const;
  i32 kitchen_to_wing(Chunk& living, Bend bend, Chunk* strips) const;
  void share(ChunkList& chunks, i32 count, Chunk* strips) const;

  Outline outline_;
};

// Deals to an outline that may be cut into rectangles in several ways. The draft's blocks are in the arena.
class GivenDealer : public Dealer {
 public:
  GivenDealer(Span<const PlannedRoom> rooms, Columns& columns, Stream& stream, Span<const Span<const Rect>> tilings)
      : Dealer(rooms, columns, stream), tilings_(tilings), hallways_(rooms.size - public_.size - entries_.size > 1) {}

  void deal(Draft& draft) const;

 private:
  struct Strips;
  Block block(const Rect& rect) const;
  void measure(Span<const Block> blocks, Strips& strips) const;
  void find_street(Span<const Block> blocks, Strips& strips) const;
  void put_at_street(i32 room, Strips& strips) const;
  void lay(const Chunk& chunk, bool in_open, Strips& strips) const;
  i32 emptiest(bool in_open, const Strips& strips) const;

  Span<const Span<const Rect>> tilings_;
  bool hallways_;
};

// A draft with one thing changed: columns or strips swapped, a stack turned, a column moved, a depth changed.
void move(const Draft& draft, Stream& stream, Draft& moved);

}  // namespace homes
