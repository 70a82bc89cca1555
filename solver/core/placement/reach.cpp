#include "placement/reach.hpp"

#include "plain/pairs.hpp"

namespace placement {

// Narrows how far variables go by the rows from one to before another; tells whether that changed anything.
static bool sweep(const Program& program, i32 first, i32 end) {
  const i32 n = program.size;
  const Span<f64> &least = program.least, &most = program.most;
  bool changed = false;
  for (i32 r = first; r < end; r++) {
    const auto [i, j, rest] = program.rows[r];
    const f64 lowest = least[i] - rest, highest = most[j] + rest;
    const bool is_higher = least[j] < lowest - ROUNDING, is_lower = most[i] > highest + ROUNDING;
    if (!is_higher && !is_lower) continue;
    if (is_higher && j < n) {
      least[j] = lowest;
      changed = true;
    }
    if (is_lower && i < n) {
      most[i] = highest;
      changed = true;
    }
  }
  return changed;
}

void propagate(Program& program, i32 count) {
  const Span<f64> &least = program.least, &most = program.most;
  const i32 first = 2 * program.size, end = first + count;
  for (i32 v = 0; v < program.width; v += 2) {
    pair_at(least, v) = pair_at(program.low, v);
    pair_at(most, v) = pair_at(program.high, v);
  }
  // More than two sweeps sharpen the bounds for more than that saves (measured).
  if (sweep(program, first, end)) sweep(program, first, end);
}

}  // namespace placement
