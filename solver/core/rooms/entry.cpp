// What the host calls to make rooms.
#include "rooms/made.hpp"

// Makes rooms one after the other, each of one of the types by its number; the answer of each takes the place of its rows. Each may cost so
// much work, all of them together `left`.
extern "C" __attribute__((export_name("make_rooms"))) void entry_make_rooms(
    SentBytes* types, i32* numbers, SentBytes* rooms, i32 count, i32 tidy, f64 each, f64 left) {
  for (i32 i = 0; i < count; i++) {
    const Bytes answer = rooms::made_room(types[numbers[i]].bytes(), rooms[i].bytes(), tidy != 0, least(each, most(left, 0.0)));
    left -= reinterpret_cast<const placement::MadeRoom*>(answer.data)->spent;
    rooms[i] = {reinterpret_cast<u64>(answer.data), answer.size};
  }
}
