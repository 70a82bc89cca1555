#include "rooms/left_out.hpp"

namespace rooms {

using furnish::Candidate;

// Tells whether a way to stand is smaller than another one: by its footprint, then by width, depth, height.
static bool is_smaller(const WantingRoom& room, const Candidate& a, const Candidate& b) {
  i64 one[3], two[3];
  room.size_of(a, one);
  room.size_of(b, two);
  if (one[0] * one[1] != two[0] * two[1]) return one[0] * one[1] < two[0] * two[1];
  for (i32 k = 0; k < 3; k++) {
    if (one[k] != two[k]) return one[k] < two[k];
  }
  return false;
}

// The longest interval along a wall where a body of that depth and height meets no zone and no piece.
static i64 longest_free(const WantingRoom& room, Wall wall, i64 depth, i64 height, Span<PlacedRow> placed) {
  const Rect& clear = room.scope.clear;
  const Interval whole = clear.along(wall);
  const Rect band = strip(clear, wall, whole, least(depth + room.scope.gap, least(clear.depth(), clear.width())));
  List<Interval> blocked;
  for (const furnish::Zone& zone : room.scope.zones) {
    if (height > zone.above && zone.rect.overlaps(band)) blocked.add(zone.rect.along(wall));
  }
  for (const PlacedRow& one : placed) {
    if (one.way.bottom < height && one.footprint.overlaps(band)) blocked.add(one.footprint.along(wall));
  }
  i64 longest = 0;
  for (const Interval& free : furnish::gaps_between(whole, blocked.all())) longest = most(longest, free.high - free.low);
  return longest;
}

LeftOutRow left_out_row(const WantingRoom& room, i64 piece, Why why, Span<PlacedRow> placed) {
  const Span<Candidate> ways = room.ways_of(static_cast<i32>(piece));
  const Candidate* smallest = &ways[0];
  LeftOutRow row = {};
  row.piece = piece;
  row.why = why;
  const furnish::PieceRow& own = room.wanted.pieces[static_cast<i32>(piece)];
  row.skip_cost = own.required == furnish::REQUIRED ? INFINITE : own.skip_cost;
  bool at_parents = true;  // at one in all ways: else it may stand elsewhere, too
  for (const Candidate& way : ways) {
    if (is_smaller(room, way, *smallest)) smallest = &way;
    row.at_walls |= way.wall != Wall::none;
    at_parents &= way.parent >= 0;
  }
  row.parent = at_parents ? smallest->parent : -1;
  row.kind = smallest->kind;
  i64 size[3];
  room.size_of(*smallest, size);
  for (i32 k = 0; k < 4; k++) row.free[k] = longest_free(room, WALLS[k], size[1], size[2], placed);
  return row;
}

}  // namespace rooms
