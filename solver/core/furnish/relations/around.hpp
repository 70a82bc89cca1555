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

class Around : public AtSide {
 public:
  constexpr Around() : AtSide({SIDES, 4, 50, 0, true, {20, 280}, {-10'000, 300}, Align::none}) {}

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

  // First its own seat: all that are asked for share the long sides evenly, and the ends what is left.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const Span<Side> named = fit.asked.sides;
    const i64 width = (fit.turn % 180 == 0 ? fit.own.x : fit.own.z) + ELBOW_MM, spare = 2 * fit.asked.tolerance.inside;
    const auto length_of = [&](Side side) { return is_lateral(side) ? fit.parent.z : fit.parent.x; };
    i32 number = fit.among.number, of = fit.among.of;
    for (i32 ends = 0; ends < 2; ends++) {
      List<Side> own;
      for (Side side : named.size ? Span<const Side>{named.data, named.size} : Span<const Side>{SIDES, 4}) {
        if ((length_of(side) < most(fit.parent.x, fit.parent.z)) == ends) own.add(side);
      }
      if (own.size() == 0) continue;
      const i64 length = length_of(own[0]);
      const i32 here = least(of, own.size() * static_cast<i32>(most<i64>(1, floor_div(length, width))));
      if (number >= 0 && number < here) {
        const i32 at = number % own.size(), there = here / own.size() + (at < here % own.size());
        const i64 low = floor_div(2 * (number / own.size()) * length, there) - length, wide = floor_div(2 * length, there);
        const Interval part{low + spare, low + wide - spare};
        if (towards(own[at]) == fit.turn && fit.asked.rule.align == Align::none) add_seat_box(fit, own[at], part, found);
      }
      number -= here;
      of -= here;
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

  static constexpr Side SIDES[] = {Side::front, Side::back, Side::left, Side::right};
};

}  // namespace furnish
