#include "placement/gaps.hpp"

namespace placement {

// How long two sides face each other before the gap between them is one.
constexpr i64 SHARED_MM = 150;

static bool overlap(const Box& a, const Box& b) {
  return a.low[0] < b.high[0] && b.low[0] < a.high[0] && a.low[1] < b.high[1] && b.low[1] < a.high[1];
}

static void add_gap(List<Gap>& found, const Span<Box>& boxes, i64 axis, i64 one, i64 two) {
  if (boxes[one].low[axis] > boxes[two].low[axis]) swap(one, two);
  const Box &a = boxes[one], &b = boxes[two];
  const i64 wide = b.low[axis] - a.high[axis], across = 1 - axis;
  const i64 start = most(a.low[across], b.low[across]), end = least(a.high[across], b.high[across]);
  if (wide < 0 || wide >= REACH_MM || end - start < SHARED_MM) return;
  Box between;
  between.low[axis] = a.high[axis];
  between.high[axis] = b.low[axis];
  between.low[across] = start;
  between.high[across] = end;
  if (wide > 0) {
    for (const Box& box : boxes) {
      if (overlap(box, between)) return;
    }
  }
  found.add({axis, one, two, wide, TOUCHING_MM});
}

List<Gap> gaps_between(const Span<Box>& boxes, i32 bodies) {
  List<Gap> found;
  for (i32 low = 0; low < bodies; low++) {
    for (i32 high = low + 1; high < boxes.size; high++) {
      for (i64 axis = 0; axis < 2; axis++) add_gap(found, boxes, axis, low, high);
    }
  }
  return found;
}

i64 count_slivers(const List<Gap>& gaps) {
  i64 count = 0;
  for (const Gap& gap : gaps) count += gap.is_sliver();
  return count;
}

Span<u8> touching(const List<Gap>& gaps, i32 boxes, i64 axis, i64 body, i64 other) {
  const Span<u8> reached = zeroes<u8>(boxes);
  const Span<i64> ahead = reserved<i64>(boxes);
  i32 count = 0;
  reached[body] = 1;
  ahead[count++] = body;
  while (count > 0) {
    const i64 at = ahead[--count];
    for (const Gap& gap : gaps) {
      if (gap.axis != axis || gap.wide >= TOUCHING_MM || (gap.low != at && gap.high != at)) continue;
      const i64 beyond = gap.low == at ? gap.high : gap.low;
      if (beyond == other || reached[beyond]) continue;
      reached[beyond] = 1;
      ahead[count++] = beyond;
    }
  }
  return reached;
}

}  // namespace placement
