#include "furnish/runs.hpp"

#include "furnish/run_costs.hpp"

namespace furnish {

// The best run is searched for so many times from the start, each time in so many draws: of the first all is drawn, of the others so many
// numbers of the best one so far are drawn anew (measured: 5,000 at random find dearer ones).
constexpr i32 SEARCHES = 8, DRAWS = 100, AT_RANDOM = 32, CHANGES = 4;
// What a run without a piece that it could hold costs, and how often one is drawn without it.
constexpr f64 MISSED_COST = 6.0, MISSED_CHANCE = 0.3;
// How often a run goes round a corner it could, and how often another one goes on at the opposite wall.
constexpr f64 CORNER_CHANCE = 0.6, OPPOSITE_CHANCE = 0.5;
// Pull of a piece to its place in the run, m^-2.
constexpr f64 RUN_PULL = 20.0;
// Of a leg: it begins at the end of its wall, whatever stretches that has.
constexpr f64 AT_END = -1.0;
// Least floor between two opposite rows (guideline 6: work aisle of 42 inches for one cook).
constexpr i64 AISLE_MM = 1067;

// The numbers that a run is read from: its order, and which way round; its wall; from which end of its wall each leg is laid; in which
// stretch a leg that begins in no corner; its form, and where it is cut in two; of each piece whether it is missed, and its variant.
enum Number : i32 { ORDER, MIRRORED, WALL, HIGH, OTHER_HIGH, STRETCH, OTHER_STRETCH, ROUND, ACROSS, CUT, OF_PIECES };
constexpr i32 MOST_NUMBERS = OF_PIECES + 2 * MOST_IN_RUN;

namespace {

class RunPlanner {
 public:
  RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted);
  Span<Candidate> best(Stream& stream);
 private:
  bool read(const u64* numbers, f64 lowest, Drawn& drawn) const;
  i32 read_form(const u64* numbers, const Order& order, Drawn& drawn) const;
  bool lay(const Member& member, const u64* numbers, i32 number, Drawn& drawn) const;
  f64 cost_of(const u64* numbers, f64 lowest);
  Leg round_corner(const Drawn& drawn) const;
  Leg new_leg(Wall wall, bool high, i64 beyond, f64 stretch) const;
  Interval spot(const Leg& leg, const Item& item) const;
  bool has_aisle(const Drawn& drawn) const;
  void place(const Drawn& drawn, Span<Candidate> places) const;
  void add_member(i32 word);
  List<Interval> stretches(Wall wall, i32 number) const;
  void add_effects(i32 word);
  void add_follower(const Leaving& wish, i32 kind);
  Subject subject(i32 word);
  f64 room_cost(const Drawn& drawn, Span<Candidate> places);

