#include "furnish/slots.hpp"

#include "plain/rounding.hpp"

namespace furnish {

static bool is_must(const Rule& rule) { return rule.required && relation_of(rule.word).gives_place; }

bool must_have_slot(Span<Rule> rules) {
  for (const Rule& rule : rules) {
    if (is_must(rule)) return true;
  }
  return false;
}

List<Candidate*> slots_of(const Subject& subject, Span<Effect> effects, const Preferences& preferences) {
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

List<Candidate*> best_of_each(const Subject& subject, const List<Candidate*>& found) {
  bool corners = false;
  for (const Rule& rule : subject.rules) corners = corners || rule.word == Word::in_corner;
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

}  // namespace furnish
