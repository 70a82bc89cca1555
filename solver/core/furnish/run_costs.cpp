#include "furnish/run_costs.hpp"

#include "plain/slivers.hpp"

namespace furnish {

// Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter than 4 feet
// or longer than 9 feet), and of the sum of its legs (at most 26 feet; 4 m is what three shortest legs come to).
constexpr f64 SHORTEST_LEG = 1.2, LONGEST_LEG = 2.7, LEAST_PERIMETER = 4.0, MOST_PERIMETER = 7.9;
// What a triangle costs that is not within these, and what a metre beyond them.
constexpr f64 BROKEN_COST = 8.0, LEG_COST = 8.0, PERIMETER_COST = 8.0;
// What a side without worktop costs where it is wanted (guidelines 11, 16 and 17: landing areas at sink, refrigerator and cooking
// surface), what stands alone across, and what belongs at an end within the worktop.
constexpr f64 LANDING_COST = 10.0, ALONE_COST = 20.0, END_COST = 6.0;
// Worktop that a cook wants, m (guideline 25: 158 inches of frontage), and what a metre less costs.
constexpr f64 WORKTOP = 4.0, WORKTOP_COST = 4.0;

// What a sliver between an end of a run and the wall there costs.
constexpr f64 SLIVER_COST = 4.0;

// Floor before a run that is not left to others (guideline 7: walkways of 36 inches), and beside its ends.
constexpr i64 BEFORE_MM = 700, ASIDE_MM = 600;

f64 row_cost(const Drawn& drawn) {
  const bool across = drawn.form == Form::opposite;
  const i32 size = drawn.items.size, first = drawn.first;
  f64 cost = across ? ALONE_COST * ((first == 1) + (size - first == 1)) : 0.0;
  for (i32 i = 0; i < size; i++) {
    const Item& own = *drawn.items[i].item;
    i32 landed = 0, within = 0;
    for (i32 k = most(i - 1, 0); k <= least(i + 1, size - 1); k++) {
      const Item& beside = *drawn.items[k].item;
      const bool turns = most(i, k) == first;
      landed += k != i && !turns && beside.worktop;
      within += k != i && !(turns && across) && !beside.end;
    }
    if (own.landing) cost += LANDING_COST * (2 - landed);
    if (own.end && within == 2) cost += END_COST;
  }
  return cost;
}

f64 worktop_cost(const RoomType& type, const Drawn& drawn) {
  i64 worktop = drawn.form == Form::corner ? -drawn.items[drawn.first].item->depth : 0;
  for (const Laid& laid : drawn.items) worktop += laid.item->worktop ? laid.item->width : 0;
  return type.worktop.size > 0 ? WORKTOP_COST * most(WORKTOP - static_cast<f64>(worktop) / 1000.0, 0.0) : 0.0;
}

f64 sliver_cost(const Scope& scope, const Drawn& drawn) {
  f64 cost = 0.0;
  for (const Leg& leg : drawn.legs) {
    const Interval ends = scope.clear.along(leg.wall), over = leg.over();
    const i64 gaps[] = {over.low - ends.low, ends.high - over.high};
    for (i64 gap : gaps) cost += leg.deepest > 0 && gap >= TOUCHING_MM && gap < SLIVER_MM ? SLIVER_COST : 0.0;
  }
  return cost;
}

// Where a cook works before a leg, and what keeps off its ends.
static Rect floor_at(const Scope& scope, const Leg& leg) {
  const auto [low, high] = leg.over();
  return strip(scope.clear, leg.wall, {low - ASIDE_MM, high + ASIDE_MM}, scope.gap + leg.deepest + BEFORE_MM);
}

// Where something of an extent may begin along an axis: in the middle, and right behind or before what is taken.
static List<i64> beginnings(Interval clear, i64 extent, const List<Rect>& taken, Wall along) {
  List<i64> found;
  found.add(floor_div(clear.low + clear.high - extent, 2));
  found.add(clear.low);
  found.add(clear.high - extent);
  for (const Rect& one : taken) {
    const Interval own = one.along(along);
    found.add(own.high);
    found.add(own.low - extent);
  }
  return found;
}

static bool is_free(const Rect& rect, const Rect& clear, const List<Rect>& taken) {
  for (const Rect& one : taken) {
    if (one.overlaps(rect)) return false;
  }
  return clear.contains(rect);
}

Candidate place_left(const Scope& scope, const Follower& follower, const Drawn& drawn) {
  List<Rect> taken;
  taken.add_all(follower.taken.all());
  for (const Leg& leg : drawn.legs) {
    if (leg.deepest > 0) taken.add(floor_at(scope, leg));
  }
  const Rect& clear = scope.clear;
  Candidate best = free_candidate(-1, 0.0);
  i64 nearest = 0;
  constexpr i32 WAYS_ROUND[] = {0, 90};
  for (i32 rotation : WAYS_ROUND) {
    const Extent floor = turned(follower.floor, rotation);
    const List<i64> rows = beginnings(clear.along(Wall::west), floor.z, taken, Wall::west);
    for (i64 x : beginnings(clear.along(Wall::north), floor.x, taken, Wall::north)) {
      for (i64 z : rows) {
        const Rect rect = {x, z, x + floor.x, z + floor.z};
        const Point at = rect.centre(), middle = clear.centre();
        const i64 away = most(magnitude(at.x - middle.x), magnitude(at.z - middle.z));
        if ((best.kind >= 0 && away >= nearest) || !is_free(rect, clear, taken)) continue;
        best.kind = follower.kind;
        best.rotation = rotation;
        best.anchor = at;
        nearest = away;
      }
    }
  }
  return best;
}

f64 triangle_cost(const RoomType& type, Span<Candidate> places) {
  List<Point> fronts;  // doubled
  for (i32 word : type.triangle) {
    const Candidate& place = places[word];
    if (place.kind < 0) continue;
    const Point ahead = facing(place.rotation);
    const i64 depth = type.kinds[place.kind].depth;
    fronts.add({2 * place.anchor.x + ahead.x * depth, 2 * place.anchor.z + ahead.z * depth});
  }
  f64 beyond = 0.0, around = 0.0;
  for (i32 i = 0; i < fronts.size(); i++) {
    for (i32 j = i + 1; j < fronts.size(); j++) {
      const f64 leg = length(fronts[i].x - fronts[j].x, fronts[i].z - fronts[j].z) / 2.0 / 1000.0;
      beyond += most(most(SHORTEST_LEG - leg, leg - LONGEST_LEG), 0.0);
      around += leg;
    }
  }
  const f64 off = most(most(LEAST_PERIMETER - around, around - MOST_PERIMETER), 0.0);
  const f64 cost = LEG_COST * beyond + PERIMETER_COST * off;
  return cost > 0.0 ? BROKEN_COST + cost : 0.0;
}

}  // namespace furnish
