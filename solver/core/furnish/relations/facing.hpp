// `facing`: its front is turned to another piece or to an opening.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class Facing : public Relation {
 public:
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override;
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override;
};

}  // namespace furnish
