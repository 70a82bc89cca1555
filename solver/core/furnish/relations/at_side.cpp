#include "furnish/relations/at_side.hpp"

namespace furnish {

// What each later side in a relation's list costs more than the one before it.
constexpr f64 SIDE_COST = 0.05;

Rect at_side(Extent parent, Extent own, Side side, Interval gap, Align align) {
  const bool beside = is_lateral(side);
  const i64 touching = beside ? parent.x + own.x : parent.z + own.z;
  const i64 sign = side == Side::left || side == Side::back ? -1 : 1;
  const i64 one = sign * (touching + 2 * gap.low), other = sign * (touching + 2 * gap.high);
  const Interval away = rounded({least(one, other), most(one, other)});
  if (beside) {
    const Interval line = rounded(lined_up(parent.z, own.z, align));
    return {away.low, line.low, away.high, line.high};
  }
  const bool no_such_end = align == Align::back || align == Align::front;
  const Interval line = rounded(lined_up(parent.x, own.x, no_such_end ? Align::none : align));
  return {line.low, away.low, line.high, away.high};
}

Span<const Side> AtSide::sides(const Subject& subject, const Rule& rule) const {
  const Span<Side> named = part_of(subject.type.sides, rule.sides);
  return named.size ? Span<const Side>{named.data, named.size} : Span<const Side>{meaning_.sides, meaning_.side_count};
}

Interval AtSide::slot_gap(const Rule& rule) const { return rule.has_gap ? rule.gap : Interval{meaning_.gap, meaning_.gap}; }

void AtSide::effect(const Subject& subject, const Rule& rule, Effect& effect) const {
  add_slots(subject, rule, meaning_.looks || subject.faces(subject.type.of(rule)), effect);
  const i32 piece = subject.first(rule);
  if (rule.wall == Walls::any || piece < 0) return;
  Link& link = effect.links.add(link_to(rule, piece));
  link.walls = rule.wall;
  link.cost = rule.cost;
  link.required = rule.required;
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
  if ((align == Align::back || align == Align::front) && !is_lateral(pair.side)) align = Align::centre;
  const Extent parent = subject.type.kinds[pair.parent.kind].size(), own = turned(subject.type.kinds[pair.kind].size(), pair.rotation);
  const Rect wish = at_side(parent, own, pair.side, gap, align);
  Candidate slot = free_candidate(pair.kind, cost);
  slot.rotation = pair.rotation;
  slot.parent = pair.parent.piece;
  slot.parent_kind = pair.parent.kind;
  slot.slot = Slot::side;
  slot.slot_side = pair.side;
  slot.is_under = gap.low < 0;
  List<Rect> places;
  if (slot.is_under) places = tucked(subject, pair, wish, at_side(parent, own, pair.side, gap, Align::none));
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
