// Decorates rooms natively, with every index checked: `native_dress ROOMS` reads what the host would send and writes what it would read.
//
// Of a room: the length of the dressing's rows (8 bytes), the rows, the length of its own rows, the rows. Written of it: the answer.
#include "native_io.hpp"

#include "dress/dress.hpp"

// Decorates the next room of a file; false at its end.
static bool dress_next(FILE* file) {
  const arena::Scope scope;
  const Bytes dressing = read_bytes(file);
  if (dressing.data == nullptr) return false;
  const Bytes answer = dress::dress_room(dressing, read_bytes(file));
  fwrite(answer.data, 1, static_cast<unsigned long>(answer.size), stdout);
  return true;
}

int main(int count, char** words) {
  FILE* file = count == 2 ? fopen(words[1], "rb") : nullptr;
  if (file == nullptr) return 2;
  while (dress_next(file)) continue;
  return fclose(file);
}
