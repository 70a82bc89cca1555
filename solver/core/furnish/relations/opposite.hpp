// `opposite`: at the wall opposite another piece, facing it.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class Opposite : public Relation {
 public:
  constexpr Opposite() { turns = at_walls = into_line = true; }
  // Asks for the turn and the walls, and draws the middles in line.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const i32 piece = subject.first(rule);
    if (piece < 0) return;
    Link& link = add_asking(effect, rule, piece, Walls::opposite);
    link.turn = 180;
    link.align = rule.weight;
  }

  // Before the other's front, turned to it.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const i64 half = most(fit.parent.x, fit.own.x) - 2 * fit.asked.tolerance.inside;
    if (fit.turn == 180 && half > 0) found.add({{-half, half}, {fit.touching().z + fit.spare(), NO_END}});
  }

  // At the opposite wall, where the other is at one.
  bool suits(Walls asked, Wall mine, Wall theirs) const override {
    return (theirs == Wall::none || mine == ::opposite(theirs)) && Relation::suits(asked, mine, theirs);
  }
};

}  // namespace furnish
