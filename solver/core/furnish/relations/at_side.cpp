#include "furnish/relations/at_side.hpp"

namespace furnish {

// What each later side in a relation's list costs more than the one before it.
constexpr f64 SIDE_COST = 0.05;

// How much of a tucked piece's depth stays outside the other where places are sought.
constexpr i64 UNTUCKED_MM = 160;
// How far a free space between two pieces may be from the one that is asked for.
constexpr i64 GAP_MM = 20;
// Most rectangles that are sought of the places where a piece can reach under another one.
constexpr i32 MOST_PLACES = 4;

static bool is_end(Align align) { return align == Align::back || align == Align::front; }

DoubleBox beside(Extent parent, Extent own, Side side, Interval gap, Align align, const Tolerance& tolerance) {
  const bool lateral = is_lateral(side);
  const i64 touching = lateral ? parent.x + own.x : parent.z + own.z;
  const i64 sign = side == Side::left || side == Side::back ? -1 : 1;
  const i64 one = sign * (touching + 2 * gap.low), other = sign * (touching + 2 * gap.high);
  const Interval away{least(one, other), most(one, other)};
  if (lateral) return {away, lined_up(parent.z, own.z, align, tolerance)};
  return {lined_up(parent.x, own.x, is_end(align) ? Align::none : align, tolerance), away};
}

Rect at_side(Extent parent, Extent own, Side side, Interval gap, Align align) {
  return rounded(beside(parent, own, side, gap, align, EXACT));
}

void AtSide::boxes(const Fit& fit, List<DoubleBox>& found) const {
  const Span<Side> named = fit.asked.sides;
  for (i32 k = 0; k < (named.size ? named.size : meaning_.side_count); k++) {
    const Side side = named.size ? named[k] : meaning_.sides[k];
    if (!meaning_.looks || towards(side) == fit.turn) add_boxes(fit, side, found);
  }
}

void AtSide::add_boxes(const Fit& fit, Side side, List<DoubleBox>& found) const {
  const Rule& rule = fit.asked.rule;
  const Tolerance& tolerance = fit.asked.tolerance;
  const bool lateral = is_lateral(side);
  const bool any_will_do = !tolerance.judged && !rule.has_gap && rule.align == Align::none;
  const Align best = lateral || meaning_.best == Align::none ? meaning_.best : Align::centre;
  if (best != Align::none && any_will_do && !(meaning_.best == Align::back && fit.turn)) {
    found.add(beside(fit.parent, fit.own, side, {meaning_.gap, meaning_.gap}, best, EXACT));
  }
  Interval gap = asked_gap(fit);
  if (tolerance.judged) gap.low = most(gap.low, 1 - (lateral ? fit.own.x : fit.own.z));
  if (gap.low > gap.high) return;
  add_free(fit, gap, beside(fit.parent, fit.own, side, gap, rule.align, tolerance), found);
}

void AtSide::add_seat_box(const Fit& fit, List<DoubleBox>& found) const {
  const Side side = fit.setting.side;
  const i64 middle = fit.setting.middle, room = fit.setting.half - 2 * fit.asked.tolerance.inside;
  const Interval gap = slot_gap(fit.asked.rule), doubled{middle - room, middle + room};
  DoubleBox box = beside(fit.parent, fit.own, side, gap, Align::centre, EXACT);
  (is_lateral(side) ? box.along : box.across) = doubled;
  List<DoubleBox> places;
  add_free(fit, gap, box, places);
  for (DoubleBox& place : places) {
    Interval& part = is_lateral(side) ? place.along : place.across;
    const i64 half = least(middle - part.low, part.high - middle);
    if (half < 0) continue;
    part = {middle - half, middle + half};
    place.is_seat = true;
    found.add(place);
  }
}

void AtSide::add_free(const Fit& fit, Interval gap, const DoubleBox& box, List<DoubleBox>& found) {
  const List<Rect> blocked = gap.low < 0 ? blocked_places(fit.parent_parts, fit.parts, fit.turn) : List<Rect>{};
  if (blocked.size() == 0) return static_cast<void>(found.add(box));
  List<Rect> places = free_of(rounded(box), blocked);
  places.cut(MOST_PLACES);
  for (const Rect& place : places) found.add({{2 * place.x0, 2 * place.x1}, {2 * place.z0, 2 * place.z1}});
}

// The free space with which it holds, or is sought; none (low above high) where it does not reach under what it is to reach under.
Interval AtSide::asked_gap(const Fit& fit) const {
  const Rule& rule = fit.asked.rule;
  const bool judged = fit.asked.tolerance.judged;
  const i64 more = judged ? GAP_MM : 0;
  Interval gap = judged ? meaning_.held : meaning_.sought;
  if (rule.has_gap) gap = {rule.gap.low - more, rule.gap.high + more};
  if (meaning_.least_tucked == 0) return gap;
  if (judged) return {gap.low, least<i64>(gap.high, -1)};
  gap.low = most(gap.low, UNTUCKED_MM - (fit.turn % 180 == 0 ? fit.own.z : fit.own.x));
  return gap.high < 0 ? gap : Interval{0, -1};
}

Span<const Side> AtSide::sides(const Subject& subject, const Rule& rule) const {
  const Span<Side> named = part_of(subject.type.sides, rule.sides);
  return named.size ? Span<const Side>{named.data, named.size} : Span<const Side>{meaning_.sides, meaning_.side_count};
}

Interval AtSide::slot_gap(const Rule& rule) const { return rule.has_gap ? rule.gap : Interval{meaning_.gap, meaning_.gap}; }

void AtSide::effect(const Subject& subject, const Rule& rule, Effect& effect) const {
  add_slots(subject, rule, meaning_.looks || subject.faces(subject.type.of(rule)), effect);
  const i32 piece = subject.first(rule);
  if (rule.wall != Walls::any && piece >= 0) add_asking(effect, rule, piece, rule.wall);
}

void AtSide::add_slots(const Subject& subject, const Rule& rule, bool turn, Effect& effect) const {
  const List<Parent> parents = subject.parents(rule);
  const Span<const Side> wished = sides(subject, rule);
  for (const Variant& variant : subject.variants) {
    for (const Parent& parent : parents) {
      for (i32 order = 0; order < wished.size; order++) {
        const Side side = wished[order];
        const Pair pair{parent, variant.kind, turn ? towards(side) : 0, side};
        add_at(subject, rule, pair, variant.cost + SIDE_COST * order, effect);
      }
    }
  }
}

void AtSide::add_at(const Subject& subject, const Rule& rule, const Pair& pair, f64 cost, Effect& effect) const {
  const Interval gap = slot_gap(rule);
  Align align = rule.align != Align::none ? rule.align : is_lateral(pair.side) ? Align::back : Align::centre;
  if (is_end(align) && !is_lateral(pair.side)) align = Align::centre;
  const Extent parent = subject.type.kinds[pair.parent.kind].size(), own = turned(subject.type.kinds[pair.kind].size(), pair.rotation);
  Candidate slot = free_candidate(pair.kind, cost);
  slot.slot = Slot::side;
  const Rect wish = at_side(parent, own, pair.side, gap, align), near = at_side(parent, own, pair.side, gap, Align::none);
  add_places(subject, pair, slot, gap, wish, near, effect);
}

void AtSide::add_places(
    const Subject& subject, const Pair& pair, Candidate slot, Interval gap, const Rect& wish, const Rect& near, Effect& effect) const {
  slot.rotation = pair.rotation;
  slot.parent = pair.parent.piece;
  slot.parent_kind = pair.parent.kind;
  slot.slot_side = pair.side;
  slot.is_under = gap.low < 0;
  List<Rect> places;
  if (slot.is_under) places = tucked(subject, pair, wish, near);
  else places.add(wish);
  for (const Rect& place : places) {
    slot.across = {place.x0, place.x1};
    slot.along = {place.z0, place.z1};
    effect.slots.add(slot);
  }
}

const List<Rect>& AtSide::tucked(const Subject& subject, const Pair& pair, const Rect& wish, const Rect& near) const {
  const RoomType& type = subject.type;
  const Kind& parent = type.kinds[pair.parent.kind];
  const Kind& own = type.kinds[pair.kind];
  const Interval gap{meaning_.least_tucked, meaning_.least_tucked};
  const Rect out = at_side(parent.size(), turned(own.size(), pair.rotation), pair.side, gap, Align::centre);
  const bool sideways = is_lateral(pair.side);
  Rect reach = near;
  if (sideways) {
    reach.x0 = least(near.x0, out.x0);
    reach.x1 = most(near.x1, out.x1);
  } else {
    reach.z0 = least(near.z0, out.z0);
    reach.z1 = most(near.z1, out.z1);
  }
  return subject.knee_room.nearest_free({pair.parent.kind, pair.kind, pair.rotation, sideways}, wish, reach);
}

}  // namespace furnish
