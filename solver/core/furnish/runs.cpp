#include "furnish/runs.hpp"

namespace furnish {

// Runs drawn for a room; the best of those that fit is taken (measured: more find no better triangles).
constexpr i32 DRAWS = 300;
// Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter than 4 feet
// or longer than 9 feet), and of the sum of its legs (at most 26 feet; 4 m is what three shortest legs come to).
constexpr f64 SHORTEST_LEG = 1.2, LONGEST_LEG = 2.7, LEAST_PERIMETER = 4.0, MOST_PERIMETER = 7.9;
// What a metre beyond these costs.
constexpr f64 LEG_COST = 8.0, PERIMETER_COST = 8.0;
// What a run without a piece that it could hold costs, how often one is drawn without it, and how often a run goes round a corner it could.
constexpr f64 MISSED_COST = 0.7, MISSED_CHANCE = 0.3, CORNER_CHANCE = 0.7;
// Most that a run costs by the seed alone.
constexpr f64 PREFERENCE = 0.5;
// Pull of a piece to its place in the run, m^-2.
constexpr f64 FIRM = 20.0;
// Least width of a piece in a corner: what stands round the corner covers 0.6 m of its front, a person takes half of 0.6 m.
constexpr i64 CORNER_MM = 900 + 50;

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

// A run as it is drawn: its items by word, each with its place.
struct Drawn {
  List<Item> items;
  Wall wall;
  bool high;
  i32 corner;  // how many items stand along the first wall
  f64 cost;
};

class RunPlanner {
 public:
  RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted);
  Span<Candidate> best(Stream& stream);

 private:
  Drawn draw(Stream& stream) const;
  void draw_items(Stream& stream, Drawn& drawn) const;
  List<Leg> legs_of(const Drawn& drawn) const;
  Leg leg(Wall wall, Span<Item> items, i64 corner, bool high) const;
  bool place(const List<Leg>& legs, Span<Candidate> places) const;
  bool holds(Wall wall, i32 kind, i64 start) const;
  void look_up(i32 kind);
  f64 triangle_cost(Span<Candidate> places) const;
  void clear(Span<Candidate> places) const;
  bool may_be_in_corner(const Item& item) const;
  i64 length_of(Span<Item> items) const;

  const Scope& scope_;
  const WallOccupancy& walls_;
  const RoomType& type_;
  Span<const CountedPiece*> there_;       // by word
  Span<Candidate> places_, best_;         // by word
  Span<List<Interval>> free_;             // stretches by kind and wall, of the kinds that a run may hold
};

RunPlanner::RunPlanner(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted)
    : scope_(scope), walls_(walls), type_(type) {
  there_ = zeroes<const CountedPiece*>(type.all_words);
  for (const CountedPiece& piece : counted) {
    if (piece.copies > 0) there_[type.pieces[piece.spec].word] = &piece;
  }
  places_ = reserved<Candidate>(type.all_words);
  best_ = reserved<Candidate>(type.all_words);
  free_ = zeroes<List<Interval>>(4 * type.kinds.size);
  for (i32 word : type.words) {
    if (there_[word] == nullptr) continue;
    for (const Variant& variant : there_[word]->variants) look_up(variant.kind);
  }
}

// Finds where a kind may stand along the walls; it is asked many times.
void RunPlanner::look_up(i32 kind) {
  for (Wall wall : WALLS) {
    List<Interval>& found = free_[4 * kind + static_cast<i32>(wall)];
    if (found.size() == 0) found = walls_.stretches(wall, type_.kinds[kind], false);
  }
}

void RunPlanner::clear(Span<Candidate> places) const {
  for (Candidate& place : places) place = free_candidate(-1, 0.0);
}

// Tells whether a piece may stand at a wall from a coordinate on.
bool RunPlanner::holds(Wall wall, i32 kind, i64 start) const {
  for (const Interval& one : free_[4 * kind + static_cast<i32>(wall)]) {
    if (one.low <= start && start + type_.kinds[kind].width <= one.high) return true;
  }
  return false;
}

