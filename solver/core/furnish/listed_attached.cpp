// Ways to stand in another piece's frame: a box there for the relations to it, a rectangle in the room for those to the room.
//
// A box is where the piece's centre may lie, from the other's centre, in the other's frame: right +x, front +z.
#include "furnish/listed.hpp"
#include "furnish/relations/at_side.hpp"
#include "plain/rounding.hpp"

namespace furnish {

// What a place that slides along an axis costs more than an exact one, or one turned across the other: pieces line up where they can.
constexpr f64 SLIDING_COST = 0.04;
// What a place costs more, at most, at another of several pieces than the one that is dealt to whom asks for any of them.
constexpr f64 NOT_DEALT = 0.5;
// What halves of odd extents may add up to, mm.
constexpr i64 SLACK_MM = 2;
// Most ways of a piece between others that stand.
constexpr i32 BETWEEN_OTHERS = 12;

// Where the centre may be in the room with the other, turned so, anywhere in a rectangle.
static Rect in_room(const Rect& box, i32 rotation, const Rect& centre) {
  const Point a = rotated({box.x0, box.z0}, rotation), b = rotated({box.x1, box.z1}, rotation);
  return {centre.x0 + least(a.x, b.x), centre.z0 + least(a.z, b.z), centre.x1 + most(a.x, b.x), centre.z1 + most(a.z, b.z)};
}

// Whether a relation lets a piece reach under another one, as far as their parts do not cross.
static bool is_tucking(const Bond& pair) {
  return pair.owner < 0 && (pair.rule->word == Word::under || (pair.rule->has_gap && pair.rule->gap.low < 0));
}

// Whether the walls at the backs of a piece and an earlier one lie as a relation between them wants.
static bool suits(const Bond& pair, Wall mine, Wall theirs) {
  return pair.owner < 0 ? pair.relation().suits(pair.rule->wall, mine, theirs) : pair.relation().suits(pair.rule->wall, theirs, mine);
}

static List<DoubleBox> boxes(
    const Listing& in, const Bond& pair, const Kind& own, const Kind& other, i32 turn, const Setting& setting = {}) {
  const Asked asked = in.asked(*pair.rule);
  List<DoubleBox> found;
  pair.relation().boxes({asked, other.size(), turned(own.size(), turn), turn, own.height, in.type.levels_of(other),
                         in.type.parts_of(other), in.type.parts_of(own), setting}, found);
  return found;
}

// What it costs to have the place that a relation gives at a piece: it is dealt the first of those it is to.
static f64 dealt_cost(const Bond& pair, i32 other) {
  return pair.earlier[0] != other && pair.relation().gives_place ? least(NOT_DEALT, 0.5 * pair.rule->missed()) : 0.0;
}

static f64 sliding_cost(const Bond& pair, const Rect& box, i32 turn) {
  const bool across = turn % 180 != 0 && !pair.relation().turns;
  return pair.relation().gives_place ? SLIDING_COST * ((box.x0 < box.x1) + (box.z0 < box.z1) + across) : 0.0;
}

// The boxes in the other's frame in which a relation surely holds: to it, or its own to this piece.
static List<Costed> held_boxes(const Seeker& seeker, const Bond& pair, i32 other, i32 turn) {
  List<Costed> found;
  const bool is_own = pair.owner < 0;
  const Kind& theirs = seeker.in.type.kind(seeker.in.rows[other].kind);
  const Kind &from = is_own ? seeker.kind() : theirs, &to = is_own ? theirs : seeker.kind();
  const Setting setting = other == pair.earlier[0] ? pair.setting : Setting{};
  for (const DoubleBox& one : boxes(seeker.in, pair, from, to, is_own ? turn : (360 - turn) % 360, setting)) {
    Rect box = rounded(one);
    if (!is_own) box = in_room({-box.x1, -box.z1, -box.x0, -box.z0}, turn, {});
    found.add({box, (one.is_seat ? 0.0 : sliding_cost(pair, box, turn)) + dealt_cost(pair, other)});
  }
  return found;
}

// Boxes in the other's frame, each holding at least one of the relations that are `suited`, bit by bit; cheapest first.
static List<Costed> costed_boxes(Seeker& seeker, Span<Bond> pairs, u64 suited, i32 other, i32 turn) {
  List<Costed> found, held;
  found.add({ANY_PLACE, 0.0});
  for (i32 i = 0; i < pairs.size; i++) {
    const List<Costed> hold = suited >> i & 1 ? held_boxes(seeker, pairs[i], other, turn) : List<Costed>{};
    found = with_rule(seeker, found, *pairs[i].rule, hold, {0, 0}, seeker.in.kept.boxes);
  }
  for (const Costed& one : found) {
    if (one.rect != ANY_PLACE) held.add(one);
  }
  return held;
}

// Attaches a way to a stance of another piece, its centre in a box of that one's frame.
static void attach(const Listing& in, Candidate& way, i32 other, Stance stance, const Rect& box) {
  way.parent = other;
  way.parent_kind = in.rows[other].kind;
  way.parent_stance = stance_number(stance.rotation, stance.wall);
  way.across = {box.x0, box.x1};
  way.along = {box.z0, box.z1};
}

// Adds the places on another piece's surface; it stands as that piece does.
static void add_resting(const Seeker& seeker, Span<Bond> pairs, i32 other, List<Candidate>& found) {
  const Kind& carrier = seeker.in.type.kind(seeker.in.rows[other].kind);
  for (const Bond& pair : pairs) {
    if (pair.rule->word != Word::on) continue;
    for (const Way& parent : seeker.in.ways[other]) {
      for (const DoubleBox& box : boxes(seeker.in, pair, seeker.kind(), carrier, 0)) {
        Candidate& made = found.add(seeker.way({parent.stance.rotation, Wall::none}, dealt_cost(pair, other), FIRM));
        attach(seeker.in, made, other, parent.stance, rounded(box));
        made.rotation = 0;
        made.slot = Slot::level;
        made.slot_number = box.level;
        made.is_on = 1;
        made.bottom = seeker.in.type.levels_of(carrier)[box.level].height;
      }
    }
  }
}

namespace {

// A place beside another piece: what it costs, how the piece stands, its box there, its rectangle in the room.
struct Beside {
  f64 cost;
  const Foothold* at;
  Rect box, rect;
};

// What one stance of another piece leaves a piece, by the relations between them.
class Frames {
 public:
  Frames(Seeker& seeker, Span<Bond> pairs, i32 other, f64 others)
      : seeker_(seeker), in_(seeker.in), pairs_(pairs), other_(other), others_(others) {
    for (const Bond& pair : pairs) pull_ = pair.relation().gives_place ? FIRM : pull_;
  }

