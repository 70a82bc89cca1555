// Makes rooms natively, with every index checked: `native_rooms ROOMS` reads what the host would send and writes what it would read.
//
// Of a room: the length of its type's rows (8 bytes), the rows, the length of its own rows, the rows. Written of it: the answer.
#include "native_io.hpp"

#include "rooms/made.hpp"

// Makes the next room of a file; false at its end.
static bool make_next(FILE* file) {
  const arena::Scope scope;
  const Bytes type = read_bytes(file);
  if (type.data == nullptr) return false;
  const Bytes answer = rooms::made_room(type, read_bytes(file), true, 400'000);
  fwrite(answer.data, 1, static_cast<unsigned long>(answer.size), stdout);
  return true;
}

int main(int count, char** words) {
  FILE* file = count == 2 ? fopen(words[1], "rb") : nullptr;
  if (file == nullptr) return 2;
  while (make_next(file)) continue;
  return fclose(file);
}
