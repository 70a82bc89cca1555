#include "furnish/relations/openings.hpp"

namespace furnish {

bool names_opening(Span<Name> names) {
  for (const Name& name : names) {
    if (name.opening != Opening::none) return true;
  }
  return false;
}

List<Opened> openings_named(const Scope& scope, Span<Name> names, bool doors) {
  List<Opened> found;
  const auto add = [&](Opening kind) {
    for (const Opened& one : scope.openings) {
      if (Scope::is(one, kind)) found.add(one);
    }
  };
  if (doors) add(Opening::door);
  for (const Name& name : names) {
    if (!doors && name.opening != Opening::none) add(name.opening);
  }
  return found;
}

void measure_from(const Subject& subject, Span<Name> names, bool doors, Effect& effect) {
  for (const Opened& one : openings_named(subject.scope, names, doors)) effect.points.add(one.centre());
  effect.has_cost = effect.points.size() > 0;
}

f64 off_distance(const Subject& subject, const Effect& effect, const Candidate& candidate, i64 usual, Off which) {
  constexpr i64 LEAST_MM = 10;
  const Rect rect = subject.footprint(candidate);
  f64 nearest = INFINITE;
  for (const Point& point : effect.points) nearest = least(nearest, rect.distance_to(point));
  const f64 wished = static_cast<f64>(most(effect.rule->distance_or(usual), LEAST_MM)) / 1000.0;
  const f64 beyond = nearest / 1000.0 - wished;
  const f64 off = which == Off::beyond ? beyond : -beyond;
  return off > 0.0 ? effect.rule->missed() * least(1.0, off / wished) : 0.0;
}

}  // namespace furnish
