// `far_from`: at least a distance from a piece or an opening; `far_from_door` from every door.
#pragma once

#include "furnish/relations/openings.hpp"
#include "plain/rounding.hpp"

namespace furnish {

constexpr f64 EVERYWHERE = 1'000'000.0;
// Off a corner it is as far by less along each axis: the cosine and the sine of an eighth of a right angle, three of them.
constexpr f64 CORNER_SHARES[][2] = {{0.924, 0.383}, {0.383, 0.924}};

// The four largest parts of a rectangle beside a box around a point, those in which the footprint has room; all of it where it is clear.
static void add_without(const Footing& at, const Rect& rect, Point point, f64 half_x, f64 half_z, List<Rect>& found) {
  const f64 x = static_cast<f64>(point.x), z = static_cast<f64>(point.z);
  const Rect hole{whole(floor(x - half_x)), whole(floor(z - half_z)), rounded_up(x + half_x), rounded_up(z + half_z)};
  const Rect beside[] = {
    {rect.x0, rect.z0, least(hole.x0, rect.x1), rect.z1}, {most(hole.x1, rect.x0), rect.z0, rect.x1, rect.z1},
    {rect.x0, rect.z0, rect.x1, least(hole.z0, rect.z1)}, {rect.x0, most(hole.z1, rect.z0), rect.x1, rect.z1},
  };
  const auto add_if_fits = [&](const Rect& part) {
    if (part.width() >= at.extent.x && part.depth() >= at.extent.z) found.add(part);
  };
  if (!rect.overlaps(hole)) return add_if_fits(rect);
  for (const Rect& part : beside) add_if_fits(part);
}

// The parts of a rectangle off the corners of boxes around a point that are as far from it as is wished: free of walls.
static void add_off_corners(const Footing& at, const Rect& rect, Point point, f64 wished, List<Rect>& found) {
  for (const auto& share : CORNER_SHARES) {
    const i64 x = rounded_up(share[0] * wished), z = rounded_up(share[1] * wished);
    const Interval columns[] = {{rect.x0, point.x - x}, {point.x + x, rect.x1}};
    const Interval rows[] = {{rect.z0, point.z - z}, {point.z + z, rect.z1}};
    for (const Interval& across : columns) {
      for (const Interval& along : rows) {
        const Rect part = rect.common({across.low, along.low, across.high, along.high});
        if (part.width() >= at.extent.x && part.depth() >= at.extent.z) found.add(part);
      }
    }
  }
}

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
    if (rule.wall != Walls::any && effect.links.size() > 0) add_asking(effect, rule, effect.links[0].of, rule.wall);
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    return off_distance(subject, effect, candidate, FAR_FROM_OPENING_MM, Off::shortfall);
  }

  // Clear of the square around every opening, or where that has no room off a corner of it; along a wall, exactly clear of the circle.
  void regions(const Footing& at, List<Rect>& found) const override {
    const i64 wished = at.asked.rule.distance_or(FAR_FROM_OPENING_MM) + at.asked.tolerance.inside;
    List<Rect> left;
    left.add(at.reach);
    for (const Opened& one : openings_named(at.scope, at.asked.of, doors_)) {
      f64 half_x = static_cast<f64>(wished), half_z = half_x;
      if (at.wall != Wall::none) {
        const i64 off = at.off_wall(one.centre());
        if (off >= wished) continue;
        const f64 half = root(static_cast<f64>(wished * wished - off * off));
        const bool level = runs_along_x(at.wall);
        half_x = level ? half : EVERYWHERE;
        half_z = level ? EVERYWHERE : half;
      }
      List<Rect> parts;
      for (const Rect& rect : left) {
        const i32 known = parts.size();
        add_without(at, rect, one.centre(), half_x, half_z, parts);
        if (at.wall == Wall::none && parts.size() == known) add_off_corners(at, rect, one.centre(), half_x, parts);
      }
      left = parts;
    }
    found.add_all(left.all());
  }

  // Beyond the distance at any of four sides, or off any corner by less along each axis.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const i64 d = fit.asked.rule.distance_or(FAR_MM) + fit.asked.tolerance.inside;
    const Extent touching = fit.touching();
    const i64 x = floor_div(touching.x, 2) + 1, z = floor_div(touching.z, 2) + 1;
    const auto sides_of = [](i64 off, Interval sides[2]) { sides[0] = {-NO_END, -2 * off}, sides[1] = {2 * off, NO_END}; };
    Interval across[2], along[2];
    sides_of(x + d, across);
    sides_of(z + d, along);
    for (Interval one : across) found.add({one, ANYWHERE});
    for (Interval one : along) found.add({ANYWHERE, one});
    for (const auto& share : CORNER_SHARES) {
      sides_of(x + rounded_up(share[0] * static_cast<f64>(d)), across);
      sides_of(z + rounded_up(share[1] * static_cast<f64>(d)), along);
      for (Interval one : across) {
        for (Interval other : along) found.add({one, other});
      }
    }
  }

  bool holds_in_room(const Footing& at) const override {
    for (const Opened& one : openings_named(at.scope, at.asked.of, doors_)) {
      if (at.reach.distance_to(one.centre()) < static_cast<f64>(at.asked.rule.distance_or(FAR_FROM_OPENING_MM))) return false;
    }
    return true;
  }

  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override {
    return own.rect.distance_to(other.rect) >= static_cast<f64>(fit.asked.rule.distance_or(FAR_MM));
  }

 private:
  static constexpr i64 FAR_MM = 2000, FAR_FROM_OPENING_MM = 1500;

  bool doors_;
};

}  // namespace furnish
