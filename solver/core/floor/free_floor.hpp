// Whether everything in a room stays within reach over the floor that is free: exact, on a grid cut at every edge.
//
// A square person's centre is free where the open square meets neither body nor wall. Lengths are quarter millimetres and the person
// is half a millimetre narrower than said, so that gaps of exactly its width let it through and cells are open sets.
#pragma once

#include "plain/lists.hpp"
#include "plain/rects.hpp"

// Something to come to: a body's footprint, mm, the walls its sides look to as bits 1 << Wall, and whether all of them are needed.
struct Goal {
  Rect rect;
  i32 sides;
  i32 need_all;
};

class FreeFloor {
 public:
  // A room's clear rectangle, mm, how wide who walks is, what has to stay within reach, and how many of the first doors are joined outside.
  FreeFloor(const Rect& clear, i64 robot, Span<Doorway> doors, Span<Goal> goals, i32 outer = 0);

  // Notes that something stands in the way, mm.
  void add(const Rect& body) { taken_.add(grown(body)); }

  // Tells whether one component of the floor meets every door and every goal, and is 0.25 m2 of centres. What meets doors that are
  // joined outside is one component, and one of these doors is enough; without any door one walks in the largest.
  bool connects() const;

  // The same with one more body.
  bool connects_with(const Rect& body);

 private:
  Rect grown(const Rect& body) const;
  Rect entry_of(const Doorway& door) const;
  Rect contact(const Rect& body, Wall side) const;

  i64 reach_;
  Rect domain_;
  Span<Doorway> doors_;
  Span<Goal> goals_;
  i32 outer_;
  List<Rect> taken_;
};
