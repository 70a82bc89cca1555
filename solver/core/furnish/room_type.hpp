// A room type as Python compiles it: rows of plain structs, one after the other; names are indices into Python's tables.
#pragma once

#include "plain/tables.hpp"
#include "plain/rects.hpp"

namespace furnish {

// In the order of RelationWord of catalogs/schema.py.
enum class Word : i32 {
  against_wall, in_corner, beside, in_front_of, opposite, facing, near, far_from, around,
  aligned_with, centred, in_row, at_window, near_door, far_from_door, on, under, COUNT,
};

enum class Opening : i32 { none = -1, door = 0, garage_door = 1, window = 2, front_door = 3, passage = 4 };

// What a wall has, as `walls` of against_wall prices it.
enum class Sort : i32 { door = 0, window = 1, exterior = 2, plain = 3, shorter = 4, longer = 5, across = 6 };

// How a piece beside another one lines up with it.
enum class Align : i32 { none = 0, back = 1, centre = 2, front = 3, any = 4 };

// How the walls of two pieces should lie.
enum class Walls : i32 { any = 0, same = 1, opposite = 2, adjacent = 3, other = 4 };

// A surface of a kind: its height, and the free height above it (-1: any), mm; its name, of the names of all surfaces.
struct Level {
  i64 height;
  i64 clearance;
  i64 name;
};

// Of `opens` of a Comfort: the edge of a door goes along a side of the kind. Else it is whether fronts open.
constexpr i32 ALONG_SIDE = 2;

// Floor that is better kept free at a side of a kind, mm deep; at its left or right not so far from its back. What doing without costs.
//
// Where the kind's fronts `open` over it, it is part of that side, from `across.low` to `across.high` of its middle, and nothing that
// reaches higher than `bottom` may stand there. `half` deep it lets them open half of their way, at the same cost; less is not enough. Of a
// strip that a standard asks for `across` is empty where it is as long as the side.
struct Comfort {
  Side side;
  i32 opens;
  i64 depth;
  i64 behind;
  f64 cost;
  i64 half;
  Interval across;
  i64 bottom;
  i32 asked;  // 0, or which of the strips it is that a standard asks for: each is a piece of floor of its own
  i32 other;  // of such a strip: another side that will do, or -1
  i64 off;  // how far from the side it begins
};

// The box around a part of a kind: seen from above, and from `low` to `high`, mm.
struct PartBox {
  Rect rect;
  i64 low;
  i64 high;
};

struct Kind {
  i64 width, depth, height;
  i32 at_walls;
  i32 use_count;
  i32 use_sides;  // bit by Side
  i32 need_all;   // whether a person must get to all of these
  Range levels;
  Range parts;
  Range use;      // of `sides`: the same sides in order
  Range comforts;
  i32 name;  // the same for kinds of one name
  i32 unused;

  Extent size() const { return {width, depth}; }
  bool is_used_from(Side side) const { return use_sides >> static_cast<i32>(side) & 1; }
  bool has_front_only() const { return use_count == 1 && is_used_from(Side::front); }
};

struct Variant {
  i32 kind;
  i32 corner;  // stands only in the corner of a run, where what stands round it hides its left (0) or right (1) end; -1: elsewhere
  f64 cost;
  f64 min_area;
  f64 max_area;
};

// A word of an `of`: its own index, and which opening it is, if any.
struct Name {
  i32 word;
  Opening opening;
};

struct SortCost {
  Sort sort;
  i32 unused;
  f64 cost;
};

struct Rule {
  Word word;
  i32 required;
  Align align;
  Walls wall;
  i32 has_distance;
  i32 has_gap;
  Range of;
  Range sides;
  Range sorts;
  i64 distance;
  Interval gap;
  f64 cost;
  f64 weight;

  // What doing without it costs: everything, where it is hard.
  f64 missed() const { return required ? INFINITE : cost; }
  i64 distance_or(i64 usual) const { return has_distance ? distance : usual; }
};

struct PieceSpec {
  i32 word;  // what relations call it
  i32 required;
  i32 count;
  i32 among;  // which of the words of `among`, or -1
  i32 has_per_area;
  i32 with_next;  // it stands only together with the next piece
  Range variants;
  Range rules;
  Range approach;  // of `sides`: what must be reached in place of its kind's use
  f64 per_area;
  f64 min_area;
  f64 chance;
  f64 skip_cost;
};

constexpr i32 MOST_IN_RUN = 21;  // pieces in an order of a run (`Run.orders` of catalogs/schema.py has it, too)

// A piece that comes after a run, which had better leave it a place with so much floor, mm, at its front and back; what leaving none costs.
struct Leaving {
  i32 word;
  i32 unused;
  i64 beside;
  f64 cost;
};

// The sizes of the tables, in their order.
struct TypeHeader {
  i32 kinds, levels, parts, pieces, variants, rules, names, sorts, sides, comforts;
  i32 orders, words, worktop, landing, ends, triangle, leaves, all_words, has_run;
  i32 turning;  // the side of a square of floor that stays empty, mm, or 0
};

struct RoomType {
  Span<Kind> kinds;
  Span<Level> levels;
  Span<PartBox> parts;
  Span<PieceSpec> pieces;
  Span<Variant> variants;
  Span<Rule> rules;
  Span<Name> names;
  Span<SortCost> sorts;
  Span<Side> sides;
  Span<Comfort> comforts;
  Span<Range> orders;   // of a run, each a range of `words`
  Span<i32> words;      // of pieces, as the next four
  Span<i32> worktop;
  Span<i32> landing;
  Span<i32> ends;
  Span<i32> triangle;
  Span<Leaving> leaves;
  i32 all_words;  // how many words are told apart
  bool has_run;
  i64 turning;  // the side of a square of floor that stays empty, mm, or 0

  const Kind& kind(i32 at) const {
    if (at < 0 || at >= kinds.size) fail(Failure::bad_request);
    return kinds.data[at];
  }
  Span<Variant> variants_of(const PieceSpec& piece) const { return part_of(variants, piece.variants); }
  Span<Rule> rules_of(const PieceSpec& piece) const { return part_of(rules, piece.rules); }
  Span<Name> of(const Rule& rule) const { return part_of(names, rule.of); }
  Span<Level> levels_of(const Kind& kind) const { return part_of(levels, kind.levels); }
  Span<PartBox> parts_of(const Kind& kind) const { return part_of(parts, kind.parts); }
  Span<Comfort> comforts_of(const Kind& kind) const { return part_of(comforts, kind.comforts); }
};

RoomType read_room_type(u8* data, i64 size);

}  // namespace furnish
