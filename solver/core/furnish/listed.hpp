// A list of pieces with relations, as a user asks for it. Unlike those of a room type, which cost by degree, these are held or not.
//
// Every way for a piece to stand says which it holds: those to the room by a rectangle that its footprint stays in, those to another piece
// by a box in that one's frame, for each stance of it. What a way does not hold, it pays for.
#pragma once

#include "furnish/furnish.hpp"
#include "furnish/relations/relation.hpp"

namespace furnish {

// How many ways to stand are kept, the cheapest.
struct Kept {
  i64 rects;     // of one stance, before the few that are searched are chosen
  i64 each;      // of one stance that are searched, and the dearest of all
  i64 boxes;     // of one stance, in another piece's frame, that differ in what they hold
  i64 places;    // of one stance beside one stance of another piece
  i64 beside;    // of all stances beside one stance of another piece
  i64 attached;  // of a piece, attached to others
  i64 in_all;    // of all pieces; with more there is no answer
  bool is_sure;  // whether a way that is not at the only other piece pays in full: where relations to it hold there are ways at it
};
// What finds a good placement of any list; what proves one the best, of lists that are short enough.
constexpr Kept FEW{12, 3, 14, 3, 5, 400, 1'000'000, false}, NEARLY_ALL{64, 64, 64, 64, 64, 2000, 900, true};

// What of a piece's pose others' ways depend on.
struct Stance {
  i32 rotation;
  Wall wall;

  bool operator==(const Stance&) const = default;
};

// It as one number, and back; 0 is none.
constexpr i32 stance_number(i32 rotation, Wall wall) { return 1 + rotation / 90 + (wall == Wall::none ? 0 : 4); }
constexpr Stance stance_of(i32 number) {
  const i32 rotation = (number - 1) % 4 * 90;
  return {rotation, number > 4 ? wall_behind(rotation) : Wall::none};
}

// A piece as Python sends it: what stands already, then the list, each after those it refers to.
struct ListedRow {
  i32 word;  // its label
  i32 name;  // what its request is called: its copies share it
  i32 kind;
  i32 required;
  Range rules;
  Rect at;  // of what stands already, its footprint; of the list the part of the floor where it stands best, if it stands free, or empty
  Stance stance;  // of what stands already
};

// A stance of an earlier piece, and where its centre may be so.
struct Way {
  Stance stance;
  Rect reach;
};

// A rectangle, and what it costs to miss the relations that do not hold there.
struct Costed {
  Rect rect;
  f64 cost;
};

// A stance of a piece, where its footprint may be so, and the rectangles there that hold relations to the room, cheapest first.
struct Foothold {
  Stance stance;
  Extent extent;
  Rect reach;
  List<Costed> found;
};

// A relation between a piece and an earlier one: its own, or that one's, the `owner`, else -1; the earlier ones it is between.
struct Bond {
  const Rule* rule;
  i32 owner;
  List<i32> earlier;
  Setting setting = {};

  const Relation& relation() const { return relation_of(rule->word); }
};

// What every piece of a list is made from; `ways` are those of the pieces before it.
struct Listing {
  const Scope& scope;
  const RoomType& type;
  const Kept& kept;
  Span<ListedRow> rows;
  List<List<Way>> ways;

  Asked asked(const Rule& rule) const { return {rule, part_of(type.sides, rule.sides), type.of(rule), SOUGHT}; }
};

// A piece of the list that seeks its ways.
struct Seeker {
  const Listing& in;
  i32 number;
  List<const Rule*> to_room;
  List<Bond> pairs;
  f64 dropped = INFINITE;  // what those cost at least that a limit kept out

  const ListedRow& row() const { return in.rows[number]; }
  const Kind& kind() const { return in.type.kind(row().kind); }
  void drop(f64 cost) { dropped = least(dropped, cost); }
  // The part of a relation's cost that a way pays which is not at any of those it is to.
  f64 share(const Bond& pair) const;
  // A way that stands so.
  Candidate way(Stance stance, f64 cost, f64 weight) const;
};

// Anywhere, of centres.
constexpr Rect ANY_PLACE{-NO_END / 2, -NO_END / 2, NO_END / 2, NO_END / 2};
// What it costs that a piece of a list is missing, and a way that breaks a required relation.
constexpr f64 GONE = 100.0;
// The part of a relation's cost that a way pays which may hold it or not.
constexpr f64 UNSURE = 0.25;
// Pull, m^-2, to the middle of a box or a rectangle: of a place beside, before or around a piece, and of any other.
constexpr f64 FIRM = 0.3, LOOSE = 0.03;

// What two rectangles share; tells whether a footprint of that extent fits in it.
bool fits_both(const Rect& a, const Rect& b, Extent extent, Rect& shared);
// What is left of rectangles, cheapest first, where a relation holds in some others as well, at what these cost, or is missed; of `most`.
List<Costed> with_rule(Seeker& seeker, const List<Costed>& found, const Rule& rule, const List<Costed>& held, Extent extent, i64 most);
List<Foothold> footholds(Seeker& seeker);
// The ways to stand at walls and in the room, attached to nobody.
void add_alone(const Seeker& seeker, Span<Foothold> footholds, List<Candidate>& found);
// The ways attached to another piece, each for one stance of that one, those as dear as `dearest` left out.
void add_attached(Seeker& seeker, Span<Foothold> footholds, f64 dearest, List<Candidate>& found);

// Where a piece stands, and how; no footprint where it does not. One that is loose seeks further ways between the others.
struct StandsRow {
  Rect at;
  Stance stance;
  i64 is_loose;
};

// The ways that hold as many relations as can be with the others where they are.
List<Candidate> between_others(Seeker& seeker, Span<Foothold> footholds, Span<StandsRow> others);

// A room type's tables of kinds and rules, and a room with its list behind it -> rows as `furnish_room` answers: first of all what a
// placement costs at least that takes a way which a limit kept out; in place of the counts (piece, rule) that no way pays for.
Bytes listed_pieces(Bytes type_rows, Bytes room_rows);

}  // namespace furnish
