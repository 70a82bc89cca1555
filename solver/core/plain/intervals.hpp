// What intervals leave free.
#pragma once

#include "lists.hpp"
#include "rects.hpp"

// What intervals leave free of a whole interval, from its low end up; they are sorted.
inline List<Interval> gaps_between(Interval whole, Span<Interval> blocked) {
  stable_sort(blocked, begins_before);
  List<Interval> free;
  i64 at = whole.low;
  for (const Interval& one : blocked) {
    const i64 end = least(one.low, whole.high);
    if (one.low > at && at < end) free.add({at, end});
    at = most(at, one.high);
  }
  if (at < whole.high) free.add({at, whole.high});
  return free;
}
