// `in_corner`: in a corner of the room, near two walls that meet.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class InCorner : public Relation {
 public:
  // Tries the corners, and costs elsewhere.
  void effect(const Subject&, const Rule& rule, Effect& effect) const override {
    effect.has_cost = effect.corners = true;
    effect.weight = rule.weight;
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    return stands_in_one(subject, candidate) ? 0.0 : effect.rule->missed();
  }

  // What stands in a corner that it wants so much stays there.
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override {
    if (candidate.parent >= 0 || effect.rule->missed() < SHUNNED || !stands_in_one(subject, candidate)) return;
    const Rect rect = subject.footprint(candidate), clear = subject.scope.clear;
    const i64 x = rect.width() + 2 * subject.scope.gap, z = rect.depth() + 2 * subject.scope.gap;
    const bool west = rect.wall_distance(Wall::west, clear) <= rect.wall_distance(Wall::east, clear);
    const bool north = rect.wall_distance(Wall::north, clear) <= rect.wall_distance(Wall::south, clear);
    const Interval across = west ? Interval{clear.x0, clear.x0 + x} : Interval{clear.x1 - x, clear.x1};
    const Interval along = north ? Interval{clear.z0, clear.z0 + z} : Interval{clear.z1 - z, clear.z1};
    hold(candidate, {across.low, along.low, across.high, along.high});
  }

 private:
  static bool stands_in_one(const Subject& subject, const Candidate& candidate) {
    const Rect rect = subject.footprint(candidate), clear = subject.scope.clear;
    const i64 x = least(rect.wall_distance(Wall::west, clear), rect.wall_distance(Wall::east, clear));
    const i64 z = least(rect.wall_distance(Wall::north, clear), rect.wall_distance(Wall::south, clear));
    return most(x, z) <= 2 * subject.scope.gap;
  }
};

}  // namespace furnish
