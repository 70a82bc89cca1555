#include "furnish/runs.hpp"

namespace furnish {

// Runs drawn for a room; the best of those that fit is taken (measured: more find hardly better ones).
constexpr i32 DRAWS = 6000;
// Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter than 4 feet
// or longer than 9 feet), and of the sum of its legs (at most 26 feet; 4 m is what three shortest legs come to).
constexpr f64 SHORTEST_LEG = 1.2, LONGEST_LEG = 2.7, LEAST_PERIMETER = 4.0, MOST_PERIMETER = 7.9;
// What a triangle costs that is not within these, and what a metre beyond them.
constexpr f64 BROKEN_COST = 5.0, LEG_COST = 8.0, PERIMETER_COST = 8.0;
// What a run without a piece that it could hold costs, and how often one is drawn without it.
constexpr f64 MISSED_COST = 2.0, MISSED_CHANCE = 0.3;
// How many numbers are drawn of how a run is laid, whatever it holds: wall, ends, stretches, form, cut.
constexpr i32 LAID_NUMBERS = 8;
// How often a run goes round a corner it could, and how often another one goes on at the opposite wall.
constexpr f64 CORNER_CHANCE = 0.6, OPPOSITE_CHANCE = 0.5;
// What a side without worktop costs where it is wanted (guideline 17: landing area at the cooking surface), and what belongs at an end
// within the worktop.
constexpr f64 LANDING_COST = 10.0, END_COST = 6.0;
// Worktop that a cook wants, m (guideline 25: 158 inches of frontage), and what a metre less costs.
constexpr f64 WORKTOP = 4.0, WORKTOP_COST = 2.0;
// Most that a run costs by the seed alone.
constexpr f64 PREFERENCE = 0.9;
// Pull of a piece to its place in the run, m^-2.
constexpr f64 FIRM = 20.0;
// Least floor between two opposite rows (guideline 6: work aisle of 42 inches for one cook).
constexpr i64 AISLE_MM = 1067;

namespace {

// A piece of a run: its word, and which variant.
struct Item {
  i32 word;
  i32 kind;
  f64 cost;
};

// Items along one wall, the first at `start`, the others after it.
struct Leg {
  Wall wall;
  i64 start;
  List<Item> items;
};

// What is said of a word in the room's type, as bits.
enum Trait : u8 { WORKTOP_TRAIT = 1, LANDING_TRAIT = 2, END_TRAIT = 4 };

enum class Form : i32 { straight, corner, opposite };

// A run as it is drawn: its items by word, how they are laid, and where in a wall's clear stretches its legs begin.
struct Drawn {
  List<Item> items;
  Form form;
  Wall wall;
  bool high[2];    // from which end of its wall each leg is laid
  f64 stretch[2];  // of a leg that begins in no corner
  i32 first;       // how many items stand along the first wall
  f64 cost;
};

class RunPlanner {
 public:
  RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted);
  Span<Candidate> best(Stream& stream);
 private:
  bool draw(Stream& stream, f64 lowest, Drawn& drawn) const;
  void draw_items(Stream& stream, Drawn& drawn) const;
  List<Leg> legs_of(const Drawn& drawn) const;
  Leg leg(Wall wall, Span<Item> items, i64 corner, bool high) const;
  Leg leg_in_stretch(Wall wall, Span<Item> items, f64 stretch, bool high) const;
  bool has_aisle(const List<Leg>& legs) const;
  bool place(const List<Leg>& legs, Span<Candidate> places) const;
  bool holds(Wall wall, i32 kind, i64 start) const;
  void add_effects(i32 word);
  Subject subject(i32 word);
  void look_up(i32 kind);
  f64 room_cost(const Drawn& drawn, Span<Candidate> places);
  f64 row_cost(const Drawn& drawn) const;
  f64 worktop_cost(const Drawn& drawn) const;
  f64 triangle_cost(Span<Candidate> places) const;
  const Variant* in_corner(const Item& item, Side hidden) const;
  bool has(i32 word, Trait trait) const { return (traits_[word] & trait) != 0; }
  i64 length_of(Span<Item> items) const;

