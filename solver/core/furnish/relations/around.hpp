// `around`: at one of the places around another piece, looking at it; long sides take several, filled in pairs.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

// What each later place along the sides costs: chairs fill a table in pairs.
constexpr f64 SLOT_COST = 0.01;
// Free width between neighbours around a table.
constexpr i64 ELBOW_MM = 100;
// More than any side has places: the ends of a table come last.
constexpr i32 END_RANK = 100;

constexpr Side ALL_SIDES[] = {Side::front, Side::back, Side::left, Side::right};

inline Span<const Side> all_or(Span<Side> named) {
  return named.size ? Span<const Side>{named.data, named.size} : Span<const Side>{ALL_SIDES, 4};
}

// One of the pieces that are asked to stand around another one: its width, and the sides it may be at.
struct Guest {
  i64 width;
  Span<const Side> sides;
};

// Where each sits, those with the fewest sides first: they share the long sides evenly, and the ends what is left. Nobody sits where there
// is no room, or at a closed side, bit by Side. Where some are left over, all sit closer.
inline List<Setting> settings(const Kind& parent, i32 closed, Span<Guest> guests, i64 elbow = ELBOW_MM) {
  struct Laid {
    i64 width = 0;
    i32 count = 0;
  };
  Laid laid[4];  // by Side
  List<Setting> found;
  List<Laid> before;  // each: what was laid at its side
  const auto at = [&](Side side) -> Laid& { return laid[static_cast<i32>(side)]; };
  const auto length = [&](Side side) { return is_lateral(side) ? parent.depth : parent.width; };
  const auto is_better = [&](Side side, Side than) {
    return length(side) == length(than) ? at(side).width < at(than).width : length(side) > length(than);
  };
  for (i32 i = 0; i < guests.size; i++) {
    found.add({});
    before.add({});
  }
  for (i32 choice = 1; choice <= 4; choice++) {
    for (i32 i = 0; i < guests.size; i++) {
      if (guests[i].sides.size != choice) continue;
      const i64 width = guests[i].width + elbow;
      Setting& own = found[i];
      for (Side side : guests[i].sides) {
        if (closed >> static_cast<i32>(side) & 1 || (at(side).count > 0 && at(side).width + width > length(side))) continue;
        if (!own.is_laid || is_better(side, own.side)) own = {true, side, {}};
      }
      if (!own.is_laid && elbow > 0) return settings(parent, closed, guests, 0);
      if (!own.is_laid) continue;
      before[i] = at(own.side);
      at(own.side) = {before[i].width + width, before[i].count + 1};
    }
  }
  for (i32 i = 0; i < guests.size; i++) {
    const Laid& all = at(found[i].side);
    const auto end = [&](i64 taken, i32 count) {  // doubled, with its share of the spare length
      const i64 whole = length(found[i].side);
      return 2 * taken - whole + floor_div(2 * count * (whole - all.width), most(1, all.count));
    };
    found[i].part = {end(before[i].width, before[i].count), end(before[i].width + guests[i].width + elbow, before[i].count + 1)};
  }
  return found;
}

class Around : public AtSide {
 public:
  constexpr Around() : AtSide({ALL_SIDES, 4, 50, 0, true, {20, 280}, {-10'000, 300}, Align::none}) {}

  // Offers every seat of every parent.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const List<Parent> parents = subject.parents(rule);
    for (const Variant& variant : subject.variants) {
      for (const Parent& parent : parents) {
        const List<Seat> places = seats(subject, rule, subject.type.kinds[parent.kind], subject.type.kinds[variant.kind]);
        for (i32 rank = 0; rank < places.size(); rank++) {
          const Pair pair{parent, variant.kind, towards(places[rank].side), places[rank].side};
          add_seat(subject, pair, places[rank].shift, slot_gap(rule), variant.cost + SLOT_COST * rank, effect);
        }
      }
    }
  }

  // For whom a seat is laid: first that, then the line along each side that seats are on; then all that hold.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const Asked& asked = fit.asked;
    if (fit.setting.is_laid && towards(fit.setting.side) == fit.turn) add_seat_box(fit, found);
    for (Side side : all_or(asked.sides)) {
      if (!fit.setting.is_laid || asked.rule.has_gap || towards(side) != fit.turn) continue;
      found.add(beside(fit.parent, fit.own, side, slot_gap(asked.rule), asked.rule.align, asked.tolerance));
    }
    AtSide::boxes(fit, found);
  }

 private:
  struct Seat {
    Side side;
    i32 rank;
    i64 shift;
  };

  // The places along all sides, the middles of long sides first.
  List<Seat> seats(const Subject& subject, const Rule& rule, const Kind& parent, const Kind& own) const {
    List<Seat> found;
    for (Side side : sides(subject, rule)) {
      const i64 length = is_lateral(side) ? parent.depth : parent.width;
      const i64 number = most<i64>(1, floor_div(length, own.width + ELBOW_MM));
      const i32 end = length < most(parent.width, parent.depth) ? END_RANK : 0;
      for (i32 i = 0; i < number; i++) {
        found.add({side, end + i, floor_div(floor_div((2 * i + 1) * length, number) - length, 2)});
      }
    }
    stable_sort(found.all(), [](const Seat& a, const Seat& b) { return a.rank < b.rank; });
    return found;
  }

  // Adds the candidates at a place around a parent.
  void add_seat(const Subject& subject, const Pair& pair, i64 shift, Interval gap, f64 cost, Effect& effect) const {
    const Extent parent = subject.type.kinds[pair.parent.kind].size(), own = turned(subject.type.kinds[pair.kind].size(), pair.rotation);
    Rect wish = at_side(parent, own, pair.side, gap, Align::centre), near = wish;
    constexpr i64 SLIDE = ELBOW_MM / 2;
    if (is_lateral(pair.side)) {
      wish.z0 = wish.z1 = shift;
      near.z0 = shift - SLIDE;
      near.z1 = shift + SLIDE;
    } else {
      wish.x0 = wish.x1 = shift;
      near.x0 = shift - SLIDE;
      near.x1 = shift + SLIDE;
    }
    Candidate slot = free_candidate(pair.kind, cost);
    slot.slot = Slot::seat;
    slot.slot_number = shift;
    add_places(subject, pair, slot, gap, wish, near, effect);
  }
};

}  // namespace furnish
