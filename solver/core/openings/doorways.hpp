// The openings placed so far, by room.
#pragma once

#include "openings/house.hpp"

namespace openings {

// An opening as one of its rooms sees it: its wall there, its ends, the square that stays free at doors and passages.
struct OpeningSide {
  Cut cut;
  Wall wall;
  i64 low, high;
  Rect square;
};

// The best place of an opening, and what it costs.
struct Offer {
  f64 score;
  Cut placed;
};

class Doorways {
 public:
  explicit Doorways(const House& house);

  const House& house;

  const List<Cut>& cuts() const { return cuts_; }
  const List<OpeningSide>& sides(i64 room) const { return by_room_[room]; }
  bool has_window(i64 room) const;

  void add(const Cut& cut);
  void remove(const Cut& cut);
  // Puts an opening in the place of another one of the same rooms, in the order of openings too.
  void replace(const Cut& cut, const Cut& by);
  // Goes back to the openings there were.
  void restore(Span<Cut> before);

  OpeningSide side(const Cut& cut, i64 room) const;
  // 0 is free of all, COLLISION and more cannot be.
  f64 score(const Cut& cut) const;
  // How many openings that one walks through an opening faces across the rooms that its leaf is not in.
  i64 faced(const Cut& cut) const;
  // Adds the openings that this one cannot stand together with, some in all at most; returns how many there are.
  i32 colliding(const Cut& cut, Cut* found, i32 most) const;
  // Whether a stretch of an outside wall holds no opening.
  bool is_free(i64 room, Wall wall, i64 low, i64 high) const;
  Offer best(const Cut& cut, Interval stretch) const;
  // In an outside wall of its room, the longest stretch first.
  Offer best_outside(const Cut& cut) const;

 private:
  bool is_cornered(const Cut& cut) const;
  f64 meeting(const OpeningSide& side, const OpeningSide& other, i64 room) const;

  List<Cut> cuts_;
  Span<List<OpeningSide>> by_room_;
};

// Calls `use(centre)` with the centres that an opening may have in a stretch of wall: the middle, both ends, then every STEP_MM, until it
// answers true; returns whether it did.
template <class Use> bool any_place(const Header& walls, i64 width, Interval stretch, Use use) {
  const i64 jamb = least(walls.jamb, floor_div(stretch.high - stretch.low - width, 2));
  if (jamb < walls.least_jamb) return false;
  const i64 first = stretch.low + jamb + width / 2, last = stretch.high - jamb - width / 2, middle = floor_div(first + last, 2);
  if (use(middle) || (first != middle && use(first)) || (last != middle && last != first && use(last))) return true;
  for (i64 centre = first + STEP_MM; centre < last; centre += STEP_MM) {
    if (centre != middle && use(centre)) return true;
  }
  return false;
}

// The rooms that an opening is in.
template <class Use> void each_room(const Cut& cut, Use use) {
  use(cut.room);
  if (cut.other != NONE) use(cut.other);
}

void place_entrance(Doorways& doorways);
void place_doors(Doorways& doorways);
// Moves doors of bedrooms and their like to a corner of theirs, so that their walls stay whole, and from where they face others.
void move_to_corners(Doorways& doorways);
void place_garage_doors(Doorways& doorways);
// Gives every outside stretch of wall of a room that has no window yet one, or two where it is long.
void place_windows(Doorways& doorways);
// Moves an outside door where a habitable room has no window for it.
void make_room_for_windows(Doorways& doorways);
// Moves openings to the ends of their walls where a room has no wall as whole as its type asks.
void keep_walls(Doorways& doorways);

// Least wall between a window and a room's corner.
constexpr i64 EDGE_MM = 300;

}  // namespace openings
