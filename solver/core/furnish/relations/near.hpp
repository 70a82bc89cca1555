// `near`: close to a piece or an opening; `near_door` to a door.
#pragma once

#include "furnish/relations/openings.hpp"

namespace furnish {

class Near : public Relation {
 public:
  explicit constexpr Near(bool doors) : doors_(doors) {
    by_degree = among_copies = true;
    usual = NEAR_MM;
  }

  // Pulls towards a piece; what is farther from an opening than wished costs, in full at twice the distance.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const Span<Name> names = subject.type.of(rule);
    if (doors_ || names_opening(names)) return measure_from(subject, names, doors_, effect);
    const i32 piece = subject.first(rule);
    if (piece < 0) return;
    Link& link = effect.links.add(link_to(rule, piece));
    link.walls = rule.wall;
    link.cost = rule.wall == Walls::any ? 0.0 : rule.cost;
    link.required = rule.required;
    link.near = rule.weight;
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    return off_distance(subject, effect, candidate, NEAR_MM, Off::beyond);
  }

  void regions(const Footing& at, List<Rect>& found) const override;
  void boxes(const Fit& fit, List<DoubleBox>& found) const override;
  bool holds_in_room(const Footing& at) const override;
  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override;

 private:
  static constexpr i64 NEAR_MM = 1500;

  bool doors_;
};

}  // namespace furnish
