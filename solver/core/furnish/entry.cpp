// What the host calls of this stage.
#include "furnish/furnish.hpp"

using namespace furnish;

// Returns the answer's size, bytes, in the upper half, and where it begins in the lower.
extern "C" __attribute__((export_name("furnish"))) i64 entry_furnish(u8* type_rows, i64 type_size, u8* room_rows, i64 room_size) {
  const Bytes answer = furnish_room({type_rows, type_size}, {room_rows, room_size});
  return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data));
}
