#include "furnish/runs.hpp"

#include "furnish/run_costs.hpp"

namespace furnish {

// Runs drawn for a room; the best of those that fit is taken (measured: more find hardly better ones).
constexpr i32 DRAWS = 5000;
// What a run without a piece that it could hold costs, and how often one is drawn without it.
constexpr f64 MISSED_COST = 2.0, MISSED_CHANCE = 0.3;
// How often a run goes round a corner it could, and how often another one goes on at the opposite wall.
constexpr f64 CORNER_CHANCE = 0.6, OPPOSITE_CHANCE = 0.5;
// Most that a run costs by the seed alone.
constexpr f64 PREFERENCE = 1.6;
// Pull of a piece to its place in the run, m^-2.
constexpr f64 FIRM = 20.0;
// Least floor between two opposite rows (guideline 6: work aisle of 42 inches for one cook).
constexpr i64 AISLE_MM = 1067;

namespace {

class RunPlanner {
 public:
  RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted);
  Span<Candidate> best(Stream& stream);
 private:
  bool draw(Stream& stream, f64 lowest, Drawn& drawn) const;
  void draw_items(Stream& stream, Drawn& drawn) const;
  void cut_in_two(Drawn& drawn) const;
  Legs legs_of(const Drawn& drawn) const;
  Leg leg(Wall wall, Items items, bool reversed, i64 corner, bool high) const;
  Leg leg_in_stretch(Wall wall, Items items, bool reversed, f64 stretch, bool high) const;
  bool has_aisle(const Legs& legs) const;
  bool place(const Legs& legs, Span<Candidate> places) const;
  void add_member(i32 word, const Traits& said);
  List<Interval> stretches(Wall wall, i32 number) const;
  void add_effects(i32 word);
  void add_follower(const Leaving& wish, i32 kind);
  Subject subject(i32 word);
  f64 room_cost(const Drawn& drawn, Span<Candidate> places);

  const Scope& scope_;
  const WallOccupancy& walls_;
  const RoomType& type_;
  Span<Member> members_;                  // by word
  Span<Order> orders_;
  Items drawn_;                           // space for the items of a run
  Span<Candidate> places_, best_;         // by word
  f64 corner_gain_ = 0.0;                 // most that an item costs more than what stands for it in a corner
  Span<List<Interval>> free_;             // stretches by kind and wall, of the kinds that a run may hold
  List<Follower> followers_;
  Earlier nothing_;
  KneeRoom knee_room_;
  Span<List<Effect>> effects_;            // what its rules ask of the room, by word
};

RunPlanner::RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted)
    : scope_(scope), walls_(walls), type_(type), knee_room_(type) {
  members_ = zeroes<Member>(type.all_words);
  effects_ = zeroes<List<Effect>>(type.all_words);
  const Span<Traits> said = zeroes<Traits>(type.all_words);
  for (i32 word : type.worktop) said[word].set(WORKTOP_TRAIT, 1);
  for (i32 word : type.landing) said[word].set(LANDING_TRAIT, 1);
  for (i32 word : type.ends) said[word].set(END_TRAIT, 1);
  nothing_.by_word = zeroes<List<i32>>(type.all_words);
  for (const CountedPiece& piece : counted) {
    if (piece.copies > 0) members_[type.pieces[piece.spec].word].piece = &piece;
  }
  drawn_ = reserved<const Item*>(type.words.size);
  places_ = reserved<Candidate>(type.all_words);
  best_ = reserved<Candidate>(type.all_words);
  free_ = zeroes<List<Interval>>(4 * type.kinds.size);
  for (i32 word : type.words) {
    if (members_[word].piece != nullptr && members_[word].items.size == 0) add_member(word, said[word]);
  }
  for (const Leaving& wish : type.leaves) {
    const CountedPiece* piece = members_[wish.word].piece;
    if (piece != nullptr) add_follower(wish, piece->variants[0].kind);
  }
  orders_ = zeroes<Order>(type.orders.size);
  for (i32 k = 0; k < orders_.size; k++) {
    for (i32 word : part_of(type.words, type.orders[k])) {
      if (members_[word].piece == nullptr) continue;
      orders_[k].members.add(&members_[word]);
      orders_[k].optional += members_[word].optional;
    }
  }
}

