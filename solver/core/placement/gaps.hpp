// Gaps between boxes on a room's floor, whole millimetres.
#pragma once

#include "plain/lists.hpp"
#include "plain/slivers.hpp"

namespace placement {

// From here on a hand and a broom come in.
constexpr i64 REACH_MM = 300;

struct Box {
  i64 low[2], high[2];
};

// Free floor between two boxes along an axis; `low` and `high` are numbers of the boxes at its ends, `contact` what is no gap yet.
struct Gap {
  i64 axis, low, high, wide, contact;

  bool is_sliver() const { return contact <= wide && wide < SLIVER_MM; }
};

// The gaps narrower than REACH_MM beside the first `bodies` boxes, those in which nothing else stands.
List<Gap> gaps_between(const Span<Box>& boxes, i32 bodies);

i64 count_slivers(const List<Gap>& gaps);

// A body and what it touches along an axis, directly or through others, but for what is on the gap's other side: true for each box.
Span<u8> touching(const List<Gap>& gaps, i32 boxes, i64 axis, i64 body, i64 other);

}  // namespace placement
