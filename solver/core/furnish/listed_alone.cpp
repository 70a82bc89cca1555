// How a listed piece may be turned and at which wall its back may be, and where in the room it then holds which relations.
#include "furnish/candidates.hpp"
#include "furnish/listed.hpp"
#include "plain/rounding.hpp"

namespace furnish {

// What standing in the middle of the room costs a piece that may also stand at a wall; and elsewhere than in its own part of the floor.
constexpr f64 FREE_COST = 0.2, ELSEWHERE = 1.0;

Candidate Seeker::way(Stance stance, f64 cost, f64 weight) const {
  Candidate made = free_candidate(row().kind, rounded_6(cost));
  made.rotation = stance.rotation;
  made.stance = stance_number(stance.rotation, stance.wall);
  made.weight = weight;
  return made;
}

f64 Seeker::share(const Bond& pair) const {
  bool is_only = in.kept.is_sure;
  for (const Bond& one : pairs) is_only = is_only && one.earlier.size() == 1 && one.earlier[0] == pair.earlier[0];
  return pair.relation().by_degree && !is_only ? UNSURE : 1.0;
}

bool fits_both(const Rect& a, const Rect& b, Extent extent, Rect& shared) {
  shared = a.common(b);
  return shared.width() >= extent.x && shared.depth() >= extent.z;
}

// The cheapest, the largest first, without what lies within a rectangle that costs no more.
static List<Costed> cheapest(Seeker& seeker, const List<Costed>& found, i64 most) {
  stable_sort(found.all(), [](const Costed& a, const Costed& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.rect.width() * a.rect.depth() > b.rect.width() * b.rect.depth();
  });
  List<Costed> best;
  for (const Costed& one : found) {
    if (one.cost == INFINITE) break;
    bool is_within = false;
    for (i32 i = 0; i < best.size() && !is_within; i++) is_within = best[i].rect.contains(one.rect);
    if (is_within) continue;
    if (best.size() == most) {
      seeker.drop(one.cost);
      break;
    }
    best.add(one);
  }
  return best;
}

List<Costed> with_rule(Seeker& seeker, const List<Costed>& found, const Rule& rule, const List<Costed>& held, Extent extent, i64 most) {
  List<Costed> both;
  Rect shared;
  for (const Costed& one : found) {
    for (const Costed& other : held) {
      if (fits_both(one.rect, other.rect, extent, shared)) both.add({shared, one.cost + other.cost});
    }
  }
  for (const Costed& one : found) both.add({one.rect, one.cost + rule.missed()});
  return cheapest(seeker, both, most);
}

static List<Costed> places_of(Seeker& seeker, const Foothold& at) {
  List<Costed> found;
  if (at.reach.width() >= at.extent.x && at.reach.depth() >= at.extent.z) found.add({at.reach, 0.0});
  for (const Rule* rule : seeker.to_room) {
    List<Rect> regions;
    List<Costed> held;
    const Asked asked = seeker.in.asked(*rule);
    relation_of(rule->word).regions({asked, seeker.in.scope, at.stance.rotation, at.stance.wall, at.extent, at.reach}, regions);
    for (const Rect& region : regions) held.add({region, 0.0});
    found = with_rule(seeker, found, *rule, held, at.extent, seeker.in.kept.rects);
  }
  return found;
}

// Adds what is before the edges of parts missing from the room: walls, too, for what stands at walls.
static void add_inner_edges(const Scope& scope, const Kind& kind, List<Foothold>& found) {
  Rect shared;
  for (const Zone& zone : scope.zones) {
    for (Wall wall : WALLS) {
      if (!zone.is_wall) continue;
      const Extent extent = turned(kind.size(), rotation_at(wall));
      const Interval edge = zone.rect.along(wall);
      const Interval over = {edge.low - floor_div(kind.width, 2), edge.high + floor_div(kind.width, 2)};
      const Rect reach = strip_at(wall, zone.rect.line(opposite(wall)) + inwards(wall) * scope.gap, over, kind.depth);
      if (fits_both(reach, scope.clear, extent, shared)) found.add({{rotation_at(wall), Wall::none}, extent, shared, {}});
    }
  }
}

List<Foothold> footholds(Seeker& seeker) {
  const Scope& scope = seeker.in.scope;
  const Kind& kind = seeker.kind();
  bool at_walls = kind.at_walls, turns = false;
  for (const Rule& rule : part_of(seeker.in.type.rules, seeker.row().rules)) {
    at_walls = at_walls || relation_of(rule.word).at_walls;
    turns = turns || relation_of(rule.word).turns;
  }
  List<Foothold> found;
  Rect shared;
  for (Wall wall : WALLS) {
    const Extent extent = turned(kind.size(), rotation_at(wall));
    const Rect reach = strip_at(wall, scope.clear.line(wall) + inwards(wall) * scope.gap, scope.clear.along(wall), kind.depth);
    if (at_walls && fits_both(reach, scope.clear, extent, shared)) found.add({{rotation_at(wall), wall}, extent, reach, {}});
  }
  if (kind.at_walls) add_inner_edges(scope, kind, found);
  const i32 free_turns = kind.at_walls ? 0 : turns ? 4 : rotation_count(kind);
  for (i32 i = 0; i < free_turns; i++) found.add({{90 * i, Wall::none}, turned(kind.size(), 90 * i), scope.clear, {}});
  for (Foothold& one : found) one.found = places_of(seeker, one);
  return found;
}

void add_alone(const Seeker& seeker, Span<Foothold> footholds, List<Candidate>& found) {
  f64 unsure = 0.0;
  for (const Bond& pair : seeker.pairs) {
    unsure += pair.rule->required ? GONE : pair.rule->cost * seeker.share(pair);
  }
  for (const Foothold& at : footholds) {
    const bool is_free = at.stance.wall == Wall::none, has_part = is_free && seeker.row().at != Rect{};
    List<Costed> rects;
    Rect own;
    if (has_part && fits_both(at.reach, seeker.row().at, at.extent, own)) rects.add({own, 0.0});
    for (const Costed& one : at.found) rects.add({one.rect, one.cost + (has_part ? ELSEWHERE : 0.0)});
    for (const Costed& one : rects) {
      Candidate& made = found.add(seeker.way(at.stance, one.cost + unsure + (is_free ? FREE_COST : 0.0), LOOSE));
      made.wall = at.stance.wall;
      made.anchor = one.rect.centre();
      made.within = one.rect;
    }
  }
}

}  // namespace furnish
