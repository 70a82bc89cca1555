// A run of a kitchen as it is drawn, and what it costs by what it holds and where that stands.
#pragma once

#include "furnish/preferences.hpp"

namespace furnish {

// What a run asks of its items: what is said of a word in the room's type; whether an item has one that stands for it in a corner with
// its left (right) end hidden; whether it is no deeper than the one before it.
enum Trait : i32 { WORKTOP_TRAIT, LANDING_TRAIT, END_TRAIT, CORNER_TRAIT, SHALLOWER_TRAIT = CORNER_TRAIT + 2, TRAITS };

static_assert(3 * MOST_IN_RUN <= 64);

// The traits of a run's items, a bit each; of one trait those of all items side by side. Three traits a word.
struct Traits {
  u64 words[TRAITS / 3];

  void set(Trait trait, u64 is, i32 item = 0) { words[trait / 3] |= is << (trait % 3 * MOST_IN_RUN + item); }
  // Adds those of an item, where it is held.
  void add(const Traits& of, u64 held, i32 item) {
    for (i32 k = 0; k < TRAITS / 3; k++) words[k] |= (of.words[k] & (0 - held)) << item;
  }
  u64 items(i32 trait) const { return words[trait / 3] >> (trait % 3 * MOST_IN_RUN) & ((1ULL << MOST_IN_RUN) - 1); }
};

// A variant of a piece that a run may hold.
struct Item {
  i32 word;
  i32 kind;
  f64 cost;
  i64 width, depth;
  i64 worktop;                 // its length as worktop
  Traits traits;
  const Item* corner[2];       // as wide, standing in a corner with its left (right) end hidden; null where there is none
  const List<Interval>* free;  // by wall: the stretches where it may stand
};

using Items = Span<const Item*>;

// What a run may hold of a word.
struct Member {
  const CountedPiece* piece;  // null: nothing
  bool optional;
  Span<Item> items;
};

// What there is of an order, and how much of it a run may lack.
struct Order {
  List<const Member*> members;
  i32 optional;
};

// Items along one wall, the first at `start`, the others after it: as they come in the run, or from its end on.
struct Leg {
  Wall wall;
  i64 start;
  Items items;
  bool reversed;

  const Item& at(i32 k) const { return *items[reversed ? items.size - 1 - k : k]; }
};

inline i64 length_of(const Items& items) {
  i64 length = 0;
  for (const Item* item : items) length += item->width;
  return length;
}

struct Legs {
  Leg leg[2];
  i32 count;

  const Leg* begin() const { return leg; }
  const Leg* end() const { return leg + count; }
};

enum class Form : i32 { straight, corner, opposite };

// The numbers that are drawn of how a run is laid, whatever it holds: its wall; from which end of its wall each leg is laid; in which
// stretch a leg that begins in no corner; its form, and where it is cut in two.
enum Laid : i32 { WALL, HIGH, OTHER_HIGH, STRETCH, OTHER_STRETCH, ROUND, ACROSS, CUT, LAID_NUMBERS };

// A run as it is drawn: its items, and how they are laid.
struct Drawn {
  Items items;
  Traits traits;
  i64 worktop;  // its length
  Stream laid;  // its numbers, read where they are asked for
  Form form;
  Wall wall;
  bool high;
  i32 first;  // how many items stand along the first wall
  f64 cost;

  Stream number(Laid which) const { return laid.ahead(which); }
};

// What a run costs by the sides that lack the worktop wanted there; cut in two it costs as much, or more.
f64 landing_cost(const Drawn& drawn);

// What a run costs by what belongs at an end and stands within, and by what stands alone across from the rest.
f64 end_cost(const Drawn& drawn);

// What a run costs by the worktop it lacks; what is hidden round a corner is none.
f64 worktop_cost(const RoomType& type, const Drawn& drawn);

// A piece that a run leaves a place: of what kind it is there, how much floor it wants unturned, and what is in its way whatever the run.
struct Follower {
  const Leaving* wish;
  i32 kind;
  Extent floor;
  List<Rect> taken;
};

// The place nearest to the room's middle that a run leaves to a piece; its kind is -1 where it leaves none.
Candidate place_left(const Scope& scope, const Follower& follower, const Legs& legs);

// What a run costs by its working triangle, measured between the middles of the fronts.
f64 triangle_cost(const RoomType& type, Span<Candidate> places);

}  // namespace furnish
