// `centred`: in the middle of its wall, or of the room.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

// A piece this far from where it should be centred pays the full cost.
constexpr f64 REACH_MM = 1000.0;

// What being off a middle costs: by degree, and everything where the relation is hard.
inline f64 off_middle(const Rule& rule, f64 off_mm) { return off_mm == 0.0 ? 0.0 : rule.missed() * least(1.0, off_mm / REACH_MM); }

class Centred : public Relation {
 public:
  // Tries the middles, and costs by the distance from them.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const Point middle = subject.scope.clear.centre();
    for (Wall wall : WALLS) {
      for (const Variant& variant : subject.variants) effect.positions.add({wall, variant.kind, runs_along_x(wall) ? middle.x : middle.z});
    }
    for (const Variant& variant : subject.variants) effect.spots.add({variant.kind, 0, middle});
    effect.has_cost = true;
    effect.weight = rule.weight;
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    const Point middle = subject.scope.clear.centre(), at = candidate.anchor;
    const i64 x = magnitude(at.x - middle.x), z = magnitude(at.z - middle.z);
    const i64 off = candidate.wall == Wall::none ? most(x, z) : runs_along_x(candidate.wall) ? x : z;
    return off_middle(*effect.rule, static_cast<f64>(off));
  }

  // About the middle of the wall at its back, or of the room.
  void regions(const Footing& at, List<Rect>& found) const override {
    const Rect& clear = at.scope.clear;
    const i64 more = 2 * at.asked.tolerance.nearly;
    const Interval x = about(clear.x0 + clear.x1, at.extent.x + more), z = about(clear.z0 + clear.z1, at.extent.z + more);
    const bool level = at.wall != Wall::none && runs_along_x(at.wall), upright = at.wall != Wall::none && !level;
    found.add({upright ? clear.x0 : x.low, level ? clear.z0 : z.low, upright ? clear.x1 : x.high, level ? clear.z1 : z.high});
  }
};

}  // namespace furnish
