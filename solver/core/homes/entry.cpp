// What the host calls of this stage.
#include "homes/search.hpp"

extern "C" __attribute__((export_name("find_home"))) i64 entry_find_home(u8* request, i64 size) {
  return told(homes::search({request, size}));
}
