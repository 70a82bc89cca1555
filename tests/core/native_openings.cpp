// Opens walls natively, with every index checked: `native_openings HOUSES` reads what the host would send and writes what it would read.
//
// Of a question: the length of its rows (8 bytes), and these; all openings of a house and where else one of them could stand in turn.
// Written of it: the answer.
#include "native_io.hpp"

#include "openings/house.hpp"

// Answers the next two questions of a file; false at its end.
static bool answer_next(FILE* file) {
  Bytes (*const answers[])(Bytes) = {openings::open_walls, openings::door_places};
  for (const auto answer : answers) {
    const arena::Scope scope;
    const Bytes rows = read_bytes(file);
    if (rows.data == nullptr) return false;
    const Bytes told = answer(rows);
    fwrite(told.data, 1, static_cast<unsigned long>(told.size), stdout);
  }
  return true;
}

int main(int count, char** words) {
  FILE* file = count == 2 ? fopen(words[1], "rb") : nullptr;
  if (file == nullptr) return 2;
  while (answer_next(file)) continue;
  return fclose(file);
}
