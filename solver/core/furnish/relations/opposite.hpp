// `opposite`: at the wall opposite another piece, facing it.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class Opposite : public Relation {
 public:
  // Asks for the turn and the walls, and draws the middles in line.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const i32 piece = subject.first(rule);
    if (piece < 0) return;
    Link& link = effect.links.add(link_to(rule, piece));
    link.turn = 180;
    link.walls = Walls::opposite;
    link.cost = rule.cost;
    link.required = rule.required;
    link.align = rule.weight;
  }
};

}  // namespace furnish
