#include "memory.hpp"

static i32 failure_code = 0;

#ifdef __wasm__
extern "C" {
extern u8 __heap_base;

void* memset(void* to, int value, unsigned long count) { return __builtin_memset(to, value, count); }
void* memcpy(void* to, const void* from, unsigned long count) { return __builtin_memcpy(to, from, count); }
void* memmove(void* to, const void* from, unsigned long count) { return __builtin_memmove(to, from, count); }
}

#endif

[[noreturn]] void fail(Failure failure) {
  failure_code = static_cast<i32>(failure);
  __builtin_trap();
}

namespace arena {

State state;

#ifdef __wasm__
constexpr i64 PAGE = 65536;

static u64 base() { return (reinterpret_cast<u64>(&__heap_base) + 15) / 16 * 16; }

// Makes the memory reach to an address; false where there is no more.
static bool grow_to(u64 end) {
  if (end <= state.size) return true;
  state.size = __builtin_wasm_memory_size(0) * PAGE;
  const u64 pages = end > state.size ? (end - state.size + PAGE - 1) / PAGE : 0;
  if (pages > 65536 || (pages > 0 && __builtin_wasm_memory_grow(0, pages) == static_cast<unsigned long>(-1))) return false;
  state.size += pages * PAGE;
  return true;
}
#else
alignas(16) static u8 space[1 << 30];

static u64 base() { return reinterpret_cast<u64>(space); }

static bool grow_to(u64 end) { return end <= base() + sizeof(space); }
#endif

void* reserve(i64 bytes) {
  if (bytes < 0) fail(Failure::memory_full);
  const u64 at = base() + state.top;
  const u64 end = at + (static_cast<u64>(bytes) + 15) / 16 * 16;
  if (!grow_to(end)) fail(Failure::memory_full);
  state.top = end - base();
  return reinterpret_cast<void*>(at);
}

void* zeroed(i64 bytes) {
  void* at = reserve(bytes);
  __builtin_memset(at, 0, static_cast<unsigned long>(bytes));
  return at;
}

}  // namespace arena

// What the host calls, whatever the stage.
extern "C" {
__attribute__((export_name("failure"))) i32 failure() { return failure_code; }
__attribute__((export_name("release"))) void arena_release(i32 mark) { arena::release(static_cast<u64>(mark)); }
__attribute__((export_name("state_at"))) i32 arena_state_at() { return static_cast<i32>(reinterpret_cast<u64>(&arena::state)); }
__attribute__((export_name("reserve"))) i32 arena_reserve(i64 bytes) {
  return static_cast<i32>(reinterpret_cast<u64>(arena::reserve(bytes)));
}
}
