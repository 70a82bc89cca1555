#include "furnish/run_costs.hpp"

namespace furnish {

// Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter than 4 feet
// or longer than 9 feet), and of the sum of its legs (at most 26 feet; 4 m is what three shortest legs come to).
constexpr f64 SHORTEST_LEG = 1.2, LONGEST_LEG = 2.7, LEAST_PERIMETER = 4.0, MOST_PERIMETER = 7.9;
// What a triangle costs that is not within these, and what a metre beyond them.
constexpr f64 BROKEN_COST = 5.0, LEG_COST = 8.0, PERIMETER_COST = 8.0;
// What a side without worktop costs where it is wanted (guideline 17: landing area at the cooking surface), and what belongs at an end
// within the worktop.
constexpr f64 LANDING_COST = 10.0, END_COST = 6.0;
// Worktop that a cook wants, m (guideline 25: 158 inches of frontage), and what a metre less costs.
constexpr f64 WORKTOP = 4.0, WORKTOP_COST = 2.0;

f64 row_cost(const Drawn& drawn) {
  // What is drawn is guessed by no processor: nothing here branches on it.
  const bool goes_on = drawn.form != Form::opposite;
  i32 landings = 0, ends = 0;
  bool lands = false, is_within = false;  // whether there is worktop right before an item, and whether what is there makes it no end
  for (i32 i = 0; i < drawn.items.size; i++) {
    const Item& item = *drawn.items[i];
    const bool turns = i + 1 == drawn.first, there = i + 1 < drawn.items.size;
    const Item& next = *drawn.items[i + there];
    const bool lands_after = there & !turns & next.has(WORKTOP_TRAIT), within_after = there & (!turns | goes_on) & !next.has(END_TRAIT);
    landings += item.has(LANDING_TRAIT) * (!lands + !lands_after);
    ends += item.has(END_TRAIT) & is_within & within_after;
    lands = !turns & item.has(WORKTOP_TRAIT);
    is_within = (!turns | goes_on) & !item.has(END_TRAIT);
  }
  return LANDING_COST * landings + END_COST * ends;
}

f64 worktop_cost(const RoomType& type, const Drawn& drawn) {
  i64 length = 0;
  for (const Item* item : drawn.items) length += item->width * item->has(WORKTOP_TRAIT);
  if (drawn.form == Form::corner) length -= drawn.items[drawn.first]->depth;
  return type.worktop.size > 0 ? WORKTOP_COST * most(WORKTOP - static_cast<f64>(length) / 1000.0, 0.0) : 0.0;
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
