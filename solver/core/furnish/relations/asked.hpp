// A relation that somebody asks for: it holds or does not. Where it holds, in the room or at another piece, and what tells whether it does.
#pragma once

#include "furnish/subject.hpp"

namespace furnish {

// How exactly a relation is meant, mm. Still there is what is `nearly` from a corner or a middle, `flush` out of line with another's back
// or front, `inside` within any other bound; two pieces side by side share at least so many halves of the shorter one's length.
struct Tolerance {
  i64 nearly, flush, inside, shared_halves;
  bool judged;
};
// What looks best; where a piece is sent so that it surely holds, a little inside what holds; what holds in a finished room.
constexpr Tolerance EXACT{0, 0, 0, 2, false}, SOUGHT{80, 0, 6, 1, false}, HELD{100, 100, 0, 1, true};

// A coordinate without an end, doubled.
constexpr i64 NO_END = 200'000;
constexpr Interval ANYWHERE{-NO_END, NO_END};

// Where a centre may lie in another piece's frame, doubled: across (right +x) and along (front +z).
struct DoubleBox {
  Interval across, along;
  i64 level = -1;        // the surface there, by its place among the other's
  bool is_seat = false;  // its middle looks best
};

// A relation, the sides and names it gives, and how exactly it is meant.
struct Asked {
  const Rule& rule;
  Span<Side> sides;
  Span<Name> of;
  Tolerance tolerance;
};

// A stance of a piece in a room: how it is turned, the wall at its back, its extents there, and where its footprint may be, or is.
struct Footing {
  const Asked& asked;
  const Scope& scope;
  i32 rotation;
  Wall wall;
  Extent extent;
  Rect reach;

  // Across the wall at its back: how far its reach is from a point.
  i64 off_wall(Point at) const;
};

// What of the floor around another piece is for one of those that stand there: a part of a side, doubled.
struct Setting {
  bool is_laid = false;
  Side side = Side::front;
  i64 middle = 0, half = 0;
};

// A relation between two pieces: the other's extents, the own ones in the other's frame, and the own rotation there.
struct Fit {
  const Asked& asked;
  Extent parent, own;
  i32 turn;
  i64 height;                         // the own one
  Span<Level> levels;                 // of the other
  Span<PartBox> parent_parts, parts;  // what can be in each other's way where the one reaches under the other
  Setting setting;

  // Twice the distance of the centres where the pieces touch.
  Extent touching() const { return {parent.x + own.x, parent.z + own.z}; }
  // What is added to a least distance that is sought, doubled: halves of odd extents are rounded.
  i64 spare() const { return 2 * least<i64>(1, asked.tolerance.inside); }
};

// A body in a finished room.
struct Standing {
  Rect rect;
  i32 rotation;
  bool rests;  // on a surface of the other

  // Twice the way to its centre from that of another body.
  Point double_way_from(const Standing& other) const {
    return {rect.x0 + rect.x1 - other.rect.x0 - other.rect.x1, rect.z0 + rect.z1 - other.rect.z0 - other.rect.z1};
  }
};

// The whole millimetres whose doubles are within a distance of a doubled middle.
constexpr Interval about(i64 doubled_middle, i64 doubled_half) {
  return {-floor_div(doubled_half - doubled_middle, 2), floor_div(doubled_middle + doubled_half, 2)};
}
// The same of floats.
inline Interval about(i64 middle, f64 half) {
  return {whole(-floor(-(static_cast<f64>(middle) - half))), whole(floor(static_cast<f64>(middle) + half))};
}

// What Python asks (solver/relations/held.py): whether a relation holds.
bool relation_holds(Bytes asked, bool in_room);
// The usual distance, mm, and behind it a bit for each of what a relation is.
i64 relation_traits(Word word);

}  // namespace furnish
