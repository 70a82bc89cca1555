// Columns of a strip: how wide each may be, exactly, and how a strip's length is shared out among them. All lengths are mm.
//
// A strip has one depth; a column stacks one or more rooms over that depth, all as wide as it.
#pragma once

#include "plain/rects.hpp"
#include "plain/spans.hpp"

namespace homes {

// Lines between rooms fall on multiples of 5 cm: dimensions a person would draw.
constexpr i64 LATTICE_MM = 50;
// Depths that strips may have where nothing else decides them: bit k of a set of them is FIRST_DEPTH_MM + k * DEPTH_STEP_MM.
constexpr i64 FIRST_DEPTH_MM = 2400;
constexpr i64 DEPTH_STEP_MM = 150;
constexpr i32 DEPTHS = 31;
constexpr u64 EVERY_DEPTH = (1ULL << DEPTHS) - 1;

constexpr i32 MOST_ROOMS = 30;
constexpr i32 MOST_STACKED = 3;

// How large a room may be: areas, mm2, short side, extent away from the street, mm, and long side over short.
struct RoomSize {
  i64 least, typical, most;
  i64 width, length;
  f64 aspect;
};

// What thick walls ask for: the width of a hallway between lines, of an axial one, and the shortest shared wall that takes a door.
struct WallSizes {
  i64 hallway, centre, door_wall;
};

// Rooms of a column, the one at the hallway first.
struct Column {
  u8 rooms[MOST_STACKED];
  u8 size;

  static Column of(i32 room) { return {{static_cast<u8>(room)}, 1}; }
  static Column of(i32 first, i32 second) { return {{static_cast<u8>(first), static_cast<u8>(second)}, 2}; }
  bool is(i32 room) const { return rooms[0] == room; }
  void turn() { swap(rooms[0], rooms[size - 1]); }
};

// An interval of widths (or depths) with what is wished; `misses` tells that no width at all would do.
struct WidthRange {
  i64 low, wished, high;
  bool misses;
};

// The length on the lattice that is nearest.
constexpr i64 snapped(i64 length) { return floor_div(length + LATTICE_MM / 2, LATTICE_MM) * LATTICE_MM; }

// The bit of the depth nearest to one, or one past them all.
constexpr i32 place_of(i64 depth) {
  const i64 place = floor_div(depth - FIRST_DEPTH_MM + DEPTH_STEP_MM / 2, DEPTH_STEP_MM);
  return place >= 0 && place < DEPTHS ? static_cast<i32>(place) : DEPTHS;
}

// The depths that are bits, ascending.
struct DepthList {
  i64 depths[DEPTHS];
  i32 size;

  explicit DepthList(u64 bits);
  Span<i64> all() { return {depths, size}; }
};

// The depth among bits that is nearest to one wished, that one itself where it is as good.
i64 nearest(u64 bits, i64 wished);

// Shares a length out among `spans`: everyone starts at what is wished, the difference is spread by slack. Sums are rounded, so that no
// part leaves its interval; where the length lies outside their sums, the parts miss their intervals in proportion. The last part takes
// what is off the lattice.
void shared_out(i64 length, Span<const WidthRange> spans, i64* parts);

// The columns of one programme's rooms.
class Columns {
 public:
  Columns(Span<const RoomSize> sizes, WallSizes walls);

  const WallSizes& walls() const { return walls_; }
  i32 rooms() const { return sizes_.size; }
  const RoomSize& size(i32 room) const { return sizes_[room]; }
  i64 area(const Column& column) const;

  // How wide a column may be in a strip of a depth: the widths at which every room keeps its limits are an interval.
  WidthRange width(const Column& column, i64 depth) const;

  // The depths of a strip at which a column has a width, as bits.
  u64 depths(const Column& column);

  // Shares a column's depth out among its rooms, first to last; the depths add up to it.
  void share_depth(const Column& column, i64 width, i64 depth, i64* parts) const;

 private:
  WidthRange stacked(const Column& column, i64 depth, f64 wished) const;
  bool stands(const Column& column, i64 width, i64 depth) const;

  Span<const RoomSize> sizes_;
  WallSizes walls_;
  Span<u64> known_;  // by first and second room of a column: the depths, and a bit that tells that they are known
};

}  // namespace homes
