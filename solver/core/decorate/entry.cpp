// What the host calls of this stage.
#include "decorate/decorate.hpp"

using namespace decorate;

// Returns the answer's size, bytes, in the upper half, and where it begins in the lower.
extern "C" __attribute__((export_name("decorate"))) i64 entry_decorate(u8* catalog, i64 catalog_size, u8* room, i64 room_size) {
  const Bytes answer = decorate_room({catalog, catalog_size}, {room, room_size});
  return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data));
}
