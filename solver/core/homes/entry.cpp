// What the host calls of this stage.
#include "homes/search.hpp"

// Returns the answer's size, bytes, in the upper half, and where it begins in the lower.
extern "C" __attribute__((export_name("find_home"))) i64 entry_find_home(u8* request, i64 size) {
  const Bytes answer = homes::search({request, size});
  return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data));
}