  // Adds the cheapest places of all stances beside one stance of the other.
  void add(Span<Foothold> every, const Way& parent, f64 dearest, List<Candidate>& found) {
    List<Beside> places;
    for (const Foothold& at : every) add_in_both(at, parent, dearest, places);
    stable_sort(places.all(), [](const Beside& a, const Beside& b) { return rounded_9(a.cost) < rounded_9(b.cost); });
    const i64 most = in_.kept.beside;
    if (places.size() > most) seeker_.drop(places[most].cost + others_);
    places.cut(static_cast<i32>(most));
    for (const Beside& place : places) add_way(place, parent, found);
  }

 private:
  struct Both {
    f64 cost;
    i32 box, rect;
  };

  // Boxes that each hold at least one relation, cheapest first.
  List<Costed> boxes(Stance parent, Stance own) {
    u64 suited = 0;
    for (i32 i = 0; i < pairs_.size; i++) suited |= static_cast<u64>(suits(pairs_[i], own.wall, parent.wall)) << i;
    const i32 turn = (360 + own.rotation - parent.rotation) % 360;
    return costed_boxes(seeker_, pairs_, suited, other_, turn);
  }

  // Adds the cheapest pairs of a box in the other's frame and a rectangle in the room that can hold together.
  void add_in_both(const Foothold& at, const Way& parent, f64 dearest, List<Beside>& places) {
    places.reserve(places.size() + static_cast<i32>(in_.kept.places));
    arena::Scope scope;
    const List<Costed> held = boxes(parent.stance, at.stance);
    List<Both> pairs;
    for (i32 i = 0; i < held.size(); i++) {
      for (i32 j = 0; j < at.found.size(); j++) pairs.add({held[i].cost + at.found[j].cost, i, j});
    }
    stable_sort(pairs.all(), [](const Both& a, const Both& b) { return a.cost < b.cost; });
    const i64 half_x = floor_div(at.extent.x, 2), half_z = floor_div(at.extent.z, 2);
    i64 count = 0;
    for (const Both& pair : pairs) {
      if (count == in_.kept.places) return seeker_.drop(pair.cost + others_);
      const Rect &box = held[pair.box].rect, &rect = at.found[pair.rect].rect;
      const Rect centres = in_room(box, parent.stance.rotation, parent.reach).shrunk(-SLACK_MM);
      const bool across = centres.x0 <= rect.x1 - half_x && rect.x0 + half_x <= centres.x1;
      if (!across || centres.z0 > rect.z1 - half_z || rect.z0 + half_z > centres.z1) continue;
      count++;
      if (pair.cost < dearest) places.add({pair.cost, &at, box, rect});
    }
  }

  void add_way(const Beside& place, const Way& parent, List<Candidate>& found) {
    const Rect& clear = in_.scope.clear;
    const i64 far = most(clear.width(), clear.depth()), end = ANY_PLACE.x1;
    // What has no end is cut off where the room ends, so that its middle means something.
    const auto clipped = [&](i64 low, i64 high) {
      if (low <= -end) low = least(-far, high);
      return Interval{low, high >= end ? most(far, low) : high};
    };
    Candidate& made = found.add(seeker_.way(place.at->stance, place.cost + others_, pull_));
    attach(in_, made, other_, parent.stance, place.box);
    made.across = clipped(place.box.x0, place.box.x1);
    made.along = clipped(place.box.z0, place.box.z1);
    made.rotation = (360 + made.rotation - parent.stance.rotation) % 360;
    made.within = place.rect;
    made.is_under = is_tucked(made.rotation, place.box);
  }

