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
    const Rect rect = subject.footprint(candidate), clear = subject.scope.clear;
    const i64 x = least(rect.wall_distance(Wall::west, clear), rect.wall_distance(Wall::east, clear));
    const i64 z = least(rect.wall_distance(Wall::north, clear), rect.wall_distance(Wall::south, clear));
    return most(x, z) <= 2 * subject.scope.gap ? 0.0 : effect.rule->missed();
  }
};

}  // namespace furnish
