// What the host calls of this stage.
#include "text/bodies.hpp"

// Returns the answer's size, bytes, in the upper half, and where it begins in the lower.
extern "C" __attribute__((export_name("bodies_text"))) i64 entry_bodies_text(u8* rows, i64 size) {
  const Bytes answer = text::bodies_text({rows, size});
  return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data));
}
