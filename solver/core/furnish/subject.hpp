// What furnish makes: candidates and links; and the piece that seeks its places, as relations see it.
#pragma once

#include "furnish/relations/knee_room.hpp"

namespace furnish {

// What a slot of another piece is called by: a side; a place around it; a surface.
enum class Slot : i32 { none = 0, side = 1, seat = 2, level = 3 };

// One way for a piece to stand; a row of the answer. Lengths mm, rotation in degrees, -1 for none.
struct Candidate {
  i32 kind;  // -1 for floor that is better kept free
  i32 rotation;
  Wall wall;
  i32 parent;  // the piece at whose slot it stands, by its place in the answer
  i32 parent_kind;
  Slot slot;
  Side slot_side;
  i32 is_under;
  i32 is_on;
  i32 stance, parent_stance;  // of a list's piece, how it and its parent stand in the room, by their numbers; 0: not told
  i32 unused;
  i64 slot_number;  // a seat's shift, or a surface's place among its kind's
  Point anchor;
  Interval across, along;
  Rect within;  // where its footprint must stay; empty: anywhere
  i64 bottom;
  f64 weight;
  f64 cost;
  Extent floor;  // how large that floor is
};

constexpr f64 USUAL_WEIGHT = 1.0;

inline Candidate free_candidate(i32 kind, f64 cost) {
  Candidate made{};
  made.kind = kind;
  made.wall = Wall::none;
  made.parent = made.parent_kind = -1;
  made.weight = USUAL_WEIGHT;
  made.cost = cost;
  return made;
}

constexpr i32 LOOKS_AT = 360;  // the turn of a link by which one piece looks at the other

// A condition or a pull between two pieces; a row of the answer.
struct Link {
  Word word;
  i32 of;
  i32 turn;  // degrees, LOOKS_AT, or -1
  Walls walls;
  i32 required;
  i32 unused;
  f64 cost, align, near, apart_m, apart_cost;
};

// One way an earlier piece may stand: the piece by its place in the answer, and what it is then.
struct Parent {
  i32 piece;
  i32 kind;
};

// What stands already: pieces by the word relations call them, and the kinds each may be.
struct Earlier {
  Span<List<i32>> by_word;
  List<List<i32>> kinds;
};

bool share_a_name(Span<Name> some, Span<Name> others);

// A copy of a piece that seeks its places.
struct Subject {
  const Scope& scope;
  const RoomType& type;
  const PieceSpec& spec;
  Span<Variant> variants;  // those that suit the room, the wanted one first
  Span<Rule> rules;
  const Earlier& earlier;
  KneeRoom& knee_room;

  const Kind& kind(const Candidate& candidate) const { return type.kinds[candidate.kind]; }
  Rect footprint(const Candidate& candidate) const {
    return Rect::around(candidate.anchor, turned(kind(candidate).size(), candidate.rotation));
  }

  // The first earlier piece that a relation names, or -1.
  i32 first(const Rule& rule) const;
  // The earlier pieces that a relation names.
  List<i32> pieces(const Rule& rule) const;
  // Every way that they may stand.
  List<Parent> parents(const Rule& rule) const;
  // Tells whether a relation turns this piece towards one of the names, or to an opening.
  bool faces(Span<Name> names) const;
  bool faces(Opening opening) const;
};

}  // namespace furnish
