// `aligned_with`: its middle in line with another piece's middle.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class AlignedWith : public Relation {
 public:
  constexpr AlignedWith() { by_degree = among_copies = into_line = true; }
  // Draws the middles into line, costs where they cannot slide there, and asks for the walls it names.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const i32 piece = subject.first(rule);
    if (piece < 0) return;
    Link& link = effect.links.add(link_to(rule, piece));
    link.walls = rule.wall;
    link.cost = rule.cost;
    link.align = rule.weight;
  }

  // Middles in line, across or along.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const Interval line{-2 * fit.asked.tolerance.nearly, 2 * fit.asked.tolerance.nearly};
    found.add({line, ANYWHERE});
    found.add({ANYWHERE, line});
  }
};

}  // namespace furnish
