// `around`: at one of the places around another piece, looking at it; long sides take several, filled in pairs.
#pragma once

#include "furnish/relations/at_side.hpp"

namespace furnish {

class Around : public AtSide {
 public:
  constexpr Around() : AtSide({SIDES, 4, 50, 0, true, {20, 280}, {-10'000, 300}, Align::none}) {}
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;

 private:
  struct Seat {
    Side side;
    i32 rank;
    i64 shift;
  };

  List<Seat> seats(const Subject& subject, const Rule& rule, const Kind& parent, const Kind& own) const;
  void add_seat(const Subject& subject, const Pair& pair, i64 shift, Interval gap, f64 cost, Effect& effect) const;

  static constexpr Side SIDES[] = {Side::front, Side::back, Side::left, Side::right};
};

}  // namespace furnish