  const Scope& scope_;
  const WallOccupancy& walls_;
  const RoomType& type_;
  Span<const CountedPiece*> there_;       // by word
  Span<Candidate> places_, best_;         // by word
  Span<List<Interval>> free_;             // stretches by kind and wall, of the kinds that a run may hold
  Earlier nothing_;
  KneeRoom knee_room_;
  Span<List<Effect>> effects_;            // what its rules ask of the room, by word
  Span<u8> traits_;                       // by word
};

RunPlanner::RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted)
    : scope_(scope), walls_(walls), type_(type), knee_room_(type) {
  there_ = zeroes<const CountedPiece*>(type.all_words);
  effects_ = zeroes<List<Effect>>(type.all_words);
  traits_ = zeroes<u8>(type.all_words);
  for (i32 word : type.worktop) traits_[word] |= WORKTOP_TRAIT;
  for (i32 word : type.landing) traits_[word] |= LANDING_TRAIT;
  for (i32 word : type.ends) traits_[word] |= END_TRAIT;
  const Span<bool> known = zeroes<bool>(type.all_words);
  nothing_.by_word = zeroes<List<i32>>(type.all_words);
  for (const CountedPiece& piece : counted) {
    if (piece.copies > 0) there_[type.pieces[piece.spec].word] = &piece;
  }
  places_ = reserved<Candidate>(type.all_words);
  best_ = reserved<Candidate>(type.all_words);
  free_ = zeroes<List<Interval>>(4 * type.kinds.size);
  for (i32 word : type.words) {
    if (there_[word] == nullptr || known[word]) continue;
    known[word] = true;
    add_effects(word);
    for (const Variant& variant : type.variants_of(type.pieces[there_[word]->spec])) look_up(variant.kind);
  }
}

// Keeps what the rules of a piece ask of the room alone.
void RunPlanner::add_effects(i32 word) {
  const Subject piece = subject(word);
  for (const Rule& rule : piece.rules) {
    Effect effect;
    effect.relation = &relation_of(rule.word);
    effect.rule = &rule;
    effect.relation->effect(piece, rule, effect);
    if (effect.has_cost) effects_[word].add(effect);
  }
}

// A piece that stands before all others.
Subject RunPlanner::subject(i32 word) {
  const CountedPiece& counted = *there_[word];
  const PieceSpec& spec = type_.pieces[counted.spec];
  return {scope_, type_, spec, counted.variants, type_.rules_of(spec), nothing_, knee_room_};
}

// Finds where a kind may stand along the walls; it is asked many times.
void RunPlanner::look_up(i32 kind) {
  for (Wall wall : WALLS) {
    List<Interval>& found = free_[4 * kind + static_cast<i32>(wall)];
    if (found.size() == 0) found = walls_.stretches(wall, type_.kinds[kind], false);
  }
}

// Tells whether a piece may stand at a wall from a coordinate on.
bool RunPlanner::holds(Wall wall, i32 kind, i64 start) const {
  for (const Interval& one : free_[4 * kind + static_cast<i32>(wall)]) {
    if (one.low <= start && start + type_.kinds[kind].width <= one.high) return true;
  }
  return false;
}

// The variant of an item, as wide as that, that may stand in the corner with that end hidden; none where it has none.
const Variant* RunPlanner::in_corner(const Item& item, Side hidden) const {
  if (!has(item.word, WORKTOP_TRAIT)) return nullptr;
  for (const Variant& one : type_.variants_of(type_.pieces[there_[item.word]->spec])) {
    if (one.corner == static_cast<i32>(hidden) && type_.kinds[one.kind].width == type_.kinds[item.kind].width) return &one;
  }
  return nullptr;
}

// The end of what stands at a wall that is nearer to the wall's high (low) end.
static Side end_at(Wall wall, bool high) {
  const Point left = rotated({-1, 0}, rotation_at(wall));
  return (left.x + left.z > 0) == high ? Side::left : Side::right;
}

i64 RunPlanner::length_of(Span<Item> items) const {
  i64 length = 0;
  for (const Item& item : items) length += type_.kinds[item.kind].width;
  return length;
}

// Draws an order, which way round, and what it holds in which variants.
void RunPlanner::draw_items(Stream& stream, Drawn& drawn) const {
  const Span<i32> order = part_of(type_.words, stream.pick(type_.orders));
  const bool mirrored = stream.chance(0.5);
  drawn.cost = stream.up_to(PREFERENCE);
  for (i32 i = 0; i < order.size; i++) {
    const i32 word = order[mirrored ? order.size - 1 - i : i];
    const CountedPiece* piece = there_[word];
    if (piece == nullptr) continue;
    if (!type_.pieces[piece->spec].required && stream.chance(MISSED_CHANCE)) {
      drawn.cost += MISSED_COST;
      continue;
    }
    const Variant& variant = stream.pick(piece->variants);
    drawn.items.add({word, variant.kind, variant.cost});
    drawn.cost += variant.cost;
  }
}

