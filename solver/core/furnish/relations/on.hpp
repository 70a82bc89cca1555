// `on`: on another piece's surface: in its middle, at its back or front, or (align any) anywhere along it.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

// The first surface of a kind that has room above it, by its place among them, or -1.
static i32 surface_for(Span<Level> levels, i64 height) {
  for (i32 i = 0; i < levels.size; i++) {
    if (levels[i].clearance < 0 || levels[i].clearance >= height) return i;
  }
  return -1;
}

class On : public Relation {
 public:
  constexpr On() { gives_place = true; }

  // Offers the places on every parent.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    const Asked asked{rule, {}, {}, EXACT};
    for (const Variant& variant : subject.variants) {
      const Kind& kind = subject.type.kinds[variant.kind];
      for (const Parent& parent : subject.parents(rule)) {
        const Kind& other = subject.type.kinds[parent.kind];
        const Span<Level> levels = subject.type.levels_of(other);
        List<DoubleBox> places;
        boxes({asked, other.size(), kind.size(), 0, kind.height, levels, {}, {}, {}}, places);
        for (const DoubleBox& place : places) {
          Candidate& slot = effect.slots.add(free_candidate(variant.kind, variant.cost));
          slot.parent = parent.piece;
          slot.parent_kind = parent.kind;
          slot.slot = Slot::level;
          slot.slot_number = place.level;
          slot.across = rounded(place.across);
          slot.along = rounded(place.along);
          slot.is_on = 1;
          slot.bottom = levels[static_cast<i32>(place.level)].height;
        }
      }
    }
  }

  // The first surface with room above it: in its middle, at its back or front, or anywhere along it.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    const Align align = fit.asked.rule.align;
    const i32 level = surface_for(fit.levels, fit.height);
    if (level < 0 || fit.own.x > fit.parent.x) return;
    const i64 slide = align == Align::any ? 2 * floor_div(fit.parent.x - fit.own.x, 2) : 0;
    const bool edge = align == Align::back || align == Align::front;
    found.add({{-slide, slide}, lined_up(fit.parent.z, fit.own.z, edge ? align : Align::centre), level});
  }

  // Its middle is over the other, and its underside on one of the other's surfaces.
  bool holds_with(const Fit&, const Standing& own, const Standing& other) const override {
    const i64 x = own.rect.x0 + own.rect.x1, z = own.rect.z0 + own.rect.z1;
    const Rect& at = other.rect;
    return own.rests && 2 * at.x0 <= x && x <= 2 * at.x1 && 2 * at.z0 <= z && z <= 2 * at.z1;
  }
};

}  // namespace furnish
