// Drafts of homes: rooms dealt to the columns of strips, and the rectangles that come of them. All lengths are mm.
//
// A strip runs along u and is its depth across, v; a column's first room lies at the hallway (at the inner line, where there is none).
// `rows`, `ranch` and `full` have u = x and the street at the end of v; `axial` has u = z and the street at the end of u.
//
//   rows   strip | strip                      full    strip | hallway | strip
//   ranch  (strip | strip) beside (strip | hallway | strip)
//   winged a ranch with a second (strip | hallway | strip) at the other end
//   axial  strip, strip along a hallway from the back to the entry at the street
#pragma once

#include "homes/widths.hpp"
#include "plain/rects.hpp"

namespace homes {

enum class Kind : i32 { rows = 0, full = 1, ranch = 2, axial = 3, winged = 4, given = 5 };
enum class Outline : i32 { rectangle = 0, l = 1, t = 2, u = 3, given = 4 };
// How a home's wings lie: it has none; anywhere; or so that all of a wing's northern (southern) strip juts out, the rest being flush.
enum class Bend : i32 { none = -1, free = 0, north_out = 1, south_out = 2 };

constexpr i32 MOST_STRIPS = 4 * MOST_ROOMS;
// A small part of a home's columns: what is dealt together.
struct Chunk {
  Column columns[MOST_ROOMS];
  i32 size = 0;

  void add(Column column) {
    check_index(size, MOST_ROOMS);
    columns[size++] = column;
  }
  void add(const Chunk& other) {
    for (const Column& column : other.all()) add(column);
  }
  void insert(i32 at, Column column);
  void reverse() {
    for (i32 i = 0, j = size - 1; i < j; i++, j--) swap(columns[i], columns[j]);
  }
  Chunk part(i32 from, i32 to) const;
  Chunk reversed() const;
  Span<const Column> all() const { return {columns, size}; }
};

// A rectangle of a given outline, drawn as a house of a kind: with strips along z if `turned`, from its far end if `mirrored`.
struct Block {
  Rect rect;
  Kind kind;
  bool turned, mirrored;

  i64 along() const { return turned ? rect.depth() : rect.width(); }
  i64 across() const { return turned ? rect.width() : rect.depth(); }
  i32 strips() const { return kind == Kind::ranch ? 4 : 2; }
  // Where a room drawn in a house of these extents comes to lie.
  Rect placed(Rect box) const;
};

// Columns of strips, one strip after the other, and the strips' depths. Strips lie in this order: the northern (western) one before the
// southern (eastern); a ranch has its public pair first. Those of wings begin at the public rooms.
struct Draft {
  Kind kind = Kind::rows;
  Bend bend = Bend::none;
  i32 turn = 0;         // which of several places wings or rows have
  i32 entry = -1;       // the room at an axial hallway's end
  bool apart = false;   // garages lie at the end of the first wing's
  i32 strips = 0;
  i32 columns = 0;
  Span<const Block> blocks = {nullptr, 0};  // the rectangles of a given outline, whose strips follow each other
  Column column[MOST_ROOMS];
  u8 count[MOST_STRIPS];   // columns of a strip
  i64 depth[MOST_STRIPS];

  i32 first(i32 strip) const;
  Span<const Column> in(i32 strip) const { return {column + first(strip), count[strip]}; }
  bool is_empty(i32 strip) const { return count[strip] == 0; }
  void add_strip(Span<const Column> columns, i64 depth);
  void insert(i32 strip, i32 at, Column column);
  Column take(i32 strip, i32 at);
  void turn_round(i32 strip);
  void copy_to(Draft& other) const;
};

// Outer width and depth asked for; 0 where they are chosen to fit.
struct Frame {
  i64 width, depth;
};

// Rectangles of the rooms by index, of the hallways behind them, and the width and depth of all.
struct Sheet {
  Rect boxes[2 * MOST_ROOMS];
  i32 rooms = 0, hallways = 0;
  i64 width = 0, depth = 0;

  void begin(i32 count);
  void add_hallway(const Rect& hallway) {
    check_index(rooms + hallways, 2 * MOST_ROOMS);
    boxes[rooms + hallways++] = hallway;
  }
  Span<const Rect> all() const { return {boxes, rooms + hallways}; }
};

// A draft whose strips do not come out: by how many columns and mm. All 0: it was drawn.
struct Misfit {
  bool fits;
  i64 columns, gap;

  static constexpr Misfit none() { return {true, 0, 0}; }
  static constexpr Misfit by(i64 columns, i64 gap) { return {false, columns, gap}; }
};

}  // namespace homes
