#include "furnish/relations/knee_room.hpp"

namespace furnish {

// How far apart, seen from above, two parts are kept.
constexpr i64 CLEAR_MM = 5;

static Rect turned_rect(const Rect& rect, i32 turn) {
  const Point a = rotated({rect.x0, rect.z0}, turn), b = rotated({rect.x1, rect.z1}, turn);
  return {least(a.x, b.x), least(a.z, b.z), most(a.x, b.x), most(a.z, b.z)};
}

// Without those that another covers; of equals the first stays.
static List<Rect> without_covered(const List<Rect>& rects) {
  List<Rect> found;
  for (i32 k = 0; k < rects.size(); k++) {
    bool covered = false;
    for (i32 j = 0; j < rects.size() && !covered; j++) {
      covered = j != k && rects[j].contains(rects[k]) && (j < k || rects[j] != rects[k]);
    }
    if (!covered) found.add(rects[k]);
  }
  return found;
}

List<Rect> blocked_places(Span<PartBox> parent, Span<PartBox> own, i32 turn) {
  List<Rect> all;
  for (const PartBox& mine : own) {
    const Rect at = turned_rect(mine.rect, turn);
    for (const PartBox& its : parent) {
      if (mine.low >= its.high || its.low >= mine.high) continue;
      const Rect crossing{its.rect.x0 - at.x1, its.rect.z0 - at.z1, its.rect.x1 - at.x0, its.rect.z1 - at.z0};
      all.add(crossing.shrunk(-CLEAR_MM));
    }
  }
  stable_sort(all.all(), goes_before);
  return without_covered(all);
}

// The largest rectangles that a hole leaves of some.
static List<Rect> cut_by(const Rect& hole, const List<Rect>& rects) {
  List<Rect> cut;
  for (const Rect& rect : rects) {
    if (!hole.overlaps(rect)) {
      cut.add(rect);
      continue;
    }
    const Rect sides[] = {
      {rect.x0, rect.z0, hole.x0, rect.z1}, {hole.x1, rect.z0, rect.x1, rect.z1},
      {rect.x0, rect.z0, rect.x1, hole.z0}, {rect.x0, hole.z1, rect.x1, rect.z1},
    };
    for (const Rect& side : sides) {
      if (side.x0 <= side.x1 && side.z0 <= side.z1) cut.add(side);
    }
  }
  return cut;
}

static bool is_larger(const Rect& a, const Rect& b) {
  const i64 area_a = a.width() * a.depth(), area_b = b.width() * b.depth();
  if (area_a != area_b) return area_a > area_b;
  const i64 girth_a = a.width() + a.depth(), girth_b = b.width() + b.depth();
  return girth_a != girth_b ? girth_a > girth_b : goes_before(a, b);
}

List<Rect> free_of(const Rect& places, const List<Rect>& blocked) {
  List<Rect> left;
  left.add(places);
  for (const Rect& hole : blocked) left = without_covered(cut_by(hole, left));
  stable_sort(left.all(), is_larger);
  return left;
}

// The part of an interval that is nearest to another one.
static Interval part_towards(Interval span, Interval wish) {
  const i64 low = most(span.low, wish.low), high = least(span.high, wish.high);
  if (low <= high) return {low, high};
  return span.low > wish.high ? Interval{span.low, span.low} : Interval{span.high, span.high};
}

static i64 gap_to(Interval span, Interval wish) { return most<i64>(0, most(span.low - wish.high, wish.low - span.high)); }

static List<Rect> found_free(const Rect& wish, const Rect& reach, const List<Rect>& blocked, bool sideways) {
  List<Rect> found = free_of(wish, blocked);
  if (found.size() > 0) return found;
  struct Ranked {
    Rect rect;
    i64 first, second;
  };
  List<Ranked> near;
  const Interval wish_x{wish.x0, wish.x1}, wish_z{wish.z0, wish.z1};
  for (const Rect& place : free_of(reach, blocked)) {
    const Interval x = part_towards({place.x0, place.x1}, wish_x), z = part_towards({place.z0, place.z1}, wish_z);
    const i64 away_x = gap_to(x, wish_x), away_z = gap_to(z, wish_z);
    near.add({{x.low, z.low, x.high, z.high}, sideways ? away_x : away_z, sideways ? away_z : away_x});
  }
  const auto is_nearer = [](const Ranked& a, const Ranked& b) { return a.first != b.first ? a.first < b.first : a.second < b.second; };
  const Ranked* best = nullptr;
  for (const Ranked& one : near) {
    if (best == nullptr || is_nearer(one, *best)) best = &one;
  }
  for (const Ranked& one : near) {
    if (!is_nearer(*best, one)) found.add(one.rect);
  }
  return found;
}

const List<Rect>& KneeRoom::blocked(const TurnedPair& pair) {
  for (const Blocked& one : blocked_) {
    if (one.pair == pair) return one.places;
  }
  const Kind& parent = type_.kinds[pair.parent];
  const Kind& own = type_.kinds[pair.own];
  return blocked_.add({pair, blocked_places(type_.parts_of(parent), type_.parts_of(own), pair.turn)}).places;
}

const List<Rect>& KneeRoom::nearest_free(const TurnedPair& pair, const Rect& wish, const Rect& reach) {
  for (const Answer& one : answers_) {
    if (one.pair == pair && one.wish == wish && one.reach == reach) return one.places;
  }
  return answers_.add({pair, wish, reach, found_free(wish, reach, blocked(pair), pair.sideways)}).places;
}

}  // namespace furnish
