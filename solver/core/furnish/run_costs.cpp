#include "furnish/run_costs.hpp"

namespace furnish {

// Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter than 4 feet
// or longer than 9 feet), and of the sum of its legs (at most 26 feet; 4 m is what three shortest legs come to).
constexpr f64 SHORTEST_LEG = 1.2, LONGEST_LEG = 2.7, LEAST_PERIMETER = 4.0, MOST_PERIMETER = 7.9;
// What a triangle costs that is not within these, and what a metre beyond them.
constexpr f64 BROKEN_COST = 5.0, LEG_COST = 8.0, PERIMETER_COST = 8.0;
// What a side without worktop costs where it is wanted (guidelines 11, 16 and 17: landing areas at sink, refrigerator and cooking
// surface), as what stands alone across, and what belongs at an end within the worktop.
constexpr f64 LANDING_COST = 10.0, END_COST = 6.0;
// Worktop that a cook wants, m (guideline 25: 158 inches of frontage), and what a metre less costs.
constexpr f64 WORKTOP = 4.0, WORKTOP_COST = 2.0;

static i32 count(u64 items) { return __builtin_popcountll(items); }

// Of all items at once: what is drawn is guessed by no processor, so that nothing here branches on it.
f64 landing_cost(const Drawn& drawn) {
  const u64 cut = 1ULL << drawn.first, worktop = drawn.traits.items(WORKTOP_TRAIT), landing = drawn.traits.items(LANDING_TRAIT);
  const i32 landed = count(landing & worktop << 1 & ~cut) + count(landing & (worktop & ~cut) >> 1);
  return LANDING_COST * (2 * count(landing) - landed);
}

f64 end_cost(const Drawn& drawn) {
  const u64 ends_row = drawn.form == Form::opposite ? 1ULL << drawn.first : 0, end = drawn.traits.items(END_TRAIT);
  const u64 within = ((1ULL << drawn.items.size) - 1) & ~end;
  const i32 across = drawn.items.size - drawn.first, opposite = drawn.form == Form::opposite;
  const i32 alone = opposite * ((drawn.first == 1) + (across == 1));
  return END_COST * count(end & within << 1 & ~ends_row & (within & ~ends_row) >> 1) + LANDING_COST * alone;
}

f64 worktop_cost(const RoomType& type, const Drawn& drawn) {
  const i64 hidden = drawn.form == Form::corner ? drawn.items[drawn.first]->depth : 0;
  return type.worktop.size > 0 ? WORKTOP_COST * most(WORKTOP - static_cast<f64>(drawn.worktop - hidden) / 1000.0, 0.0) : 0.0;
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
