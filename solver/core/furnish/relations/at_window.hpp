// `at_window`: at a window, its middle on the window's middle; says nothing in a room without one.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class AtWindow : public Relation {
 public:
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override;
  void regions(const Footing& at, List<Rect>& found) const override;
};

}  // namespace furnish
