// `against_wall`: its back is at a wall; `walls` says what walls of each sort cost.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

// A wall is long, and those beside it short, from this ratio on: a square room has neither.
constexpr f64 LONGER = 1.15;
// What lying lengthwise under a window costs of what a window right behind does.
constexpr f64 ALONG_SHARE = 0.3;

// Tells whether an opening is what makes a wall one of a sort where a piece stands: a window behind it, a door across.
static bool makes(const Opened& one, Sort sort, Wall wall) {
  if (sort == Sort::window) return one.kind == Opening::window && one.wall == wall;
  return sort == Sort::across && one.kind != Opening::window && one.wall == opposite(wall);
}

// Tells whether a window is right behind a candidate, or a door straight across.
static bool is_before(Sort sort, const Subject& subject, const Candidate& candidate) {
  const Interval own = subject.footprint(candidate).along(candidate.wall);
  for (const Opened& one : subject.scope.openings) {
    if (makes(one, sort, candidate.wall) && one.stretch.low < own.high && own.low < one.stretch.high) return true;
  }
  return false;
}

// Tells whether a piece's long side lies before the middle of a window of another wall: a bed lengthwise under it.
static bool is_along_window(const Subject& subject, const Candidate& candidate) {
  const Rect rect = subject.footprint(candidate);
  const Kind& kind = subject.kind(candidate);
  if (kind.depth <= kind.width) return false;
  for (const Opened& one : subject.scope.openings) {
    if (one.kind != Opening::window || one.wall == candidate.wall) continue;
    const Interval side = rect.along(one.wall);
    const bool close = rect.wall_distance(one.wall, subject.scope.clear) <= 2 * subject.scope.gap;
    if (close && side.low < one.middle() && one.middle() < side.high) return true;
  }
  return false;
}

static bool has_opening(const Scope& scope, Wall wall, bool windows_too) {
  for (const Opened& one : scope.openings) {
    if (one.wall == wall && (windows_too || one.kind != Opening::window)) return true;
  }
  return false;
}

// Tells whether the wall behind a candidate is of a sort; only a window right behind it counts, or a door straight across.
static bool is_of(Sort sort, const Subject& subject, const Candidate& candidate) {
  const Scope& scope = subject.scope;
  const Wall wall = candidate.wall;
  const f64 width = static_cast<f64>(scope.clear.width()), depth = static_cast<f64>(scope.clear.depth());
  const f64 own = runs_along_x(wall) ? width : depth, other = runs_along_x(wall) ? depth : width;
  switch (sort) {
    case Sort::door: return has_opening(scope, wall, false);
    case Sort::plain: return !has_opening(scope, wall, true);
    case Sort::exterior: return scope.exterior >> static_cast<i32>(wall) & 1;
    case Sort::longer: return own > LONGER * other;
    case Sort::shorter: return other > LONGER * own;
    case Sort::window:
    case Sort::across: return is_before(sort, subject, candidate);
  }
  return false;
}

class AgainstWall : public Relation {
 public:
  constexpr AgainstWall() { at_walls = true; }

  void effect(const Subject&, const Rule&, Effect& effect) const override { effect.has_cost = effect.backs = true; }

  // What shuns windows or doors across stays beside them wherever else it is moved.
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override {
    if (candidate.wall == Wall::none) return;
    const Rect& clear = subject.scope.clear;
    const Interval own = subject.footprint(candidate).along(candidate.wall);
    for (const SortCost& sort : part_of(subject.type.sorts, effect.rule->sorts)) {
      if (sort.cost < SHUNNED || is_before(sort.sort, subject, candidate)) continue;
      Interval kept = clear.along(candidate.wall);
      for (const Opened& one : subject.scope.openings) {
        if (!makes(one, sort.sort, candidate.wall)) continue;
        if (one.stretch.high <= own.low) kept.low = most(kept.low, one.stretch.high);
        if (own.high <= one.stretch.low) kept.high = least(kept.high, one.stretch.low);
      }
      if (kept == clear.along(candidate.wall)) continue;
      const bool along_x = runs_along_x(candidate.wall);
      hold(candidate, along_x ? Rect{kept.low, clear.z0, kept.high, clear.z1} : Rect{clear.x0, kept.low, clear.x1, kept.high});
    }
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    if (candidate.wall == Wall::none) return effect.rule->missed();
    f64 sum = 0.0;
    for (const SortCost& sort : part_of(subject.type.sorts, effect.rule->sorts)) {
      if (is_of(sort.sort, subject, candidate)) {
        sum += sort.cost;
      } else if (sort.sort == Sort::window && is_along_window(subject, candidate)) {
        sum += ALONG_SHARE * sort.cost;
      }
    }
    return sum;
  }

  // At any wall.
  void regions(const Footing& at, List<Rect>& found) const override {
    if (at.wall != Wall::none) found.add(at.reach);
  }
};

}  // namespace furnish
