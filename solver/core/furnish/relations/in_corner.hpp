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

  // In each of the four corners.
  void regions(const Footing& at, List<Rect>& found) const override {
    const Rect& clear = at.scope.clear;
    const i64 w = at.extent.x + at.asked.tolerance.nearly, d = at.extent.z + at.asked.tolerance.nearly;
    const i64 xs[] = {clear.x0, clear.x1 - w}, zs[] = {clear.z0, clear.z1 - d};
    for (i64 z : zs) {
      for (i64 x : xs) found.add({x, z, x + w, z + d});
    }
  }
};

}  // namespace furnish
