// What the host calls of this stage.
#include "decorate/decorate.hpp"

using namespace decorate;

// Decorates rooms one after the other; the answer of each takes the place of its rows.
extern "C" __attribute__((export_name("decorate"))) void entry_decorate(u8* catalog, i64 catalog_size, SentBytes* rooms, i32 count) {
  for (i32 i = 0; i < count; i++) {
    const arena::Mark begun = arena::mark();
    const Bytes answer = moved_down(begun, decorate_room({catalog, catalog_size}, rooms[i].bytes()));
    rooms[i] = {reinterpret_cast<u64>(answer.data), answer.size};
  }
}
