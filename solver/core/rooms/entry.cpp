// What the host calls to make rooms.
#include "rooms/made.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

extern "C" {

// Returns the answer's size, bytes, in the upper half, and where it begins in the lower: where the memory's top was before the call.
EXPORT(make_room)
i64 entry_make_room(u8* type_rows, i64 type_size, u8* room_rows, i64 room_size, i32 tidy, f64 budget) {
  const Bytes answer = rooms::made_room({type_rows, type_size}, {room_rows, room_size}, tidy != 0, budget);
  return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data));
}
}
