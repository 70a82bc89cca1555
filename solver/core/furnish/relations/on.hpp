// `on`: on another piece's surface: in its middle, at its back or front, or (align any) anywhere along it.
#pragma once

#include "relation.hpp"

class On : public Relation {
 public:
  constexpr On() { gives_place = true; }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
};
