// The memory of an instance: one arena that only grows; what a call took is given back at its end by setting the top back.
#pragma once

#include "numbers.hpp"

enum class Failure : i32 { none = 0, memory_full = 1, bad_request = 2, out_of_range = 3, endless = 4 };

// Ends the call: the host throws the instance away and raises an exception that names the failure.
[[noreturn]] void fail(Failure failure);

// Refuses a request in which something is not right.
inline void check(bool right) {
  if (!right) fail(Failure::bad_request);
}

namespace arena {

using Mark = u64;

// What the host reads, and moves, without a call: how many bytes are taken, and how many the memory has.
struct State {
  u64 top, size;
};

extern State state;

inline Mark mark() { return state.top; }
inline void release(Mark mark) { state.top = mark; }

// Bytes that nothing else uses, at a multiple of 16. They hold what was there: nothing yet, or what a call before left.
void* reserve(i64 bytes);

// The same, all 0.
void* zeroed(i64 bytes);

// Gives back, at the end of a block, what was reserved within it.
class Scope {
 public:
  Scope() : mark_(mark()) {}
  ~Scope() { release(mark_); }
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  Mark mark_;
};

}  // namespace arena
