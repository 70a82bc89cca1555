// `at_window`: at a window, its middle on the window's middle; says nothing in a room without one.
#pragma once

#include "furnish/relations/centred.hpp"

namespace furnish {

class AtWindow : public Relation {
 public:
  // Tries the windows' middles, and costs by the distance from them.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    for (const Opened& one : subject.scope.openings) {
      if (one.kind != Opening::window) continue;
      effect.has_cost = true;
      effect.weight = rule.weight;
      for (const Variant& variant : subject.variants) effect.positions.add({one.wall, variant.kind, one.middle()});
    }
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    f64 nearest = INFINITE;
    for (const Opened& one : subject.scope.openings) {
      if (one.kind != Opening::window || one.wall != candidate.wall) continue;
      const i64 along = runs_along_x(one.wall) ? candidate.anchor.x : candidate.anchor.z;
      nearest = least(nearest, static_cast<f64>(magnitude(along - one.middle())));
    }
    return off_middle(*effect.rule, nearest);
  }

  // At the wall of each window, about its middle.
  void regions(const Footing& at, List<Rect>& found) const override {
    const i64 more = 2 * at.asked.tolerance.nearly;
    for (const Opened& one : at.scope.openings) {
      if (one.kind != Opening::window) continue;
      const bool level = runs_along_x(one.wall);
      const Interval over = about(2 * one.middle(), (level ? at.extent.x : at.extent.z) + more);
      found.add(strip(at.scope.clear, one.wall, over, (level ? at.extent.z : at.extent.x) + more));
    }
  }
};

}  // namespace furnish
