// `in_row`: continues a row at either end of another piece, or round the corner from it.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

// The depths of the ways the others may stand, each once, the least first.
static List<i64> depths_of(const Subject& subject, const Rule& rule) {
  List<i64> all;
  for (const Parent& parent : subject.parents(rule)) all.add(subject.type.kinds[parent.kind].depth);
  stable_sort(all.all(), [](i64 a, i64 b) { return a < b; });
  List<i64> found;
  for (i64 depth : all) {
    if (found.size() == 0 || found[found.size() - 1] != depth) found.add(depth);
  }
  return found;
}

class InRow : public AtSide {
 public:
  constexpr InRow() : AtSide({SIDES, 2, 0, 0, false, {0, 0}, {0, 20}, Align::none}, true) { turns = at_walls = true; }

  // Offers the slots at both ends, or the places next to each corner that leave room for the row's depth.
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override {
    if (rule.wall != Walls::adjacent) return add_slots(subject, rule, false, effect);
    const i32 piece = subject.first(rule);
    if (piece < 0) return;
    add_asking(effect, rule, piece, Walls::adjacent).near = rule.weight;
    const List<i64> depths = depths_of(subject, rule);
    for (const Variant& variant : subject.variants) {
      for (Wall wall : WALLS) {
        const Interval along = subject.scope.clear.along(wall);
        for (i64 depth : depths) {
          const i64 start = subject.scope.gap + depth + floor_div(subject.type.kinds[variant.kind].width, 2);
          effect.positions.add({wall, variant.kind, along.low + start});
          effect.positions.add({wall, variant.kind, along.high - start});
        }
      }
    }
  }

  // At either end, turned alike, backs in line, always; round a corner no box says where.
  void boxes(const Fit& fit, List<DoubleBox>& found) const override {
    if (fit.turn || fit.asked.rule.wall == Walls::adjacent) return;
    Rule rule = fit.asked.rule;
    rule.align = Align::back;
    const Asked asked{rule, fit.asked.sides, fit.asked.of, fit.asked.tolerance};
    AtSide::boxes({asked, fit.parent, fit.own, fit.turn, fit.height, fit.levels, fit.parent_parts, fit.parts, {}}, found);
  }

  // It continues the row; round a corner it is enough to be close.
  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override {
    constexpr f64 ROUND_CORNER_MM = 100.0;
    if (fit.asked.rule.wall == Walls::adjacent) return own.rect.distance_to(other.rect) <= ROUND_CORNER_MM;
    return AtSide::holds_with(fit, own, other);
  }

 private:
  static constexpr Side SIDES[] = {Side::left, Side::right};
};

}  // namespace furnish
