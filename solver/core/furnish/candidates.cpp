#include "furnish/candidates.hpp"

namespace furnish {

// What a place at a wall costs where an earlier piece is meant to stand: it may not be taken after all.
constexpr f64 INTENDED_COST = 0.3;

constexpr bool NO_YES[] = {false, true}, YES_NO[] = {true, false};
constexpr i64 ODD_QUARTERS[] = {1, 3};

Candidate at_wall(const Scope& scope, const RoomType& type, i32 kind, Wall wall, i64 middle, f64 cost) {
  Candidate made = free_candidate(kind, cost);
  made.rotation = rotation_at(wall);
  made.wall = wall;
  made.anchor = scope.clear.point_at(wall, middle, scope.gap + floor_div(type.kinds[kind].depth, 2));
  return made;
}

// Adds the centres to try in one clear stretch of a wall: what the relations propose, its ends and its middle.
static void add_in_stretch(const Scope& scope, const Position& of, Interval stretch, i64 width, Span<Effect> effects, List<i64>& found) {
  const Interval clear = scope.clear.along(of.wall);
  const i64 half = floor_div(width, 2), spare = stretch.high - stretch.low - width;
  if (spare < 0) return;
  const i64 gap = least(scope.gap, spare), first = stretch.low + half, last = stretch.high - half;
  for (const Effect& effect : effects) {
    for (const Position& one : effect.positions) {
      if (one.wall == of.wall && one.kind == of.kind) add_new(found, least(most(one.along, first), last));
    }
  }
  add_new(found, first + (stretch.low == clear.low ? gap : 0));
  add_new(found, last - (stretch.high == clear.high ? gap : 0));
  add_new(found, stretch.middle());
}

// Adds the places of a variant along a wall: clear of where earlier pieces are meant to stand, else of what is there for certain.
static void add_at_wall(const Subject& subject, const WallOccupancy& walls, const Variant& variant, Wall wall, Span<Effect> effects,
                        List<Candidate>& found) {
  const Kind& kind = subject.type.kinds[variant.kind];
  for (bool occupied : YES_NO) {
    List<i64> centres;
    for (const Interval& stretch : walls.stretches(wall, kind, occupied)) {
      add_in_stretch(subject.scope, {wall, variant.kind, 0}, stretch, kind.width, effects, centres);
    }
    const f64 cost = variant.cost + (occupied ? 0.0 : INTENDED_COST);
    for (i64 centre : centres) found.add(at_wall(subject.scope, subject.type, variant.kind, wall, centre, cost));
    if (centres.size() > 0) return;
  }
}

i32 rotation_count(const Kind& kind) {
  if (kind.use_count > 0 && kind.use_count < 4) return 4;
  return kind.width == kind.depth ? 1 : 2;
}

static void add_turned(const Subject& subject, const Variant& variant, Point at, List<Candidate>& found) {
  const i32 count = rotation_count(subject.type.kinds[variant.kind]);
  for (i32 i = 0; i < count; i++) {
    Candidate& made = found.add(free_candidate(variant.kind, variant.cost));
    made.rotation = 90 * i;
    made.anchor = at;
  }
}

// Adds a variant in each corner, the usual gap from both its walls.
static void add_in_corners(const Subject& subject, const Variant& variant, List<Candidate>& found) {
  const Kind& kind = subject.type.kinds[variant.kind];
  const Rect inner = subject.scope.clear.shrunk(subject.scope.gap);
  const i32 count = rotation_count(kind);
  for (bool south : NO_YES) {
    for (bool east : NO_YES) {
      for (i32 i = 0; i < count; i++) {
        const Extent extent = turned(kind.size(), 90 * i);
        const i64 half_x = floor_div(extent.x, 2), half_z = floor_div(extent.z, 2);
        Candidate& made = found.add(free_candidate(variant.kind, variant.cost));
        made.rotation = 90 * i;
        made.anchor = {east ? inner.x1 - half_x : inner.x0 + half_x, south ? inner.z1 - half_z : inner.z0 + half_z};
      }
    }
  }
}

// Adds a variant in the room's middle and the middles of its quarters.
static void add_in_quarters(const Subject& subject, const Variant& variant, List<Candidate>& found) {
  const Rect& clear = subject.scope.clear;
  add_turned(subject, variant, clear.centre(), found);
  for (i64 z : ODD_QUARTERS) {
    for (i64 x : ODD_QUARTERS) {
      add_turned(subject, variant, {clear.x0 + floor_div(clear.width() * x, 4), clear.z0 + floor_div(clear.depth() * z, 4)}, found);
    }
  }
}

// Adds the free places of a variant: what the relations propose, else the room's middle and those of its quarters.
static void add_free(const Subject& subject, const Variant& variant, Span<Effect> effects, List<Candidate>& found) {
  const i32 before = found.size();
  bool corners = false;
  for (const Effect& effect : effects) {
    corners = corners || effect.corners;
    for (const Spot& spot : effect.spots) {
      if (spot.kind == variant.kind) add_turned(subject, variant, spot.at, found);
    }
  }
  if (corners) add_in_corners(subject, variant, found);
  if (found.size() == before) add_in_quarters(subject, variant, found);
}

List<Candidate> own_candidates(const Subject& subject, const WallOccupancy& walls, Span<Effect> effects) {
  List<Candidate> found;
  bool backs = false;
  for (const Effect& effect : effects) backs = backs || effect.backs;
  for (const Variant& variant : subject.variants) {
    const bool at_walls = subject.type.kinds[variant.kind].at_walls;
    for (Wall wall : WALLS) {
      if (at_walls || backs) add_at_wall(subject, walls, variant, wall, effects, found);
    }
    if (!at_walls) add_free(subject, variant, effects, found);
  }
  if (found.size() > 0) return found;
  for (const Variant& variant : subject.variants) {
    for (Wall wall : WALLS) {
      const i64 middle = subject.scope.clear.along(wall).middle();
      found.add(at_wall(subject.scope, subject.type, variant.kind, wall, middle, variant.cost));
    }
  }
  return found;
}

}  // namespace furnish
