// `facing`: its front is turned to another piece or to an opening.
#pragma once

#include "furnish/relations/openings.hpp"

namespace furnish {

// What it costs to stand past the ends of a garage door that is faced, of what it costs not to face it: one drives straight in.
constexpr f64 PAST_GATE_SHARE = 0.3;

// Tells whether the slots of another relation of the piece to those it faces turn it already.
static bool slots_turn_it(const Subject& subject, const Rule& rule) {
  for (const Rule& other : subject.rules) {
    const Word word = other.word;
    const bool at_side = word == Word::beside || word == Word::in_front_of || word == Word::around || word == Word::under;
    if (at_side && share_a_name(subject.type.of(other), subject.type.of(rule))) return true;
  }
  return false;
}

// Tries the places right behind a garage door, at both its ends.
static void add_behind(const Subject& subject, const Opened& gate, Effect& effect) {
  for (const Variant& variant : subject.variants) {
    const Kind& kind = subject.type.kinds[variant.kind];
    const i64 half = floor_div(kind.width, 2), into = subject.scope.gap + floor_div(kind.depth, 2);
    if (gate.stretch.high - gate.stretch.low < kind.width) continue;
    const i64 ends[] = {gate.stretch.low + half, gate.stretch.high - half};
    for (const i64 along : ends) effect.spots.add({variant.kind, 0, subject.scope.clear.point_at(gate.wall, along, into)});
  }
}

// The garage door, of those that are faced, before which a candidate stands within its ends; null where there is none. What stands at
// another piece does so before any.
static const Opened* gate_before(const Subject& subject, const Effect& effect, const Candidate& candidate) {
  const Wall ahead = wall_ahead(candidate.rotation);
  const Interval own = subject.footprint(candidate).along(ahead);
  for (const Opened& one : subject.scope.openings) {
    if (one.kind != Opening::garage_door || !effect.gates) continue;
    if (candidate.parent >= 0 || (one.wall == ahead && one.stretch.low <= own.low && own.high <= one.stretch.high)) return &one;
  }
  return nullptr;
}

// The places from which a piece with that turn has the other's centre before it, so far off and aside, doubled.
static DoubleBox before(i32 turn, i64 off, i64 half) {
  const Point ahead = facing(turn);
  const Interval side{-half, half}, along = ahead.x + ahead.z > 0 ? Interval{-NO_END, -off} : Interval{off, NO_END};
  return ahead.x ? DoubleBox{along, side} : DoubleBox{side, along};
}

// Distances of the other's middle at which places are sought from where it lies within half a right angle of the front.
constexpr i64 AHEAD_MM[] = {250, 700, 1500};

class Facing : public Relation {
 public:
  constexpr Facing() { turns = true; }

  // Asks for the turn; to an opening, for being turned to its wall.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    if (names_opening(subject.type.of(rule))) {
      for (const Opened& one : openings_named(subject.scope, subject.type.of(rule), false)) {
        effect.walls |= 1ULL << static_cast<i32>(one.wall);
        if (one.kind != Opening::garage_door) continue;
        effect.gates = true;
        add_behind(subject, one, effect);
      }
      effect.has_cost = effect.walls != 0;
      return;
    }
    const i32 piece = subject.first(rule);
    if (piece < 0 || slots_turn_it(subject, rule)) return;
    add_asking(effect, rule, piece, Walls::any).turn = LOOKS_AT;
  }

  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override {
    const i32 ahead = static_cast<i32>(wall_ahead(candidate.rotation));
    if (!(effect.walls >> ahead & 1)) return effect.rule->missed();
    return effect.gates && !gate_before(subject, effect, candidate) ? PAST_GATE_SHARE * effect.rule->cost : 0.0;
  }

  // What stands before a garage door stays within its ends.
  void keep(const Subject& subject, const Effect& effect, Candidate& candidate) const override {
    const Opened* gate = gate_before(subject, effect, candidate);
    if (!gate) return;
    Rect within = subject.scope.clear;
    if (runs_along_x(gate->wall)) {
      within.x0 = most(within.x0, gate->stretch.low), within.x1 = least(within.x1, gate->stretch.high);
    } else {
      within.z0 = most(within.z0, gate->stretch.low), within.z1 = least(within.z1, gate->stretch.high);
    }
    hold(candidate, within);
  }

  // Anywhere, turned to the wall of an opening.
  void regions(const Footing& at, List<Rect>& found) const override {
    for (const Opened& one : openings_named(at.scope, at.asked.of, false)) {
      if (one.wall == wall_ahead(at.rotation)) return static_cast<void>(found.add(at.reach));
    }
  }

  // Straight before the own front, or within half a right angle of it at several distances of the other's middle.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const bool level = fit.turn % 180 == 0;
    const i64 aside = (level ? fit.parent.x : fit.parent.z) - 2 * fit.asked.tolerance.inside;
    const Extent touching = fit.touching();
    if (aside > 0) found.add(before(fit.turn, (level ? touching.z : touching.x) + fit.spare(), aside));
    for (i64 ahead : AHEAD_MM) found.add(before(fit.turn, 2 * ahead + fit.spare(), 2 * (ahead - 10)));
  }

  // The other's middle lies before its front, no farther aside than ahead; or the other straight before it.
  bool holds_with(const Fit&, const Standing& own, const Standing& other) const override {
    const Point d = facing(own.rotation), way = other.double_way_from(own);
    const i64 ahead = way.x * d.x + way.z * d.z, aside = magnitude(way.x * d.z) + magnitude(way.z * d.x);
    const Rect &a = own.rect, &b = other.rect;
    const i64 reach = d.x ? a.width() + b.width() : a.depth() + b.depth();
    return (aside <= ahead && ahead > 0) || (ahead >= reach && aside <= (d.x ? b.depth() : b.width()));
  }
};

}  // namespace furnish
