// `against_wall`: its back is at a wall; `walls` says what walls of each sort cost.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class AgainstWall : public Relation {
 public:
  constexpr AgainstWall() { at_walls = true; }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override;
  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override;
  // At any wall.
  void regions(const Footing& at, List<Rect>& found) const override {
    if (at.wall != Wall::none) found.add(at.reach);
  }
};

}  // namespace furnish
