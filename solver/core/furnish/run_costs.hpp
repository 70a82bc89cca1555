// A run of a kitchen as it is drawn, and what it costs by what it holds and where that stands.
#pragma once

#include "furnish/preferences.hpp"

namespace furnish {

// A variant of a piece that a run may hold.
struct Item {
  i32 word;
  i32 kind;
  f64 cost;
  i64 width, depth;
  bool worktop, landing, end;  // what the run asks of its word
  const Item* corner[2];       // as wide, standing in a corner with its left (right) end hidden; null where there is none
  const List<Interval>* free;  // by wall: the stretches where it may stand
};

// What a run may hold of a word.
struct Member {
  const CountedPiece* piece;  // null: nothing
  bool optional;
  bool turns[2];  // whether one of its items can stand in a corner with its left (right) end hidden
  Span<Item> items;
};

// What a run may hold, as it comes in the run.
struct Order {
  Span<const Member*> members;
  bool mirrored;

  i32 size() const { return members.size; }
  const Member& operator[](i32 at) const { return *members[mirrored ? members.size - 1 - at : at]; }
};

// An item where it stands, from `low` on along a wall.
struct Laid {
  const Item* item;
  Wall wall;
  i64 low;
};

// Items along one wall, laid one after the other from a coordinate on, towards the wall's low end or its high one.
struct Leg {
  Wall wall;
  bool high;    // laid from the high end on
  f64 stretch;  // in which of the stretches for its first item it begins, as a share of them
  i64 start, at;  // where it begins, and where the next item would
  i64 deepest;    // 0: nothing is laid yet

  Interval over() const { return {least(start, at), most(start, at)}; }
};

enum class Form : i32 { straight, corner, opposite };

// A run as it is drawn: its items, those of the first leg before those of the second.
struct Drawn {
  Form form;
  Side hidden;  // which end is hidden of what stands in the corner of the first leg
  Leg legs[2];
  Span<Laid> items;
  i32 first;  // how many items stand along the first wall
  f64 cost;
};

// What a run costs by what stands beside what: by sides that lack the worktop wanted there, by what belongs at an end and stands within,
// and by what stands alone across from the rest.
f64 row_cost(const Drawn& drawn);

// What a run costs by the worktop it lacks; what is hidden round a corner is none.
f64 worktop_cost(const RoomType& type, const Drawn& drawn);

// What a run costs by slivers between its ends and the walls there.
f64 sliver_cost(const Scope& scope, const Drawn& drawn);

// A piece that a run leaves a place: of what kind it is there, how much floor it wants unturned, and what is in its way whatever the run.
struct Follower {
  const Leaving* wish;
  i32 kind;
  Extent floor;
  List<Rect> taken;
};

// The place nearest to the room's middle that a run leaves to a piece; its kind is -1 where it leaves none.
Candidate place_left(const Scope& scope, const Follower& follower, const Drawn& drawn);

// What a run costs by its working triangle, measured between the middles of the fronts.
f64 triangle_cost(const RoomType& type, Span<Candidate> places);

}  // namespace furnish