// Draws a run: at a wall, round a corner, or with its second part at the opposite wall. What comes behind the corner is no deeper than what
// stands in it, whose fronts it would come before. Always draws as many numbers; false where what
// it holds costs too much already.
bool RunPlanner::draw(Stream& stream, f64 lowest, Drawn& drawn) const {
  draw_items(stream, drawn);
  if (drawn.items.size() == 0 || drawn.cost >= lowest) {
    stream.skip(LAID_NUMBERS);
    return false;
  }
  drawn.wall = WALLS[stream.below(4)];
  for (bool& high : drawn.high) high = stream.chance(0.5);
  for (f64& stretch : drawn.stretch) stretch = stream.unit();
  const bool round = stream.chance(CORNER_CHANCE), across = stream.chance(OPPOSITE_CHANCE);
  const f64 cut = stream.unit();
  const i32 size = drawn.items.size();
  const Side hidden = end_at(drawn.wall, drawn.high[0]);
  List<i32> corners;
  for (i32 i = 0; round && i + 1 < size; i++) {
    const bool deeper = type_.kinds[drawn.items[i + 1].kind].depth > type_.kinds[drawn.items[i].kind].depth;
    if (!deeper && in_corner(drawn.items[i], hidden) != nullptr) corners.add(i);
  }
  drawn.first = size;
  if (corners.size() > 0) {
    drawn.form = Form::corner;
    drawn.first = 1 + corners[static_cast<i32>(whole(cut * corners.size()))];
    Item& item = drawn.items[drawn.first - 1];
    const Variant& variant = *in_corner(item, hidden);
    drawn.cost += variant.cost - item.cost;
    item = {item.word, variant.kind, variant.cost};
  } else if (across && size > 1) {
    drawn.form = Form::opposite;
    drawn.first = 1 + static_cast<i32>(whole(cut * (size - 1)));
  }
  return true;
}

// Lays items along a wall, in the order from its low end, as near to its low or high end as what stands in the corner leaves.
Leg RunPlanner::leg(Wall wall, Span<Item> items, i64 corner, bool from_high) const {
  const Interval ends = scope_.clear.along(wall);
  Leg made{wall, from_high ? ends.high - corner - length_of(items) : ends.low + corner, {}};
  made.items.add_all(items);
  return made;
}

// Lays items along a wall, in the order from its low end, at the low or high end of one of the stretches that hold the piece there.
Leg RunPlanner::leg_in_stretch(Wall wall, Span<Item> items, f64 stretch, bool from_high) const {
  const Item& end = items[from_high ? items.size - 1 : 0];
  const List<Interval>& stretches = free_[4 * end.kind + static_cast<i32>(wall)];
  if (stretches.size() == 0) return leg(wall, items, scope_.gap, from_high);
  const Interval free = stretches[static_cast<i32>(whole(stretch * stretches.size()))], ends = scope_.clear.along(wall);
  const i64 beyond = from_high ? ends.high - free.high : free.low - ends.low;
  return leg(wall, items, beyond == 0 ? scope_.gap : beyond, from_high);
}

static Span<Item> reversed(Span<Item> items) {
  List<Item> made;
  for (i32 i = items.size - 1; i >= 0; i--) made.add(items[i]);
  return made.all();
}

// Lays the first part along a wall, round a corner with its last item in there; the second from there along the next wall, or at the
// opposite one.
List<Leg> RunPlanner::legs_of(const Drawn& drawn) const {
  const Span<Item> all = drawn.items.all();
  const Span<Item> first{all.data, drawn.first}, second{all.data + drawn.first, all.size - drawn.first};
  const bool high = drawn.high[0];
  const Span<Item> low_first = high ? first : reversed(first);
  List<Leg> legs;
  if (drawn.form != Form::corner) {
    legs.add(leg_in_stretch(drawn.wall, low_first, drawn.stretch[0], high));
    if (second.size == 0) return legs;
    legs.add(leg_in_stretch(opposite(drawn.wall), drawn.high[1] ? second : reversed(second), drawn.stretch[1], drawn.high[1]));
    return legs;
  }
  legs.add(leg(drawn.wall, low_first, scope_.gap, high));
  const Wall low_end = runs_along_x(drawn.wall) ? Wall::west : Wall::north, high_end = runs_along_x(drawn.wall) ? Wall::east : Wall::south;
  const i64 beyond = scope_.gap + type_.kinds[first[first.size - 1].kind].depth;
  const bool from_low = drawn.wall == Wall::north || drawn.wall == Wall::west;
  legs.add(leg(high ? high_end : low_end, from_low ? second : reversed(second), beyond, !from_low));
  return legs;
}

