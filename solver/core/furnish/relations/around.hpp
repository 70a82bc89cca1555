// `around`: at one of the places around another piece, looking at it; long sides take several, filled in pairs.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

// What each later place along the sides costs: chairs fill a table in pairs.
constexpr f64 SLOT_COST = 0.01;
// Free width between neighbours around a table.
constexpr i64 ELBOW_MM = 100;

constexpr Side ALL_SIDES[] = {Side::front, Side::back, Side::left, Side::right};

inline Span<const Side> all_or(Span<Side> named) {
  return named.size ? Span<const Side>{named.data, named.size} : Span<const Side>{ALL_SIDES, 4};
}

// One of the pieces that are asked to stand around another one: its width, and the sides it may be at.
struct Guest {
  i64 width;
  Span<const Side> sides;
};

// The places around a piece while they are dealt, one after the other: those who come share the long sides evenly, and the ends have what
// is left. Nobody sits where there is no room, or at a closed side, bit by Side.
class Seating {
 public:
  Seating(const Kind& parent, i32 closed, i64 elbow) : parent_(parent), closed_(closed), elbow_(elbow) {}

  // Adds a place for one more, at the end of its side; false where none has room.
  bool add(const Guest& guest) {
    Place best;
    for (Side side : guest.sides) {
      const bool is_full = at(side).count > 0 && at(side).width + guest.width + elbow_ > length(side);
      if (closed_ >> static_cast<i32>(side) & 1 || is_full) continue;
      if (best.width == 0 || is_better(side, best.side)) best = {side, guest.width + elbow_, at(side)};
    }
    if (best.width == 0) return false;
    at(best.side) = {best.before.width + best.width, best.before.count + 1};
    places_.add(best);
    return true;
  }

  i32 size() const { return places_.size(); }

  // Where the place added so is, when all are: spare length is shared.
  Setting operator[](i32 number) const {
    const Place& own = places_[number];
    const Laid& all = at(own.side);
    const i64 spare = length(own.side) - all.width;
    const i64 middle = 2 * own.before.width + own.width - length(own.side) + floor_div((2 * own.before.count + 1) * spare, all.count);
    return {true, own.side, middle, own.width + floor_div(spare, all.count)};
  }

 private:
  struct Laid {
    i64 width = 0;
    i32 count = 0;
  };
  struct Place {
    Side side = Side::front;
    i64 width = 0;
    Laid before;  // at its side
  };

  Laid& at(Side side) { return laid_[static_cast<i32>(side)]; }
  const Laid& at(Side side) const { return laid_[static_cast<i32>(side)]; }
  i64 length(Side side) const { return is_lateral(side) ? parent_.depth : parent_.width; }
  bool is_better(Side side, Side than) const {
    return length(side) == length(than) ? at(side).width < at(than).width : length(side) > length(than);
  }

  const Kind& parent_;
  i32 closed_;
  i64 elbow_;
  Laid laid_[4];
  List<Place> places_;
};

// Where each of some guests sits, those with the fewest sides first. Where some are left over, all sit closer.
inline List<Setting> settings(const Kind& parent, i32 closed, Span<Guest> guests, i64 elbow = ELBOW_MM) {
  Seating seating(parent, closed, elbow);
  List<i32> seats;
  for (i32 i = 0; i < guests.size; i++) seats.add(-1);
  for (i32 choice = 1; choice <= 4; choice++) {
    for (i32 i = 0; i < guests.size; i++) {
      if (guests[i].sides.size != choice) continue;
      if (seating.add(guests[i])) seats[i] = seating.size() - 1;
      else if (elbow > 0) return settings(parent, closed, guests, 0);
    }
  }
  List<Setting> found;
  for (i32 seat : seats) found.add(seat < 0 ? Setting{} : seating[seat]);
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
        Seating seats(subject.type.kinds[parent.kind], 0, ELBOW_MM);
        while (seats.add({subject.type.kinds[variant.kind].width, sides(subject, rule)})) {
        }
        for (i32 rank = 0; rank < seats.size(); rank++) {
          const Setting seat = seats[rank];
          const Pair pair{parent, variant.kind, towards(seat.side), seat.side};
          add_seat(subject, pair, floor_div(seat.middle, 2), slot_gap(rule), variant.cost + SLOT_COST * rank, effect);
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
