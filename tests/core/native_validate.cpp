// Validates natively, with every index checked: `native_validate ROWS` reads what the host would send and writes what it would read.
//
// Of each request: which answer is asked for (8 bytes, by the order below), the length of the rows, the rows. Written of it: the answer.
#include <stdio.h>

#include "validate/validate.hpp"

using validate::Bytes;

static Bytes (*const ANSWERS[])(Bytes) = {validate::judge_room, validate::walk_storey, validate::free_floors, validate::measure_storey,
                                         validate::open_fronts};

// Answers the next request of a file; false at its end.
static bool answer_next(FILE* file) {
  const arena::Scope scope;
  i64 head[2];
  if (fread(head, sizeof head, 1, file) != 1) return false;
  u8* rows = static_cast<u8*>(arena::reserve(head[1]));
  if (static_cast<i64>(fread(rows, 1, static_cast<unsigned long>(head[1]), file)) != head[1]) fail(Failure::bad_request);
  const Bytes answer = ANSWERS[head[0]]({rows, head[1]});
  fwrite(answer.data, 1, static_cast<unsigned long>(answer.size), stdout);
  return true;
}

int main(int count, char** words) {
  FILE* file = count == 2 ? fopen(words[1], "rb") : nullptr;
  if (file == nullptr) return 2;
  while (answer_next(file)) continue;
  return fclose(file);
}