// Tells whether a cook has room between two opposite rows.
bool RunPlanner::has_aisle(const List<Leg>& legs) const {
  i64 across = runs_along_x(legs[0].wall) ? scope_.clear.depth() : scope_.clear.width();
  for (const Leg& leg : legs) {
    i64 deepest = 0;
    for (const Item& item : leg.items) deepest = most(deepest, type_.kinds[item.kind].depth);
    across -= scope_.gap + deepest;
  }
  return across >= AISLE_MM;
}

// Fills in the places of a run's pieces; false where one of them is in the way of an opening or does not fit, as in most runs.
bool RunPlanner::place(const List<Leg>& legs, Span<Candidate> places) const {
  for (const Leg& leg : legs) {
    i64 at = leg.start;
    for (const Item& item : leg.items) {
      if (!holds(leg.wall, item.kind, at)) return false;
      at += type_.kinds[item.kind].width;
    }
  }
  for (Candidate& place : places) place = free_candidate(-1, 0.0);
  for (const Leg& leg : legs) {
    i64 at = leg.start;
    for (const Item& item : leg.items) {
      const i64 width = type_.kinds[item.kind].width;
      places[item.word] = at_wall(scope_, type_, item.kind, leg.wall, at + floor_div(width, 2), item.cost);
      places[item.word].weight = FIRM;
      at += width;
    }
  }
  return true;
}

// What a run costs by what the rules of its pieces ask of the room: windows and doors.
f64 RunPlanner::room_cost(const Drawn& drawn, Span<Candidate> places) {
  f64 sum = 0.0;
  for (const Item& item : drawn.items) {
    const Subject piece = subject(item.word);
    for (const Effect& effect : effects_[item.word]) sum += effect.relation->cost(piece, effect, places[item.word]);
  }
  return sum;
}

// What a run costs by what stands beside what.
f64 RunPlanner::row_cost(const Drawn& drawn) const {
  const List<Item>& items = drawn.items;
  const i32 last = items.size() - 1;
  f64 sum = 0.0;
  for (i32 i = 0; i <= last; i++) {
    const bool landing = has(items[i].word, LANDING_TRAIT), end = has(items[i].word, END_TRAIT);
    if (!landing && !end) continue;
    i32 within = 0;
    for (i32 other = i - 1; other <= i + 1; other += 2) {
      const bool there = other >= 0 && other <= last, turns = there && most(i, other) == drawn.first;
      if (landing && (!there || turns || !has(items[other].word, WORKTOP_TRAIT))) sum += LANDING_COST;
      within += there && !(turns && drawn.form == Form::opposite) && !has(items[other].word, END_TRAIT);
    }
    if (end && within == 2) sum += END_COST;
  }
  return sum;
}

// What a run costs by the worktop it lacks; what is hidden round a corner is none.
f64 RunPlanner::worktop_cost(const Drawn& drawn) const {
  i64 length = 0;
  for (const Item& item : drawn.items) {
    if (has(item.word, WORKTOP_TRAIT)) length += type_.kinds[item.kind].width;
  }
  if (drawn.form == Form::corner) length -= type_.kinds[drawn.items[drawn.first].kind].depth;
  return type_.worktop.size > 0 ? WORKTOP_COST * most(WORKTOP - static_cast<f64>(length) / 1000.0, 0.0) : 0.0;
}

// What a run costs by its working triangle, measured between the middles of the fronts.
f64 RunPlanner::triangle_cost(Span<Candidate> places) const {
  List<Point> fronts;  // doubled
  for (i32 word : type_.triangle) {
    const Candidate& place = places[word];
    if (place.kind < 0) continue;
    const Point ahead = facing(place.rotation);
    const i64 depth = type_.kinds[place.kind].depth;
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

Span<Candidate> RunPlanner::best(Stream& stream) {
  f64 lowest = INFINITE;
  for (i32 i = 0; i < DRAWS; i++) {
    arena::Scope scope;
    Drawn drawn{};
    if (!draw(stream, lowest, drawn)) continue;
    const f64 by_items = drawn.cost + row_cost(drawn) + worktop_cost(drawn);
    if (by_items >= lowest) continue;
    const List<Leg> legs = legs_of(drawn);
    if ((drawn.form == Form::opposite && !has_aisle(legs)) || !place(legs, places_)) continue;
    const f64 cost = by_items + triangle_cost(places_) + room_cost(drawn, places_);
    if (cost >= lowest) continue;
    lowest = cost;
    swap(best_, places_);
  }
  return lowest < INFINITE ? best_ : Span<Candidate>{};
}

}  // namespace

Span<Candidate> planned_run(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted,
                            Stream& stream) {
  return RunPlanner(scope, walls, type, counted).best(stream);
}

}  // namespace furnish
