#include "floor/nearest.hpp"

#include "plain/lists.hpp"

namespace {

// The places of the box's corner at which it overlaps an obstacle: between, not at, these.
struct Taken {
  Interval x;
  Interval z;
};

struct Axis {
  i64 wish;
  i64 low;
  i64 high;

  bool holds(i64 at) const { return low <= at && at <= high; }
  // Tells whether something taken holds a place that is no farther from the wish than the reach.
  bool is_in_way(const Interval& taken, i64 reach) const {
    return taken.low < least(high, wish + reach) && most(low, wish - reach) < taken.high;
  }
  bool goes_before(i64 a, i64 b) const {
    const i64 far = magnitude(a - wish), farther = magnitude(b - wish);
    return far != farther ? far < farther : a < b;
  }
};

constexpr i64 MOST_MM2 = 0x7FFFFFFFFFFFFFFFLL;
constexpr i64 FARTHEST_MM = 1LL << 40;  // farther than anything

}  // namespace

// The coordinates worth trying along x beside the wish itself, nearest first: the bounds, and the ends of what is taken. Those whose square
// of the distance is no less than a limit are not.
static List<i64> steps_of(const Axis& axis, Span<Taken> taken, i64 limit) {
  List<i64> tried;
  const auto add = [&](i64 at) {
    if (axis.holds(at) && (at - axis.wish) * (at - axis.wish) < limit) tried.add(at);
  };
  add(axis.low);
  add(axis.high);
  for (const Taken& one : taken) {
    add(one.x.low);
    add(one.x.high);
  }
  stable_sort(tried.all(), [&](i64 a, i64 b) { return axis.goes_before(a, b); });
  return tried;
}

struct NearestPoint {
  bool found;
  i64 at;
};

// The free coordinate along z nearest to the wish, with the corner at an x. What is taken comes by its low ends: what another one moves a
// place into lies ahead, whichever way that goes.
static NearestPoint free_beside(const Axis& axis, i64 x, Span<Taken> taken) {
  i64 up = least(most(axis.wish, axis.low), axis.high), down = up;
  for (const Taken& one : taken) {
    if (one.x.low < x && x < one.x.high && one.z.low < up && up < one.z.high) up = one.z.high;
  }
  for (i32 k = taken.size - 1; k >= 0; k--) {
    const Taken& one = taken[k];
    if (one.x.low < x && x < one.x.high && one.z.low < down && down < one.z.high) down = one.z.low;
  }
  const bool has_up = axis.holds(up), has_down = axis.holds(down);
  return {has_up || has_down, has_up && (!has_down || axis.goes_before(up, down)) ? up : down};
}

NearestPlace nearest_place(const Rect& own, const Rect& area, Span<Rect> blocks, i64 reach) {
  const arena::Scope scope;
  const Axis xs{own.x0, area.x0, area.x1 - own.width()}, zs{own.z0, area.z0, area.z1 - own.depth()};
  List<Taken> taken;
  const i64 window = reach == ANYWHERE ? FARTHEST_MM : reach;
  for (const Rect& rect : blocks) {
    const Taken own_places{{rect.x0 - own.width(), rect.x1}, {rect.z0 - own.depth(), rect.z1}};
    if (xs.is_in_way(own_places.x, window) && zs.is_in_way(own_places.z, window)) taken.add(own_places);
  }
  stable_sort(taken.all(), [](const Taken& a, const Taken& b) { return a.z.low < b.z.low; });
  i64 limit = reach == ANYWHERE ? MOST_MM2 : reach * reach + 1;
  NearestPlace best{};
  const auto look_at = [&](i64 x) {
    const i64 aside = (x - own.x0) * (x - own.x0);
    const NearestPoint z = free_beside(zs, x, taken.all());
    const i64 away = aside + (z.at - own.z0) * (z.at - own.z0);
    if (!z.found || away >= limit) return;
    best = {true, own.moved(x - own.x0, z.at - own.z0)};
    limit = away;
  };
  if (xs.holds(own.x0)) look_at(own.x0);
  for (const i64 x : steps_of(xs, taken.all(), limit)) {
    if ((x - own.x0) * (x - own.x0) >= limit) break;
    look_at(x);
  }
  return best;
}
