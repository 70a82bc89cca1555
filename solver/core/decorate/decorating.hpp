// What the catalogs say of decorations, in one style, as Python compiles it (solver/decorations/decorating.py): rows of plain
// structs; names are words, numbers that stand for equal strings; lengths are mm. The first words are the keys of decorating.yaml.
#pragma once

#include "plain/rects.hpp"
#include "plain/tables.hpp"

namespace decorate {

// In `on`: the parent's own surface; in `surface`: every one of the parent's.
constexpr i32 ITSELF = -1;
constexpr i64 NO_LIMIT = -1;

inline void check(bool right) {
  if (!right) fail(Failure::bad_request);
}

// A surface that carries things: above the underside, in from the footprint's edges; the free height above it, or NO_LIMIT.
struct Surface {
  i64 height;
  i64 left, right, back, front;
  i64 clearance;
  i64 word;
};

struct Size {
  i64 width;
  i64 depth;
  i64 height;
};

// A kind of decoration; `colours` is how many there are to draw from.
struct Kind {
  Size size;
  Range surfaces;
  i32 word;
  i32 colours;
  i32 jitter;
  i32 mixed;
};

// A kind that a row may put, and the sizes it may have there, largest first.
struct Choice {
  i32 kind;
  i32 unused;
  Range sizes;
};

// What every row says. `always`: its chance is not drawn.
struct Row {
  f64 chance;
  Range choices;
  Range rooms;
  Range not_in;
  i32 always;
  i32 in_style;
  i32 accent;
  i32 most;  // of it in one piece, if it is inside
};

struct Share {
  f64 across;
  f64 along;
};

struct Lies {
  Row row;
  Range at;
  Range surface;
  Range on;
  i32 at_seats;
  i32 turn;
  i32 upright;
  i32 fills;
  Share fill;
  i64 reach;
};

struct Hangs {
  Row row;
  Range at;
  i64 height;
  i64 gap;
};

enum class Where : i32 { middle = 0, corner = 1, beside = 2, wall = 3, free = 4, under = 5 };

struct Stands {
  Row row;
  Range of;
  Where where;
  i32 fills;
  f64 per_area;  // 0: `count` of it, whatever the area
  f64 min_side;
  f64 fill;
  f64 bare;  // share of the piece it lies under, from that one's back on, that it is not under
  i64 count;
  i64 widest;   // 0: as wide as may be
  i64 longest;  // 0: as long as may be
  i64 reach;
};

// What decorates a name; what it `holds` are rows of `lies`, too.
struct Entry {
  Range lies;
  Range hangs;
  Range stands;
  Range holds;
  i32 together;
  i32 indoor;
};

// The absolute cosine and sine of a whole number of degrees below 180.
struct Turn {
  f64 cosine;
  f64 sine;
};

struct DecoratingHeader {
  i32 entries, lies, hangs, stands, choices, sizes, kinds, surfaces, words, places, shares, turns;
  i32 indoor_entry;  // of the rows for every indoor room, or -1
  i32 seat_word;     // what a surface to sit on is called
};

struct Decorating {
  Span<Entry> entries;
  Span<Lies> lies;
  Span<Hangs> hangs;
  Span<Stands> stands;
  Span<Choice> choices;
  Span<Size> sizes;
  Span<Kind> kinds;
  Span<Surface> surfaces;
  Span<i32> words;
  Span<Share> places;
  Span<f64> shares;
  Span<Turn> turns;
  i32 indoor_entry;
  i32 seat_word;

  // What decorates a word, or null.
  const Entry* entry_of(i64 word) const { return word >= 0 && word < entries.size ? &entries.data[word] : nullptr; }
  const Kind& kind_of(const Choice& choice) const { return kinds[choice.kind]; }
  Span<Size> sizes_of(const Choice& choice) const { return {sizes.data + choice.sizes.first, choice.sizes.count}; }
  Span<Surface> surfaces_of(Range range) const { return part_of(surfaces, range); }
};

constexpr i32 DEGREES = 180;

// Reads what decorates, and ends the call where a row speaks of what is not there.
Decorating read_decorating(Bytes rows);

}  // namespace decorate
