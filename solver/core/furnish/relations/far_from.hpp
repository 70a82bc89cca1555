// `far_from`: at least a distance from a piece or an opening; `far_from_door` from every door.
#pragma once

#include "furnish/relations/openings.hpp"

namespace furnish {

class FarFrom : public Relation {
 public:
  explicit constexpr FarFrom(bool doors) : doors_(doors) {
    by_degree = with_all = among_copies = true;
    usual = FAR_MM;
  }

  // Every metre short of the distance costs; short of an opening's, in full at the opening.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const Span<Name> names = subject.type.of(rule);
    if (doors_ || names_opening(names)) return measure_from(subject, names, doors_, effect);
    for (i32 piece : subject.pieces(rule)) {
      Link& link = effect.links.add(link_to(rule, piece));
      link.apart_m = static_cast<f64>(rule.distance_or(FAR_MM)) / 1000.0;
      link.apart_cost = rule.cost;
    }
    if (rule.wall == Walls::any || effect.links.size() == 0) return;
    Link& link = effect.links.add(link_to(rule, effect.links[0].of));
    link.walls = rule.wall;
    link.cost = rule.cost;
    link.required = rule.required;
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    return off_distance(subject, effect, candidate, FAR_FROM_OPENING_MM, Off::shortfall);
  }

  void regions(const Footing& at, List<Rect>& found) const override;
  void boxes(const Fit& fit, List<DoubleBox>& found) const override;
  bool holds_in_room(const Footing& at) const override;
  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override;

 private:
  static constexpr i64 FAR_MM = 2000, FAR_FROM_OPENING_MM = 1500;

  bool doors_;
};

}  // namespace furnish
