// `in_row`: continues a row at either end of another piece, or round the corner from it.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

class InRow : public AtSide {
 public:
  constexpr InRow() : AtSide({SIDES, 2, 0, 0, false, {0, 0}, {0, 20}, Align::none}, true) { turns = at_walls = true; }
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  void boxes(const Fit& fit, List<DoubleBox>& found) const override;
  bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const override;

 private:
  static constexpr Side SIDES[] = {Side::left, Side::right};
};

}  // namespace furnish
