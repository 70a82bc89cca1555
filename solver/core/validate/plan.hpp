// The rules about the plan itself: rooms that share floor, openings that are in no wall, lead elsewhere than they say, or meet others.
#pragma once

#include "validate/walk.hpp"

namespace validate {

// How an opening is wrong; each is told of the first of these.
enum class Wrong : i32 { leaves_wall = 0, leads_nowhere = 1, faces_room = 2, misses_room = 3, meets = 4, reaches_above = 5 };

// A piece of wall line in the house: where it lies, what it spans, the number of the room whose it is.
struct HouseWall {
  i64 line;
  i64 start, end;
  i32 room;
};

// The rooms of a storey beside each other.
class Plan {
 public:
  Plan(const Storey& storey, Looks& looks);

  // Tells what of a room is wrong: with which of the rooms listed after it it shares floor, and its openings, each by its number, with the
  // room or opening that it is about.
  void find(i32 room, Looks& looks, Findings& found) const;

 private:
  // Two rooms whose bounds overlap, in the order in which they are listed.
  struct Pair {
    i32 first, later;
  };

  void find_overlaps(i32 room, Looks& looks, Findings& found) const;
  // Whether the opening of a room that `wrong` is about is wrong; then it says how.
  bool finds_wrong(i32 room, Finding& wrong, Looks& looks) const;
  bool leads_elsewhere(i32 room, Finding& wrong, Looks& looks) const;
  bool meets_another(i32 room, Finding& wrong, Looks& looks) const;
  List<HouseWall> beyond(i32 room, const Edge& cut, Looks& looks) const;

  const Storey& storey_;
  List<HouseWall> walls_[4];  // by which wall they are, and where they lie
  List<Pair> pairs_;          // by first, and then by later
};

}  // namespace validate
