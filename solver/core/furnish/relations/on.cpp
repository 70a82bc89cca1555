#include "furnish/relations/on.hpp"

#include "furnish/relations/at_side.hpp"

namespace furnish {

// The first surface of a kind that has room above it, by its place among them, or -1.
static i32 surface_for(Span<Level> levels, i64 height) {
  for (i32 i = 0; i < levels.size; i++) {
    if (levels[i].clearance < 0 || levels[i].clearance >= height) return i;
  }
  return -1;
}

// Offers the first surface of every parent that has room above it.
void On::effect(const Subject& subject, const Rule& rule, Effect& effect) const {
  for (const Variant& variant : subject.variants) {
    const Kind& kind = subject.type.kinds[variant.kind];
    for (const Parent& parent : subject.parents(rule)) {
      const Kind& other = subject.type.kinds[parent.kind];
      const Span<Level> levels = subject.type.levels_of(other);
      const i32 level = surface_for(levels, kind.height);
      if (level < 0 || kind.width > other.width) continue;
      const i64 slide = rule.align == Align::any ? floor_div(other.width - kind.width, 2) : 0;
      const bool edge = rule.align == Align::back || rule.align == Align::front;
      Candidate& slot = effect.slots.add(free_candidate(variant.kind, variant.cost));
      slot.parent = parent.piece;
      slot.parent_kind = parent.kind;
      slot.slot = Slot::level;
      slot.slot_number = level;
      slot.across = {-slide, slide};
      slot.along = rounded(lined_up(other.depth, kind.depth, edge ? rule.align : Align::centre));
      slot.is_on = 1;
      slot.bottom = levels[level].height;
    }
  }
}

}  // namespace furnish
