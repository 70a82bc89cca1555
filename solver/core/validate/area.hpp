// Areas in square steps: a town's are more than 64 bits hold.
#pragma once

#include "plain/numbers.hpp"

namespace validate {

struct Area {
  u64 high = 0;
  u64 low = 0;

  void add(const Area& other) {
    low += other.low;
    high += other.high + (low < other.low);
  }
  // Adds the product of two lengths, none below 0.
  void add_product(i64 a, i64 b) {
    constexpr u64 HALF = 0xFFFFFFFFULL;
    const u64 x = static_cast<u64>(a), y = static_cast<u64>(b);
    const u64 ll = (x & HALF) * (y & HALF), lh = (x & HALF) * (y >> 32), hl = (x >> 32) * (y & HALF), hh = (x >> 32) * (y >> 32);
    const u64 middle = (ll >> 32) + (lh & HALF) + (hl & HALF);
    add({hh + (lh >> 32) + (hl >> 32) + (middle >> 32), middle << 32 | (ll & HALF)});
  }
};

}  // namespace validate
