// What the host calls of this stage.
#include "validate/validate.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

using namespace validate;

extern "C" {

EXPORT(judge_storey) i64 entry_judge_storey(u8* rows, i64 size, u8* asked, i64 asked_size, i64 most, i64 most_looks) {
  return told(judge_storey({rows, size}, {asked, asked_size}, most, most_looks));
}
EXPORT(free_floors) i64 entry_free_floors(u8* rows, i64 size) { return told(free_floors({rows, size})); }
EXPORT(measure_storey) i64 entry_measure_storey(u8* rows, i64 size) { return told(measure_storey({rows, size})); }
}
