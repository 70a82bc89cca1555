#include "furnish/room.hpp"

namespace furnish {

// Depth of the floor before a garage door where only cars are wished.
constexpr i64 GATE_MM = 1000;
// How far sill boards stand out into a room (solver/wall_fittings.py).
constexpr i64 SILL_PROUD_MM = 30;

WallOccupancy::WallOccupancy(const Scope& scope) : scope_(scope) {
  for (const Opened& one : scope.openings) {
    if (one.kind == Opening::garage_door) gates_.add(strip(scope.clear, one.wall, one.stretch, GATE_MM));
  }
}

static bool meets_any(const Rect& footprint, const List<Rect>& rects) {
  for (const Rect& rect : rects) {
    if (footprint.overlaps(rect)) return true;
  }
  return false;
}

bool WallOccupancy::is_occupied(const Rect& footprint) const { return meets_any(footprint, taken_); }

bool WallOccupancy::is_before_gate(const Rect& footprint) const { return meets_any(footprint, gates_); }

Rect opened_within(const Scope& scope, i64 height) {
  Rect within = scope.clear;
  bool above = false;
  for (const Zone& zone : scope.zones) above = above || (zone.above >= 0 && zone.above < height);
  for (const Opened& one : scope.openings) {
    if (!above || one.kind != Opening::window) continue;
    const Rect off = scope.clear.shrunk(SILL_PROUD_MM);
    switch (one.wall) {
      case Wall::north: within.z0 = off.z0; break;
      case Wall::south: within.z1 = off.z1; break;
      case Wall::east: within.x1 = off.x1; break;
      default: within.x0 = off.x0;
    }
  }
  return within;
}

List<Interval> WallOccupancy::stretches(Wall wall, const Kind& kind, bool occupied) const {
  const Rect& clear = scope_.clear;
  const i64 depth = least(kind.depth + scope_.gap, least(clear.width(), clear.depth()));
  const Rect reach = strip(clear, wall, clear.along(wall), depth);
  List<Interval> blocked;
  for (const Zone& zone : scope_.zones) {
    if (zone.above < kind.height && zone.rect.overlaps(reach)) blocked.add(zone.rect.along(wall));
  }
  for (const Rect& gate : gates_) {
    if (gate.overlaps(reach)) blocked.add(gate.along(wall));
  }
  if (occupied) {
    for (const Rect& rect : taken_) {
      if (rect.overlaps(reach)) blocked.add(rect.along(wall));
    }
  }
  return gaps_between(clear.along(wall), blocked.all());
}

}  // namespace furnish
