// `against_wall`: its back is at a wall; `walls` says what walls of each sort cost.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class AgainstWall : public Relation {
 public:
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override;
  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override;
};

}  // namespace furnish
