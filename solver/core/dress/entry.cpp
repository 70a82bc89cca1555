// What the host calls of this stage.
#include "dress/dress.hpp"

using namespace dress;

// Returns the answer's size, bytes, in the upper half, and where it begins in the lower.
extern "C" __attribute__((export_name("dress"))) i64 entry_dress(u8* dressing_rows, i64 dressing_size, u8* room_rows, i64 room_size) {
  const Bytes answer = dress_room({dressing_rows, dressing_size}, {room_rows, room_size});
  return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data));
}
