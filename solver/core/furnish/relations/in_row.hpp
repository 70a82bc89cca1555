// `in_row`: continues a row at either end of another piece, or round the corner from it.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

class InRow : public AtSide {
 public:
  constexpr InRow() : AtSide({SIDES, 2, 0, 0, false}) {}
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;

 private:
  static constexpr Side SIDES[] = {Side::left, Side::right};
};

}  // namespace furnish
