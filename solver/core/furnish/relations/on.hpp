// `on`: on another piece's surface: in its middle, at its back or front, or (align any) anywhere along it.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class On : public Relation {
 public:
  constexpr On() { gives_place = true; }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
};

}  // namespace furnish
