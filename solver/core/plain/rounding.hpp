// Rounding as Python's round() does it: exactly, and a half to the even neighbour.
#pragma once

#include "numbers.hpp"

// Half of a whole number, rounded to the nearest whole number.
constexpr i64 rounded_half(i64 doubled) {
  const i64 low = floor_div(doubled, 2);
  return doubled % 2 == 0 || low % 2 == 0 ? low : low + 1;
}

// The nearest whole number, as Python's round(x).
inline i64 rounded(f64 x) {
  const f64 low = floor(x), beyond_half = (x - low) - 0.5;
  return whole(low) + (beyond_half > 0 || (beyond_half == 0 && whole(low) % 2 != 0));
}

// The least whole number that is no less.
inline i64 rounded_up(f64 x) { return whole(-floor(-x)); }

// The product of two floats as a sum of two, exact (Dekker); for magnitudes far from the ends of what a float holds.
struct Product {
  f64 high;
  f64 low;
};

inline Product exact_product(f64 a, f64 b) {
  constexpr f64 SPLITTER = 134217729.0;
  const f64 wide_a = SPLITTER * a, wide_b = SPLITTER * b;
  const f64 a_high = wide_a - (wide_a - a), b_high = wide_b - (wide_b - b);
  const f64 a_low = a - a_high, b_low = b - b_high;
  const f64 high = a * b;
  return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

// The float nearest to a number's decimal with as many places as SCALE has zeros, as Python's round(); NO_PLACES_LEFT or more has none.
template <i64 SCALE, i64 NO_PLACES_LEFT> inline f64 rounded_decimal(f64 x) {
  const f64 size = absolute(x);
  if (!(size < NO_PLACES_LEFT)) return x;
  const Product product = exact_product(size, SCALE);
  const f64 low = floor(product.high);
  const f64 beyond_half = (product.high - low) - 0.5;
  const bool up = beyond_half > -product.low || (beyond_half == -product.low && whole(low) % 2 != 0);
  const f64 rounded = (up ? low + 1.0 : low) / SCALE;
  return x < 0 ? -rounded : rounded;
}

inline f64 rounded_6(f64 x) { return rounded_decimal<1'000'000, 4'294'967'296>(x); }
inline f64 rounded_9(f64 x) { return rounded_decimal<1'000'000'000, 8'388'608>(x); }
