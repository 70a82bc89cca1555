// Of all the ways found for a piece: what slots cost, and the best few that stand alone.
#pragma once

#include "furnish/preferences.hpp"
#include "furnish/relations/relation.hpp"

namespace furnish {

// Tells of two ways whether the one costs less.
constexpr auto IS_CHEAPER = [](const Candidate* a, const Candidate* b) { return a->cost < b->cost; };

// Tells whether a relation that gives a place must hold: then the piece stands nowhere else.
bool must_have_slot(Span<Rule> rules);

// The slots; one that meets a relation pays for the other relations with slots that it misses.
List<Candidate*> slots_of(const Subject& subject, Span<Effect> effects, const Preferences& preferences);

// Keeps, for every variant, wall and way round, the cheapest anchors: a few for the wanted variant, one for the others.
List<Candidate*> best_of_each(const Subject& subject, const List<Candidate*>& found);

}  // namespace furnish