// Adds what a run may hold of a word: of all its variants those that suit come first, with the one that stands for them in a corner.
void RunPlanner::add_member(i32 word, const Traits& said) {
  add_effects(word);
  Member& own = members_[word];
  const Span<Variant> all = type_.variants_of(type_.pieces[own.piece->spec]), suited = own.piece->variants;
  own.optional = !type_.pieces[own.piece->spec].required;
  own.items = {reserved<Item>(suited.size + all.size).data, suited.size};
  const Span<Item> items = {own.items.data, suited.size + all.size};
  const bool works = said.items(WORKTOP_TRAIT) != 0;
  for (i32 k = 0; k < items.size; k++) {
    const Variant& variant = k < suited.size ? suited[k] : all[k - suited.size];
    const Kind& kind = type_.kinds[variant.kind];
    List<Interval>* free = &free_[4 * variant.kind];
    for (Wall wall : WALLS) {
      List<Interval>& found = free[static_cast<i32>(wall)];
      if (found.size() == 0) found = stretches(wall, variant.kind);
    }
    items[k] = {word, variant.kind, variant.cost, kind.width, kind.depth, works ? kind.width : 0, said, {nullptr, nullptr}, free};
  }
  for (Item& item : own.items) {
    for (i32 k = all.size - 1; k >= 0 && works; k--) {
      const Item& other = items[suited.size + k];
      if (all[k].corner < 0 || other.width != item.width) continue;
      item.corner[all[k].corner] = &other;
      corner_gain_ = most(corner_gain_, -(other.cost - item.cost));
      item.traits.set(static_cast<Trait>(CORNER_TRAIT + all[k].corner), 1);
    }
  }
}

