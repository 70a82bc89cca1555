// `on`: on another piece's surface: in its middle, at its back or front, or (align any) anywhere along it.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class On : public Relation {
 public:
  constexpr On() { gives_place = true; }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  void boxes(const Fit& fit, List<DoubleBox>& found) const override;
  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override;
};

}  // namespace furnish
