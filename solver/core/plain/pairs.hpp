// Two floats that are calculated with at once, each as if alone.
#pragma once

#include "spans.hpp"

using Pair = f64 __attribute__((vector_size(16), aligned(8), may_alias));

inline Pair least_of(Pair a, Pair b) { return b < a ? b : a; }

// Those at an even place of a row and right behind it.
inline Pair& pair_at(const Span<f64>& row, i32 at) {
  check_index(at + 1, row.size);
  return *reinterpret_cast<Pair*>(row.data + at);
}