  const Scope& scope_;
  const WallOccupancy& walls_;
  const RoomType& type_;
  Span<Member> members_;                  // by word
  Span<List<const Member*>> orders_;
  Span<Laid> laid_;                       // space for the items of a run: those of the first leg end in the middle
  Span<const Item*> fits_;                // space for those of a member that fit
  Span<Candidate> places_, best_;         // by word
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
  nothing_.by_word = zeroes<List<i32>>(type.all_words);
  for (const CountedPiece& piece : counted) {
    if (piece.copies > 0) members_[type.pieces[piece.spec].word].piece = &piece;
  }
  laid_ = reserved<Laid>(2 * MOST_IN_RUN);
  fits_ = reserved<const Item*>(type.variants.size);
  places_ = reserved<Candidate>(type.all_words);
  best_ = reserved<Candidate>(type.all_words);
  free_ = zeroes<List<Interval>>(4 * type.kinds.size);
  for (i32 word : type.words) {
    if (members_[word].piece != nullptr && members_[word].items.size == 0) add_member(word);
  }
  for (const Leaving& wish : type.leaves) {
    const CountedPiece* piece = members_[wish.word].piece;
    if (piece != nullptr) add_follower(wish, piece->variants[0].kind);
  }
  orders_ = zeroes<List<const Member*>>(type.orders.size);
  for (i32 k = 0; k < orders_.size; k++) {
    for (i32 word : part_of(type.words, type.orders[k])) {
      if (members_[word].piece != nullptr) orders_[k].add(&members_[word]);
    }
  }
}

// Adds what a run may hold of a word: of all its variants those that suit come first, with the one that stands for them in a corner.
void RunPlanner::add_member(i32 word) {
  add_effects(word);
  Member& own = members_[word];
  const Span<Variant> all = type_.variants_of(type_.pieces[own.piece->spec]), suited = own.piece->variants;
  own.optional = !type_.pieces[own.piece->spec].required;
  own.items = {reserved<Item>(suited.size + all.size).data, suited.size};
  const Span<Item> items = {own.items.data, suited.size + all.size};
  const bool worktop = has(type_.worktop, word), landing = has(type_.landing, word), end = has(type_.ends, word);
  for (i32 k = 0; k < items.size; k++) {
    const Variant& variant = k < suited.size ? suited[k] : all[k - suited.size];
    const Kind& kind = type_.kinds[variant.kind];
    List<Interval>* free = &free_[4 * variant.kind];
    for (Wall wall : WALLS) {
      List<Interval>& found = free[static_cast<i32>(wall)];
      if (found.size() == 0) found = stretches(wall, variant.kind);
    }
    items[k] = {word, variant.kind, variant.cost, kind.width, kind.depth, worktop, landing, end, {nullptr, nullptr}, free};
  }
  for (Item& item : own.items) {
    for (i32 k = all.size - 1; k >= 0 && worktop; k--) {
      const Item& other = items[suited.size + k];
      if (all[k].corner < 0 || other.width != item.width) continue;
      item.corner[all[k].corner] = &other;
      own.turns[all[k].corner] = true;
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

// Tells whether an item may stand at a wall in an interval.
static bool fits(Wall wall, const Item& item, const Interval& within) {
  for (const Interval& one : item.free[static_cast<i32>(wall)]) {
    if (one.low <= within.low && within.high <= one.high) return true;
  }
  return false;
}

// The end of what stands at a wall that is nearer to the wall's high (low) end.
static Side end_at(Wall wall, bool high) {
  const Point left = rotated({-1, 0}, rotation_at(wall));
  return (left.x + left.z > 0) == high ? Side::left : Side::right;
}

// A leg that begins so far from an end of its wall; or, unless `stretch` is AT_END, where a stretch for its first item does.
Leg RunPlanner::new_leg(Wall wall, bool high, i64 beyond, f64 stretch) const {
  const Interval ends = scope_.clear.along(wall);
  const i64 at = high ? ends.high - beyond : ends.low + beyond;
  return {wall, high, stretch, at, at, 0};
}

// Where an item would stand next in a leg.
Interval RunPlanner::spot(const Leg& leg, const Item& item) const {
  i64 at = leg.at;
  const List<Interval>& free = item.free[static_cast<i32>(leg.wall)];
  if (leg.deepest == 0 && leg.stretch != AT_END && free.size() > 0) {
    const Interval own = free[static_cast<i32>(whole(leg.stretch * free.size()))], ends = scope_.clear.along(leg.wall);
    const i64 from = leg.high ? own.high : own.low;
    if (from != (leg.high ? ends.high : ends.low)) at = from;
  }
  return leg.high ? Interval{at - item.width, at} : Interval{at, at + item.width};
}

// Reads how a run is laid: at a wall, round a corner, or on at the opposite wall; returns how many pieces its first leg holds at most.
i32 RunPlanner::read_form(const u64* numbers, const Order& order, Drawn& drawn) const {
  const Wall wall = WALLS[Stream::below(numbers[WALL], 4)];
  const bool high = Stream::chance(numbers[HIGH], 0.5), other_high = Stream::chance(numbers[OTHER_HIGH], 0.5);
  const f64 stretch = Stream::unit(numbers[STRETCH]), other_stretch = Stream::unit(numbers[OTHER_STRETCH]);
  const bool round = Stream::chance(numbers[ROUND], CORNER_CHANCE), across = Stream::chance(numbers[ACROSS], OPPOSITE_CHANCE);
  const i32 hidden = static_cast<i32>(drawn.hidden = end_at(wall, high)), last = order.size() - 1;
  i32 corners = 0, first = last + 1;
  for (i32 k = 0; round && k < last; k++) corners += order[k].turns[hidden];
  if (corners > 0) {
    drawn.form = Form::corner;
    const i32 before = static_cast<i32>(whole(Stream::unit(numbers[CUT]) * corners));
    first = 0;
    for (i32 passed = -1; passed < before; first++) passed += order[first].turns[hidden];
  } else if (across && last > 0) {
    drawn.form = Form::opposite;
    first = 1 + static_cast<i32>(whole(Stream::unit(numbers[CUT]) * last));
  }
  drawn.legs[0] = new_leg(wall, high, scope_.gap, drawn.form == Form::corner ? AT_END : stretch);
  drawn.legs[1] = new_leg(opposite(wall), other_high, scope_.gap, other_stretch);
  return first;
}

// Lays what stands next in a leg, by its two numbers, of the variants that fit there; false where something does not fit that has to.
bool RunPlanner::lay(const Member& member, const u64* numbers, i32 number, Drawn& drawn) const {
  Leg& leg = drawn.legs[number];
  const bool corner = drawn.form == Form::corner && leg.deepest == 0, turns = corner && number == 0;
  const i64 deepest = corner && !turns ? drawn.items[drawn.first - 1].item->depth : NOWHERE_MM;
  const bool missed = member.optional && !turns && Stream::chance(numbers[0], MISSED_CHANCE);
  i32 count = 0;
  for (i32 k = 0; k < member.items.size && !missed; k++) {
    const Item* own = turns ? member.items[k].corner[static_cast<i32>(drawn.hidden)] : &member.items[k];
    if (own != nullptr && own->depth <= deepest && fits(leg.wall, *own, spot(leg, *own))) fits_[count++] = own;
  }
  if (count == 0) {
    drawn.cost += MISSED_COST;
    return member.optional && !turns;
  }
  const Item& item = *fits_[Stream::below(numbers[1], count)];
  const Interval over = spot(leg, item);
  if (leg.deepest == 0) leg.start = leg.high ? over.high : over.low;
  leg.at = leg.high ? over.low : over.high;
  leg.deepest = most(leg.deepest, item.depth);
  drawn.cost += item.cost;
  Span<Laid>& items = drawn.items;
  items = {number == 0 ? items.data - 1 : items.data, items.size + 1};
  items[number == 0 ? 0 : items.size - 1] = {&item, leg.wall, over.low};
  return true;
}

// Reads a run and lays it piece by piece, each leg from its corner or its end of the wall on; false where it does not fit, or is too dear.
bool RunPlanner::read(const u64* numbers, f64 lowest, Drawn& drawn) const {
  const Order order = {orders_[Stream::below(numbers[ORDER], orders_.size)].all(), Stream::chance(numbers[MIRRORED], 0.5)};
  drawn = {Form::straight, Side::left, {}, {laid_.data + MOST_IN_RUN, 0}, 0, 0.0};
  const i32 first = read_form(numbers, order, drawn);
  for (i32 k = first - 1; k >= 0; k--) {
    if (!lay(order[k], numbers + OF_PIECES + 2 * k, 0, drawn) || drawn.cost >= lowest) return false;
  }
  drawn.first = drawn.items.size;
  const bool corner = drawn.form == Form::corner;
  if (corner) drawn.legs[1] = round_corner(drawn);
  for (i32 k = first; k < order.size(); k++) {
    const i32 next = corner ? k : order.size() - 1 - (k - first);
    if (!lay(order[next], numbers + OF_PIECES + 2 * next, 1, drawn) || drawn.cost >= lowest) return false;
  }
  const bool whole = drawn.first > 0 && (drawn.form == Form::straight || drawn.first < drawn.items.size);
  return whole && (drawn.form != Form::opposite || has_aisle(drawn));
}

// The leg that goes on at the next wall, right behind what stands in the corner.
Leg RunPlanner::round_corner(const Drawn& drawn) const {
  const Wall wall = drawn.legs[0].wall;
  const Wall low_end = runs_along_x(wall) ? Wall::west : Wall::north, high_end = runs_along_x(wall) ? Wall::east : Wall::south;
  const bool from_low = wall == Wall::north || wall == Wall::west;
  return new_leg(drawn.legs[0].high ? high_end : low_end, !from_low, scope_.gap + drawn.items[drawn.first - 1].item->depth, AT_END);
}

// Tells whether a cook has room between two opposite rows.
bool RunPlanner::has_aisle(const Drawn& drawn) const {
  i64 across = runs_along_x(drawn.legs[0].wall) ? scope_.clear.depth() : scope_.clear.width();
  for (const Leg& leg : drawn.legs) across -= scope_.gap + leg.deepest;
  return across >= AISLE_MM;
}

// Fills in the places of a run's pieces.
void RunPlanner::place(const Drawn& drawn, Span<Candidate> places) const {
  for (Candidate& place : places) place = free_candidate(-1, 0.0);
  for (const Laid& laid : drawn.items) {
    const Item& item = *laid.item;
    places[item.word] = at_wall(scope_, type_, item.kind, laid.wall, laid.low + floor_div(item.width, 2), item.cost);
    places[item.word].weight = RUN_PULL;
  }
}

// What a run costs by what the rules of its pieces ask of the room: windows and doors.
f64 RunPlanner::room_cost(const Drawn& drawn, Span<Candidate> places) {
  f64 sum = 0.0;
  for (const Laid& laid : drawn.items) {
    const i32 word = laid.item->word;
    const Subject piece = subject(word);
    for (const Effect& effect : effects_[word]) sum += effect.relation->cost(piece, effect, places[word]);
  }
  return sum;
}

// What the run of some numbers costs, its places left in `places_`; where that is no less than the lowest cost, only that it is not.
f64 RunPlanner::cost_of(const u64* numbers, f64 lowest) {
  arena::Scope scope;
  Drawn drawn;
  if (!read(numbers, lowest, drawn)) return INFINITE;
  f64 cost = drawn.cost + row_cost(drawn) + worktop_cost(type_, drawn) + sliver_cost(scope_, drawn);
  if (cost >= lowest) return cost;
  place(drawn, places_);
  cost = cost + triangle_cost(type_, places_) + room_cost(drawn, places_);
  if (cost >= lowest) return cost;
  for (const Follower& follower : followers_) {
    Candidate& left = places_[follower.wish->word] = place_left(scope_, follower, drawn);
    if (left.kind < 0) cost += follower.wish->cost;
  }
  return cost;
}

Span<Candidate> RunPlanner::best(Stream& stream) {
  f64 lowest = INFINITE;
  u64 numbers[MOST_NUMBERS], kept[MOST_NUMBERS];
  i32 used = OF_PIECES;
  for (const auto& order : orders_) used = most(used, OF_PIECES + 2 * order.size());
  for (i32 search = 0; search < SEARCHES; search++) {
    f64 found = INFINITE;  // by this search
    for (i32 draw = 0; draw < DRAWS; draw++) {
      const bool at_random = draw < AT_RANDOM || found == INFINITE;
      for (i32 k = 0; k < used; k++) numbers[k] = at_random ? stream.bits() : kept[k];
      for (i32 k = 0; k < CHANGES && !at_random; k++) {
        const i32 changed = stream.below(used);
        numbers[changed] = stream.bits();
      }
      const f64 cost = cost_of(numbers, found);
      if (cost >= found) continue;
      found = cost;
      for (i32 k = 0; k < used; k++) kept[k] = numbers[k];
      if (cost >= lowest) continue;
      lowest = cost;
      swap(best_, places_);
    }
  }
  return lowest < INFINITE ? best_ : Span<Candidate>{};
}

}  // namespace

Span<Candidate> planned_run(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted,
                            Stream& stream) {
  return RunPlanner(scope, walls, type, counted).best(stream);
}

}  // namespace furnish
