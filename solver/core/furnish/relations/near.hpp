// `near`: close to a piece or an opening; `near_door` to a door.
#pragma once

#include "furnish/relations/openings.hpp"

namespace furnish {

// Shares of a distance along the axes with which boxes lie inside a circle, or a rounded box: its square, and two longer ones beside it.
struct Shares {
  f64 x, z;
};
constexpr Shares IN_CIRCLE[] = {{0.7, 0.7}, {0.95, 0.31}, {0.31, 0.95}}, IN_ROUNDED[] = {{0.7, 0.7}, {0.99, 0.14}, {0.14, 0.99}};

static void add_reach(const Footing& at, Point middle, f64 half_x, f64 half_z, List<Rect>& found) {
  const Interval x = about(middle.x, half_x + static_cast<f64>(at.extent.x)), z = about(middle.z, half_z + static_cast<f64>(at.extent.z));
  found.add({x.low, z.low, x.high, z.high});
}

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
    Link& link = add_asking(effect, rule, piece, rule.wall);
    if (rule.wall == Walls::any) link.cost = 0.0;
    link.near = rule.weight;
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    return off_distance(subject, effect, candidate, NEAR_MM, Off::beyond);
  }

  // Within the distance of each opening: boxes inside the circle, along a wall up to it.
  void regions(const Footing& at, List<Rect>& found) const override {
    const i64 wished = at.asked.rule.distance_or(NEAR_MM) - at.asked.tolerance.inside;
    if (wished < 0) return;
    const f64 far = static_cast<f64>(wished);
    for (const Opened& one : openings_named(at.scope, at.asked.of, doors_)) {
      const Point middle = one.centre();
      if (at.wall == Wall::none) {
        for (const Shares& share : IN_CIRCLE) add_reach(at, middle, share.x * far, share.z * far, found);
        continue;
      }
      const i64 off = at.off_wall(middle);
      if (off > wished) continue;
      const f64 along = root(static_cast<f64>(wished * wished - off * off));
      runs_along_x(at.wall) ? add_reach(at, middle, along, far, found) : add_reach(at, middle, far, along, found);
    }
  }

  // A box inside the rounded one, and two longer ones beside it.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const i64 wished = fit.asked.rule.distance_or(NEAR_MM) - fit.asked.tolerance.inside;
    if (wished < 0) return;
    const f64 far = static_cast<f64>(wished);
    const Extent touching = fit.touching();
    for (const Shares& share : IN_ROUNDED) {
      const i64 x = 2 * whole(floor(static_cast<f64>(touching.x) / 2.0 + share.x * far));
      const i64 z = 2 * whole(floor(static_cast<f64>(touching.z) / 2.0 + share.z * far));
      found.add({{-x, x}, {-z, z}});
    }
  }

  bool holds_in_room(const Footing& at) const override {
    for (const Opened& one : openings_named(at.scope, at.asked.of, doors_)) {
      if (at.reach.distance_to(one.centre()) <= static_cast<f64>(at.asked.rule.distance_or(NEAR_MM))) return true;
    }
    return false;
  }

  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override {
    return own.rect.distance_to(other.rect) <= static_cast<f64>(fit.asked.rule.distance_or(NEAR_MM));
  }

 private:
  static constexpr i64 NEAR_MM = 1500;

  bool doors_;
};

}  // namespace furnish
