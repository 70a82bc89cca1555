#include "furnish/furnisher.hpp"

#include "furnish/candidates.hpp"
#include "plain/rounding.hpp"

namespace furnish {

// Tells of two ways whether the one costs less.
constexpr auto IS_CHEAPER = [](const Candidate* a, const Candidate* b) { return a->cost < b->cost; };

static bool is_must(const Rule& rule) { return rule.required && relation_of(rule.word).gives_place; }

// Tells whether a relation that gives a place must hold: then the piece stands nowhere else.
static bool must_have_slot(Span<Rule> rules) {
  for (const Rule& rule : rules) {
    if (is_must(rule)) return true;
  }
  return false;
}

// The slots; one that meets a relation pays for the other relations with slots that it misses.
static List<Candidate*> slots_of(const Subject& subject, Span<Effect> effects, const Preferences& preferences) {
  const bool must = must_have_slot(subject.rules);
  List<Candidate*> found;
  for (i32 i = 0; i < effects.size; i++) {
    if (must && !is_must(*effects[i].rule)) continue;
    f64 missed = 0.0;
    for (i32 j = 0; j < effects.size; j++) {
      if (j != i && effects[j].slots.size() > 0) missed += effects[j].rule->cost;
    }
    for (Candidate& slot : effects[i].slots) {
      slot.cost = rounded_6(rounded_6(slot.cost + missed) + preferences.cost(subject, slot));
      found.add(&slot);
    }
  }
  return found;
}

namespace {

// Ways to stand that differ in their anchors only.
struct Group {
  i32 kind;
  Wall wall;
  i32 way_round;
  List<Candidate*> ways;
};

}  // namespace

// Used from two opposite sides alike, turning it round changes only its looks.
static bool is_alike_turned(const Kind& kind) {
  constexpr i32 ACROSS = 1 << static_cast<i32>(Side::left) | 1 << static_cast<i32>(Side::right);
  constexpr i32 ALONG = 1 << static_cast<i32>(Side::front) | 1 << static_cast<i32>(Side::back);
  return kind.use_sides == ACROSS || kind.use_sides == ALONG;
}

static Group& group_of(List<Group>& groups, const Candidate& one, i32 way_round) {
  for (Group& group : groups) {
    if (group.kind == one.kind && group.wall == one.wall && group.way_round == way_round) return group;
  }
  return groups.add({one.kind, one.wall, way_round, {}});
}

static bool has_anchor(const Group& group, Point anchor) {
  for (const Candidate* way : group.ways) {
    if (way->anchor.x == anchor.x && way->anchor.z == anchor.z) return true;
  }
  return false;
}

// Keeps, for every variant, wall and way round, the cheapest anchors: a few for the wanted variant, one for the others.
static List<Candidate*> best_of_each(const Subject& subject, Span<Effect> effects, const List<Candidate*>& found) {
  bool corners = false;
  for (const Effect& effect : effects) corners = corners || effect.corners;
  stable_sort(found.all(), IS_CHEAPER);
  List<Group> groups;
  for (Candidate* each : found) {
    const Candidate& one = *each;
    const i32 turns = is_alike_turned(subject.kind(one)) ? 180 : 360;
    Group& group = group_of(groups, one, one.rotation % turns);
    const i32 few = corners && one.wall == Wall::none ? 4 : 2;
    const i32 room = one.kind == subject.variants[0].kind ? few : few / 2;
    if (group.ways.size() < room && !has_anchor(group, one.anchor)) group.ways.add(each);
  }
  List<Candidate*> best;
  for (const Group& group : groups) best.add_all(group.ways.all());
  return best;
}

// Overlaps up to this between meant places do not matter.
constexpr i64 TOUCH_MM = 20;
// Most candidates a piece gets: placement's time is linear in them.
constexpr i32 LIMIT = 40;
// What it costs a free piece to be wished where an earlier piece is meant to stand: small things do not herd.
constexpr f64 TAKEN_COST = 1.5;
// What it costs an armchair to look at a wall nearer than this.
constexpr f64 WALL_COST = 1.5;
constexpr i64 AHEAD_MM = 1000;
// What standing elsewhere than a run plans costs.
constexpr f64 OFF_PLAN_COST = 8.0;
// Pull towards an anchor that no rule asks to be firm, m^-2.
constexpr f64 DRAW = 0.05;

Furnisher::Furnisher(const Scope& scope, const RoomType& type, WallOccupancy& walls)
    : scope_(scope), type_(type), walls_(walls), knee_room_(type) {
  earlier_.by_word = zeroes<List<i32>>(type.all_words);
}

bool Furnisher::add(const CountedPiece& counted, i32 number, const Preferences& preferences, const Candidate* planned) {
  const PieceSpec& spec = type_.pieces[counted.spec];
  const Subject subject{scope_, type_, spec, counted.variants, type_.rules_of(spec), earlier_, knee_room_};
  List<Effect> effects;
  for (const Rule& rule : subject.rules) {
    Effect& effect = effects.add({});
    effect.relation = &relation_of(rule.word);
    effect.rule = &rule;
    effect.relation->effect(subject, rule, effect);
  }
  List<Candidate*> ways = found_for(subject, effects.all(), preferences);
  if (ways.size() == 0) return false;
  stable_sort(ways.all(), IS_CHEAPER);
  Candidate as_planned;
  if (planned != nullptr && number == 1) {
    as_planned = *planned;
    List<Candidate*> with_plan;
    with_plan.add(&as_planned);
    for (Candidate* other : ways) {
      other->cost += OFF_PLAN_COST;
      with_plan.add(other);
    }
    ways = with_plan;
  }
  ways.cut(LIMIT);
  keep(counted, number, ways.all(), effects.all());
  intend(ways.all());
  return true;
}

List<Candidate*> Furnisher::found_for(const Subject& subject, Span<Effect> effects, const Preferences& preferences) const {
  List<Candidate*> found = slots_of(subject, effects, preferences);
  if (!must_have_slot(subject.rules)) found.add_all(alone(subject, effects, preferences).all());
  for (Candidate* way : found) {
    for (const Effect& effect : effects) effect.relation->keep(subject, effect, *way);
  }
  return found;
}

// What it costs a piece used from its front only to stand so near to a wall that it looks at nothing else.
static f64 cost_facing_wall(const Subject& subject, const Candidate& candidate) {
  if (!subject.kind(candidate).has_front_only()) return 0.0;
  const i64 ahead = subject.footprint(candidate).wall_distance(wall_ahead(candidate.rotation), subject.scope.clear);
  return ahead < AHEAD_MM ? WALL_COST : 0.0;
}

// What a free place costs where another piece is meant to stand or a garage door opens.
f64 Furnisher::cost_in_the_way(const Subject& subject, const Candidate& candidate) const {
  const Rect rect = subject.footprint(candidate);
  const bool before_gate = walls_.is_before_gate(rect) && !subject.faces(Opening::garage_door);
  return TAKEN_COST * (before_gate + walls_.is_occupied(rect));
}

// What a way to stand costs by every relation.
static f64 cost_by_relations(const Subject& subject, Span<Effect> effects, const Candidate& candidate) {
  f64 sum = 0.0;
  for (const Effect& effect : effects) {
    if (effect.has_cost) sum += effect.relation->cost(subject, effect, candidate);
  }
  return sum;
}

// The ways to stand at walls and in the room, costed by every relation, the best few of each sort.
List<Candidate*> Furnisher::alone(const Subject& subject, Span<Effect> effects, const Preferences& preferences) const {
  f64 missed = 0.0, pull = DRAW;
  for (const Effect& effect : effects) {
    if (effect.slots.size() > 0) missed += effect.rule->cost;
    pull = most(pull, effect.weight);
  }
  List<Candidate*> found;
  for (Candidate& candidate : own_candidates(subject, walls_, effects)) {
    f64 cost = candidate.cost + missed + preferences.cost(subject, candidate);
    if (candidate.wall == Wall::none) cost += cost_in_the_way(subject, candidate) + cost_facing_wall(subject, candidate);
    cost += cost_by_relations(subject, effects, candidate);
    if (!(cost < INFINITE)) continue;
    candidate.cost = rounded_6(cost);
    candidate.weight = pull;
    found.add(&candidate);
  }
  return best_of_each(subject, effects, found);
}

static bool has_kind(const List<i32>& kinds, i32 kind) {
  for (i32 one : kinds) {
    if (one == kind) return true;
  }
  return false;
}

// Adds the rows of a piece; later pieces may relate to it.
void Furnisher::keep(const CountedPiece& counted, i32 number, Span<Candidate*> ways, Span<Effect> effects) {
  const i32 before = links.size();
  for (const Effect& effect : effects) links.add_all(effect.links.all());
  for (const Candidate* way : ways) candidates.add(*way);
  const i32 piece = pieces.size();
  const PieceSpec& spec = type_.pieces[counted.spec];
  const i32 bonds = links.size() - before;
  const f64 skipped = spec.required ? INFINITE : spec.skip_cost;
  pieces.add({counted.spec, number, counted.variants[0].kind, ways.size, bonds, -1, spec.required, spec.with_next, skipped});
  earlier_.by_word[type_.pieces[counted.spec].word].add(piece);
  List<i32> kinds;
  for (const Candidate* way : ways) {
    if (!has_kind(kinds, way->kind)) kinds.add(way->kind);
  }
  earlier_.kinds.add(kinds);
}

// Where a candidate would be if the pieces before it stood where they are meant to.
Furnisher::Meant Furnisher::meant(const Candidate& candidate) const {
  if (candidate.parent < 0) return {candidate.kind, candidate.rotation, candidate.anchor};
  const Meant& parent = meant_[candidate.parent];
  if (parent.kind != candidate.parent_kind) return {-1, 0, {0, 0}};
  const Point middle{candidate.across.middle(), candidate.along.middle()};
  const Point away = rotated(middle, parent.rotation);
  return {candidate.kind, (parent.rotation + candidate.rotation) % 360, {parent.centre.x + away.x, parent.centre.z + away.z}};
}

// Marks where a piece would like best to stand, so that later pieces are first wished elsewhere.
void Furnisher::intend(Span<Candidate*> ways) {
  Meant& own = meant_.add({-1, 0, {0, 0}});
  for (const Candidate* each : ways) {
    const Candidate& way = *each;
    const Meant place = meant(way);
    if (place.kind < 0) continue;
    const Rect rect = Rect::around(place.centre, turned(type_.kinds[way.kind].size(), place.rotation));
    if (way.parent >= 0 && walls_.is_occupied(rect.shrunk(TOUCH_MM))) continue;
    own = place;
    if (!way.is_on && !way.is_under) walls_.occupy(rect);
    return;
  }
}

}  // namespace furnish