  bool is_tucked(i32 turn, const Rect& box) const {
    for (const Bond& pair : pairs_) {
      if (!is_tucking(pair)) continue;
      for (const Costed& held : held_boxes(seeker_, pair, other_, turn)) {
        if (held.rect.contains(box)) return true;
      }
    }
    return false;
  }

  Seeker& seeker_;
  const Listing& in_;
  Span<Bond> pairs_;
  i32 other_;
  f64 others_;  // what relations with further pieces cost here
  f64 pull_ = LOOSE;
};

}  // namespace

// Adds the ways attached to one other piece.
static void add_attached_to(Seeker& seeker, i32 other, Span<Foothold> every, f64 dearest, List<Candidate>& found) {
  List<Bond> mine;
  f64 others = 0.0;
  bool rests = false;
  for (const Bond& pair : seeker.pairs) {
    if (!has(pair.earlier.all(), other)) {
      others += (pair.rule->required ? GONE : pair.rule->cost) * (pair.relation().gives_place ? 1.0 : UNSURE);
      continue;
    }
    mine.add(pair);
    rests = rests || pair.rule->word == Word::on;
  }
  if (rests) return add_resting(seeker, mine.all(), other, found);
  Frames frames(seeker, mine.all(), other, others);
  for (const Way& parent : seeker.in.ways[other]) frames.add(every, parent, dearest - others, found);
}

void add_attached(Seeker& seeker, Span<Foothold> every, f64 dearest, List<Candidate>& found) {
  List<i32> met;
  for (const Bond& pair : seeker.pairs) {
    for (i32 other : pair.earlier) {
      if (has(met.all(), other)) continue;
      met.add(other);
      add_attached_to(seeker, other, every, dearest, found);
    }
  }
}

namespace {

// A rectangle within which a footprint holds a relation with another piece where it stands, and the box of it.
struct Held {
  i32 other;
  Stance stance;
  Rect box, rect;
};

}  // namespace

// The rectangles within which a footprint holds a relation with any of the pieces it is between, where they stand.
static List<Held> held_at(Seeker& seeker, const Bond& pair, const Foothold& at, Span<StandsRow> others) {
  List<Held> found;
  if (pair.rule->word == Word::on) return found;
  Bond alone = pair;
  for (i32 other : pair.earlier) {
    const Rect& there = others[other].at;
    const Stance stance = others[other].stance;
    bool is_way = false;
    for (const Way& parent : seeker.in.ways[other]) is_way = is_way || parent.stance == stance;
    if (!is_way || there == Rect{}) continue;
    // Twice the other's centre is whole; its halves are rounded outwards.
    const i64 x = there.x0 + there.x1, z = there.z0 + there.z1;
    const Rect own{floor_div(x - at.extent.x, 2), floor_div(z - at.extent.z, 2), floor_div(x + at.extent.x + 1, 2),
                   floor_div(z + at.extent.z + 1, 2)};
    const i32 turn = (360 + at.stance.rotation - stance.rotation) % 360;
    for (const Costed& one : costed_boxes(seeker, {&alone, 1}, suits(pair, at.stance.wall, stance.wall), other, turn)) {
      if (one.cost < pair.rule->cost) found.add({other, stance, one.rect, in_room(one.rect, stance.rotation, own)});
    }
  }
  return found;
}

List<Candidate> between_others(Seeker& seeker, Span<Foothold> footholds, Span<StandsRow> others) {
  List<Candidate> found;
  for (const Foothold& at : footholds) {
    List<Costed> places = at.found;
    List<Held> tucked;
    for (const Bond& pair : seeker.pairs) {
      const List<Held> held = held_at(seeker, pair, at, others);
      List<Costed> rects;
      for (const Held& one : held) rects.add({one.rect, 0.0});
      places = with_rule(seeker, places, *pair.rule, rects, at.extent, seeker.in.kept.rects);
      if (is_tucking(pair)) tucked.add_all(held.all());
    }
    for (i32 i = 0; i < least<i64>(seeker.in.kept.places, places.size()); i++) {
      const Rect& rect = places[i].rect;
      Candidate& made = found.add(seeker.way(at.stance, places[i].cost, LOOSE));
      made.wall = at.stance.wall;
      made.anchor = rect.centre();
      made.within = rect;
      for (const Held& other : tucked) {
        if (!other.rect.contains(rect)) continue;
        attach(seeker.in, made, other.other, other.stance, other.box);
        made.rotation = (360 + made.rotation - other.stance.rotation) % 360;
        made.wall = Wall::none;
        made.is_under = 1;
        break;
      }
    }
  }
  stable_sort(found.all(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  found.cut(BETWEEN_OTHERS);
  return found;
}

}  // namespace furnish
