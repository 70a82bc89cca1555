#include "furnish/relations/facing.hpp"

#include "furnish/relations/openings.hpp"

namespace furnish {

// Tells whether the slots of another relation of the piece to those it faces turn it already.
static bool slots_turn_it(const Subject& subject, const Rule& rule) {
  for (const Rule& other : subject.rules) {
    const Word word = other.word;
    const bool at_side = word == Word::beside || word == Word::in_front_of || word == Word::around || word == Word::under;
    if (at_side && share_a_name(subject.type.of(other), subject.type.of(rule))) return true;
  }
  return false;
}

// Asks for the turn; to an opening, for being turned to its wall.
void Facing::effect(const Subject& subject, const Rule& rule, Effect& effect) const {
  if (names_opening(subject.type.of(rule))) {
    for (const Opened& one : subject.scope.openings) {
      if (is_named(one, subject.type.of(rule))) effect.walls |= 1ULL << static_cast<i32>(one.wall);
    }
    effect.has_cost = effect.walls != 0;
    return;
  }
  const i32 piece = subject.first(rule);
  if (piece < 0 || slots_turn_it(subject, rule)) return;
  Link& link = effect.links.add(link_to(rule, piece));
  link.turn = LOOKS_AT;
  link.cost = rule.cost;
  link.required = rule.required;
}

f64 Facing::cost(const Subject&, const Effect& effect, const Candidate& candidate) const {
  const i32 ahead = static_cast<i32>(wall_ahead(candidate.rotation));
  return effect.walls >> ahead & 1 ? 0.0 : effect.rule->missed();
}

}  // namespace furnish
