// The relations that place a piece at a side of another one: beside, in_front_of, under; their geometry is that of around and in_row too.
//
// Offsets are in the other's own frame, mm, from its centre to the piece's centre: front +z, right +x. Halves are kept by doubling.
#pragma once

#include "furnish/relations/relation.hpp"
#include "plain/rounding.hpp"

namespace furnish {

// The turn, in the other's frame, with which a piece at that side faces it.
constexpr i32 towards(Side side) { return side == Side::left ? 90 : side == Side::right ? 270 : side == Side::front ? 180 : 0; }

// The doubled offsets along a side with which two lengths line up; by default they share a part of the shorter one, exactly: all of it.
constexpr Interval lined_up(i64 parent, i64 own, Align align, const Tolerance& tolerance = EXACT) {
  const i64 edge = align == Align::back ? own - parent : parent - own;
  if (align == Align::back || align == Align::front) return {edge - 2 * tolerance.flush, edge + 2 * tolerance.flush};
  if (align == Align::centre) return {-2 * tolerance.nearly, 2 * tolerance.nearly};
  const i64 half = most<i64>(parent + own - tolerance.shared_halves * least(parent, own) - 2 * tolerance.inside, 0);
  return {-half, half};
}

constexpr Interval rounded(Interval doubled) { return {rounded_half(doubled.low), rounded_half(doubled.high)}; }

constexpr Rect rounded(const DoubleBox& box) {
  const Interval across = rounded(box.across), along = rounded(box.along);
  return {across.low, along.low, across.high, along.high};
}

// Where the centre of a piece lies that stands at a side of its parent, a gap away and lined up with it; the same, exactly, rounded.
DoubleBox beside(Extent parent, Extent own, Side side, Interval gap, Align align, const Tolerance& tolerance);
Rect at_side(Extent parent, Extent own, Side side, Interval gap, Align align);

// Another piece, and how the own kind is turned at it.
struct Pair {
  Parent parent;
  i32 kind;
  i32 rotation;
  Side side;
};

class AtSide : public Relation {
 public:
  // What one word of them means: its sides, the gap where none is named, the gap of what was to reach under the other where parts leave
  // no room for it, mm, and whether it must face the other. Asked for, without a gap: the free space with which it is sought, with which it
  // holds, and how the place at `gap` lines up, where that is better than the rest.
  struct Meaning {
    const Side* sides;
    i32 side_count;
    i64 gap;
    i64 least_tucked;
    bool looks;
    Interval sought, held;
    Align best;
  };

  explicit constexpr AtSide(Meaning meaning, bool of_copies = false) : meaning_(meaning) {
    gives_place = true;
    turns = meaning.looks;
    among_copies = of_copies;
  }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  // At each side: the place that looks best, then all that hold.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override;

 protected:
  Span<const Side> sides(const Subject& subject, const Rule& rule) const;
  Interval slot_gap(const Rule& rule) const;
  // Offers a slot for every variant, parent and side.
  void add_slots(const Subject& subject, const Rule& rule, bool turn, Effect& effect) const;
  // Offers a slot at the place wished for; where it reaches under the other and a leg is in the way, at the nearest of those near.
  void add_places(
      const Subject& subject, const Pair& pair, Candidate slot, Interval gap, const Rect& wish, const Rect& near, Effect& effect) const;

  // Adds where it sits: the middle of its part of a side, and the floor to both sides that is as far from there.
  void add_seat_box(const Fit& fit, List<DoubleBox>& found) const;

 private:
  // The places of a piece that reaches under another one where their parts do not cross: those wished for, else the nearest of those near.
  const List<Rect>& tucked(const Subject& subject, const Pair& pair, const Rect& wish, const Rect& near) const;
  Interval asked_gap(const Fit& fit) const;
  void add_boxes(const Fit& fit, Side side, List<DoubleBox>& found) const;
  // Adds a place that is sought, but for where parts of the two would cross.
  static void add_free(const Fit& fit, Interval gap, const DoubleBox& box, List<DoubleBox>& found);
  void add_at(const Subject& subject, const Rule& rule, const Pair& pair, f64 cost, Effect& effect) const;

  Meaning meaning_;
};

}  // namespace furnish