// The clear stretches of a wall for a kind, less what its fronts would not open in.
List<Interval> RunPlanner::stretches(Wall wall, i32 number) const {
  const Kind& kind = type_.kinds[number];
  List<Interval> found = walls_.stretches(wall, kind, false);
  for (const Comfort& comfort : type_.comforts_of(kind)) {
    if (comfort.opens != ALONG_SIDE) continue;
    const Interval within = opened_within(scope_, kind.height).along(wall);
    for (Interval& one : found) one = {most(one.low, within.low), least(one.high, within.high)};
  }
  return found;
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

// Adds a piece that is wanted after the run.
void RunPlanner::add_follower(const Leaving& wish, i32 number) {
  const Kind& kind = type_.kinds[number];
  Follower& own = followers_.add({&wish, number, {kind.width, kind.depth + 2 * wish.beside}, {}});
  for (const Zone& zone : scope_.zones) {
    if (zone.above < kind.height) own.taken.add(zone.rect);
  }
}

// A piece that stands before all others.
Subject RunPlanner::subject(i32 word) {
  const CountedPiece& counted = *members_[word].piece;
  const PieceSpec& spec = type_.pieces[counted.spec];
  return {scope_, type_, spec, counted.variants, type_.rules_of(spec), nothing_, knee_room_};
}

// Tells whether an item may stand at a wall from a coordinate on.
static bool holds(Wall wall, const Item& item, i64 start) {
  for (const Interval& one : item.free[static_cast<i32>(wall)]) {
    if (one.low <= start && start + item.width <= one.high) return true;
  }
  return false;
}

// The end of what stands at a wall that is nearer to the wall's high (low) end.
static Side end_at(Wall wall, bool high) {
  const Point left = rotated({-1, 0}, rotation_at(wall));
  return (left.x + left.z > 0) == high ? Side::left : Side::right;
}

// Draws an order, which way round, and what it holds in which variants.
void RunPlanner::draw_items(Stream& stream, Drawn& drawn) const {
  const auto& [members, optional] = stream.pick(orders_);
  const Span<const Member*> order = members.all();
  const bool mirrored = stream.chance(0.5);
  f64 cost = stream.up_to(PREFERENCE);
  Traits traits = {};
  u64 numbers[2 * MOST_IN_RUN];  // all that may be drawn: what is depends on those before
  Stream ahead(stream);
#pragma clang loop vectorize(disable) unroll(disable)  // wasm's products of two pairs cost more than two products
  for (i32 k = 0; k < order.size + optional; k++) numbers[k] = ahead.bits();
  i64 worktop = 0, depth = 0;
  i32 size = 0, used = 0;
  for (i32 i = 0; i < order.size; i++) {
    const Member& member = *order[mirrored ? order.size - 1 - i : i];
    const bool missed = member.optional & Stream::chance(numbers[used], MISSED_CHANCE);
    const Item& item = member.items[Stream::below(numbers[used + member.optional], member.items.size)];
    const u64 held = !missed;  // no branch on what is drawn, which no processor guesses
    used += member.optional + !missed;
    drawn_[size] = &item;
    traits.add(item.traits, held, size);
    traits.set(SHALLOWER_TRAIT, held & (item.depth <= depth), size);
    depth = missed ? depth : item.depth;
    worktop += missed ? 0 : item.worktop;
    size += !missed;
    cost += missed ? MISSED_COST : item.cost;
  }
  stream.skip(used);
  drawn.items = {drawn_.data, size};
  drawn.traits = traits;
  drawn.worktop = worktop;
  drawn.cost = cost;
}

// Draws a run: at a wall, round a corner, or with its second part at the opposite wall. Always draws as many numbers; false where what
// it holds costs too much however it is laid: cut in two it lacks as much worktop, or more.
bool RunPlanner::draw(Stream& stream, f64 lowest, Drawn& drawn) const {
  draw_items(stream, drawn);
  drawn.laid = stream;
  stream.skip(LAID_NUMBERS);
  drawn.form = Form::straight;
  drawn.first = drawn.items.size;
  if (drawn.items.size == 0 || drawn.cost - corner_gain_ + landing_cost(drawn) + worktop_cost(type_, drawn) >= lowest) return false;
  drawn.wall = WALLS[drawn.number(WALL).below(4)];
  drawn.high = drawn.number(HIGH).chance(0.5);
  cut_in_two(drawn);
  return true;
}

// Where a run goes round a corner, or on at the opposite wall. What comes behind the corner is no deeper than what stands in it, whose
// fronts it would come before.
void RunPlanner::cut_in_two(Drawn& drawn) const {
  const i32 size = drawn.items.size, hidden = static_cast<i32>(end_at(drawn.wall, drawn.high));
  const bool round = drawn.number(ROUND).chance(CORNER_CHANCE);
  u64 corners = round ? drawn.traits.items(CORNER_TRAIT + hidden) & drawn.traits.items(SHALLOWER_TRAIT) >> 1 : 0;
  if (corners != 0) {
    const i64 before = whole(drawn.number(CUT).unit() * __builtin_popcountll(corners));
    for (i64 k = 0; k < before; k++) corners &= corners - 1;
    const i32 at = __builtin_ctzll(corners);
    const Item*& item = drawn.items[at];
    drawn.form = Form::corner;
    drawn.first = at + 1;
    drawn.cost += item->corner[hidden]->cost - item->cost;
    item = item->corner[hidden];
  } else if (size > 1 && drawn.number(ACROSS).chance(OPPOSITE_CHANCE)) {
    drawn.form = Form::opposite;
    drawn.first = 1 + static_cast<i32>(whole(drawn.number(CUT).unit() * (size - 1)));
  }
}

// Lays items along a wall, as near to its low or high end as what stands in the corner leaves.
Leg RunPlanner::leg(Wall wall, Items items, bool reversed, i64 corner, bool from_high) const {
  const Interval ends = scope_.clear.along(wall);
  return {wall, from_high ? ends.high - corner - length_of(items) : ends.low + corner, items, reversed};
}

// Lays items along a wall, at the low or high end of one of the stretches that hold the piece there.
Leg RunPlanner::leg_in_stretch(Wall wall, Items items, bool reversed, f64 stretch, bool from_high) const {
  const Item& end = *items[from_high != reversed ? items.size - 1 : 0];
  const List<Interval>& stretches = end.free[static_cast<i32>(wall)];
  if (stretches.size() == 0) return leg(wall, items, reversed, scope_.gap, from_high);
  const Interval free = stretches[static_cast<i32>(whole(stretch * stretches.size()))], ends = scope_.clear.along(wall);
  const i64 beyond = from_high ? ends.high - free.high : free.low - ends.low;
  return leg(wall, items, reversed, beyond == 0 ? scope_.gap : beyond, from_high);
}

// Lays the first part along a wall, round a corner with its last item in there; the second from there along the next wall, or at the
// opposite one.
Legs RunPlanner::legs_of(const Drawn& drawn) const {
  const Items first{drawn.items.data, drawn.first}, second{drawn.items.data + drawn.first, drawn.items.size - drawn.first};
  const bool high = drawn.high;
  Legs legs;
  legs.count = second.size == 0 ? 1 : 2;
  if (drawn.form != Form::corner) {
    legs.leg[0] = leg_in_stretch(drawn.wall, first, !high, drawn.number(STRETCH).unit(), high);
    if (second.size == 0) return legs;
    const bool other_high = drawn.number(OTHER_HIGH).chance(0.5);
    legs.leg[1] = leg_in_stretch(opposite(drawn.wall), second, !other_high, drawn.number(OTHER_STRETCH).unit(), other_high);
    return legs;
  }
  legs.leg[0] = leg(drawn.wall, first, !high, scope_.gap, high);
  const Wall low_end = runs_along_x(drawn.wall) ? Wall::west : Wall::north, high_end = runs_along_x(drawn.wall) ? Wall::east : Wall::south;
  const i64 beyond = scope_.gap + first[first.size - 1]->depth;
  const bool from_low = drawn.wall == Wall::north || drawn.wall == Wall::west;
  legs.leg[1] = leg(high ? high_end : low_end, second, !from_low, beyond, !from_low);
  return legs;
}

// Tells whether a cook has room between two opposite rows.
bool RunPlanner::has_aisle(const Legs& legs) const {
  i64 across = runs_along_x(legs.leg[0].wall) ? scope_.clear.depth() : scope_.clear.width();
  for (const Leg& leg : legs) {
    i64 deepest = 0;
    for (const Item* item : leg.items) deepest = most(deepest, item->depth);
    across -= scope_.gap + deepest;
  }
  return across >= AISLE_MM;
}

// Fills in the places of a run's pieces; false where one of them is in the way of an opening or does not fit, as in most runs.
bool RunPlanner::place(const Legs& legs, Span<Candidate> places) const {
  for (const Leg& leg : legs) {
    i64 at = leg.start;
    for (i32 k = 0; k < leg.items.size; k++) {
      if (!holds(leg.wall, leg.at(k), at)) return false;
      at += leg.at(k).width;
    }
  }
  for (Candidate& place : places) place = free_candidate(-1, 0.0);
  for (const Leg& leg : legs) {
    i64 at = leg.start;
    for (i32 k = 0; k < leg.items.size; k++) {
      const Item& item = leg.at(k);
      places[item.word] = at_wall(scope_, type_, item.kind, leg.wall, at + floor_div(item.width, 2), item.cost);
      places[item.word].weight = FIRM;
      at += item.width;
    }
  }
  return true;
}

// What a run costs by what the rules of its pieces ask of the room: windows and doors.
f64 RunPlanner::room_cost(const Drawn& drawn, Span<Candidate> places) {
  f64 sum = 0.0;
  for (const Item* item : drawn.items) {
    const Subject piece = subject(item->word);
    for (const Effect& effect : effects_[item->word]) sum += effect.relation->cost(piece, effect, places[item->word]);
  }
  return sum;
}

Span<Candidate> RunPlanner::best(Stream& stream) {
  f64 lowest = INFINITE;
  for (i32 i = 0; i < DRAWS; i++) {
    arena::Scope scope;
    Drawn drawn{{}, {}, 0, stream, Form::straight, Wall::none, false, 0, 0.0};
    if (!draw(stream, lowest, drawn)) continue;
    const f64 by_items = drawn.cost + (landing_cost(drawn) + end_cost(drawn)) + worktop_cost(type_, drawn);
    if (by_items >= lowest) continue;
    const Legs legs = legs_of(drawn);
    if ((drawn.form == Form::opposite && !has_aisle(legs)) || !place(legs, places_)) continue;
    f64 cost = by_items + triangle_cost(type_, places_) + room_cost(drawn, places_);
    if (cost >= lowest) continue;
    for (const Follower& follower : followers_) {
      Candidate& left = places_[follower.wish->word] = place_left(scope_, follower, legs);
      if (left.kind < 0) cost += follower.wish->cost;
    }
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