bool RunPlanner::may_be_in_corner(const Item& item) const {
  for (i32 word : type_.corners) {
    if (word == item.word) return type_.kinds[item.kind].width >= CORNER_MM;
  }
  return false;
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

// Draws a run, at a wall or round a corner.
Drawn RunPlanner::draw(Stream& stream) const {
  Drawn drawn{};
  draw_items(stream, drawn);
  drawn.wall = WALLS[stream.below(4)];
  drawn.high = stream.chance(0.5);
  List<i32> corners;
  for (i32 i = 0; i + 1 < drawn.items.size(); i++) {
    if (may_be_in_corner(drawn.items[i])) corners.add(i);
  }
  const bool round = corners.size() > 0 && stream.chance(CORNER_CHANCE);
  drawn.corner = round ? stream.pick(corners.all()) + 1 : drawn.items.size();
  return drawn;
}

// Lays items along a wall, in the order from its low end, as near to its low or high end as what stands in the corner leaves.
Leg RunPlanner::leg(Wall wall, Span<Item> items, i64 corner, bool from_high) const {
  const Interval ends = scope_.clear.along(wall);
  Leg made{wall, from_high ? ends.high - corner - length_of(items) : ends.low + corner, {}};
  made.items.add_all(items);
  return made;
}

static Span<Item> reversed(Span<Item> items) {
  List<Item> made;
  for (i32 i = items.size - 1; i >= 0; i--) made.add(items[i]);
  return made.all();
}

// Lays the first half along a wall into its low or high corner, the second half from there along the next wall. The first half's last item
// is the one in the corner.
List<Leg> RunPlanner::legs_of(const Drawn& drawn) const {
  const Span<Item> all = drawn.items.all();
  const Span<Item> first{all.data, drawn.corner}, second{all.data + drawn.corner, all.size - drawn.corner};
  List<Leg> legs;
  legs.add(leg(drawn.wall, drawn.high ? first : reversed(first), scope_.gap, drawn.high));
  if (second.size == 0) return legs;
  const Wall low_end = runs_along_x(drawn.wall) ? Wall::west : Wall::north, high_end = runs_along_x(drawn.wall) ? Wall::east : Wall::south;
  const i64 beyond = scope_.gap + type_.kinds[first[first.size - 1].kind].depth;
  const bool from_low = drawn.wall == Wall::north || drawn.wall == Wall::west;
  legs.add(leg(drawn.high ? high_end : low_end, from_low ? second : reversed(second), beyond, !from_low));
  return legs;
}

// Fills in the places of a run's pieces; false where one of them is in the way of an opening or does not fit.
bool RunPlanner::place(const List<Leg>& legs, Span<Candidate> places) const {
  clear(places);
  for (const Leg& leg : legs) {
    i64 at = leg.start;
    for (const Item& item : leg.items) {
      if (!holds(leg.wall, item.kind, at)) return false;
      const i64 width = type_.kinds[item.kind].width;
      places[item.word] = at_wall(scope_, type_, item.kind, leg.wall, at + floor_div(width, 2), item.cost);
      places[item.word].weight = FIRM;
      at += width;
    }
  }
  return true;
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
  return LEG_COST * beyond + PERIMETER_COST * off;
}

Span<Candidate> RunPlanner::best(Stream& stream) {
  clear(best_);
  f64 lowest = INFINITE;
  for (i32 i = 0; i < DRAWS; i++) {
    arena::Scope scope;
    const Drawn drawn = draw(stream);
    if (!place(legs_of(drawn), places_)) continue;
    const f64 cost = drawn.cost + triangle_cost(places_);
    if (cost >= lowest) continue;
    lowest = cost;
    swap(best_, places_);
  }
  return best_;
}

}  // namespace

Span<Candidate> planned_run(const Scope& scope, const WallOccupancy& walls, const RoomType& type, const List<CountedPiece>& counted,
                            Stream& stream) {
  return RunPlanner(scope, walls, type, counted).best(stream);
}

}  // namespace furnish
