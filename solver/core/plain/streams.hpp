// A stream of random numbers: SplitMix64 (Steele, Lea, Flood, OOPSLA 2014), the same integers as solver/streams.py draws.
#pragma once

#include "spans.hpp"

class Stream {
 public:
  explicit Stream(u64 state) : state_(state) {}

  u64 state() const { return state_; }

  u64 bits() {
    state_ += 0x9E3779B97F4A7C15ULL;
    u64 z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  // In [0, 1).
  f64 unit() { return unit(bits()); }
  static f64 unit(u64 drawn) { return static_cast<f64>(drawn >> 11) * 0x1p-53; }

  // In [0, most).
  f64 up_to(f64 most) { return 0.0 + most * unit(); }

  // In [0, n): the upper half of the 128 bits of the product with n.
  i32 below(i32 n) { return below(bits(), n); }
  static i32 below(u64 drawn, i32 n) {
    const u64 times = static_cast<u64>(n);
    const u64 low = (drawn & 0xFFFFFFFFULL) * times;
    return static_cast<i32>(((drawn >> 32) * times + (low >> 32)) >> 32);
  }

  // Whether unit() is less than a probability, which scales exactly.
  bool chance(f64 probability) { return chance(bits(), probability); }
  static constexpr bool chance(u64 drawn, f64 probability) {
    const f64 scaled = probability * 0x1p53;
    const i64 below = static_cast<i64>(scaled);
    return static_cast<i64>(drawn >> 11) < below + (static_cast<f64>(below) < scaled);
  }

  template <class T> T& pick(Span<T> options) {
    if (options.size < 1) fail(Failure::bad_request);
    return options[below(options.size)];
  }

  template <class T> void shuffle(Span<T> items) {
    for (i32 i = items.size - 1; i > 0; i--) swap(items[i], items[below(i + 1)]);
  }

 private:
  u64 state_;
};
