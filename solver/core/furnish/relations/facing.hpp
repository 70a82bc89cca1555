// `facing`: its front is turned to another piece or to an opening.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class Facing : public Relation {
 public:
  constexpr Facing() { turns = true; }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override;
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override;
  void regions(const Footing& at, List<Rect>& found) const override;
  void boxes(const Fit& fit, List<DoubleBox>& found) const override;
  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override;
};

}  // namespace furnish
