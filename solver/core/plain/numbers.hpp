// The core's numbers: three types, and what Python does with them where C++ would do something else.
#pragma once

using i32 = int;
using i64 = long long;
using u8 = unsigned char;
using u64 = unsigned long long;
using f64 = double;

static_assert(sizeof(i32) == 4 && sizeof(i64) == 8 && sizeof(f64) == 8);

constexpr f64 INFINITE = __builtin_inf();

template <class T> constexpr T least(T a, T b) { return b < a ? b : a; }
template <class T> constexpr T most(T a, T b) { return b > a ? b : a; }
template <class T> constexpr T between(T value, T low, T high) { return least(most(value, low), high); }

template <class T> void swap(T& a, T& b) {
  T kept = a;
  a = b;
  b = kept;
}

// Division that rounds down, as Python's // and % do.
constexpr i64 floor_div(i64 a, i64 b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }
constexpr i64 floor_mod(i64 a, i64 b) { return a - floor_div(a, b) * b; }

inline f64 floor(f64 x) { return __builtin_floor(x); }
inline f64 root(f64 x) { return __builtin_sqrt(x); }
inline f64 absolute(f64 x) { return __builtin_fabs(x); }

// A float without its fraction. What no i64 holds becomes the nearest one that does, and no number becomes 0: the same on every machine,
// and what WebAssembly's own instruction does.
inline i64 whole(f64 x) {
#ifdef __wasm__
  return __builtin_wasm_trunc_saturate_s_i64_f64(x);
#else
  constexpr f64 END = 9223372036854775808.0;
  if (x != x) return 0;
  if (x >= END) return 9223372036854775807LL;
  if (x < -END) return -9223372036854775807LL - 1;
  return static_cast<i64>(x);
#endif
}

constexpr i64 magnitude(i64 a) { return a < 0 ? -a : a; }
