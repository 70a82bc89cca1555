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

static void copy(const Program& program, const Span<f64> (&from)[2], const Span<f64> (&to)[2]) {
  for (i32 v = 0; v < program.width; v += 2) {
    pair_at(to[0], v) = pair_at(from[0], v);
    pair_at(to[1], v) = pair_at(from[1], v);
  }
}

void propagate(Program& program, i32 count) {
  const Span<f64> own[] = {program.least, program.most}, swept[] = {program.swept_least, program.swept_most};
  const i32 first = 2 * program.size, fixed_end = first + program.fixed_rows, end = first + count;
  if (program.swept == Swept::NOT_YET) {
    copy(program, {program.low, program.high}, own);
    program.swept = sweep(program, first, fixed_end) ? Swept::CHANGED : Swept::SAME;
    copy(program, own, swept);
  } else {
    copy(program, swept, own);
  }
  const bool changed = sweep(program, fixed_end, end);
  // More than two sweeps sharpen the bounds for more than that saves (measured).
  if (changed || program.swept == Swept::CHANGED) sweep(program, first, end);
}

}  // namespace placement
