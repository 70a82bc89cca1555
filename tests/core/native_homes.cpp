// Finds homes natively, with every index checked: `native_homes HOMES` reads what the host would send and writes what it would read.
//
// Of a home: the length of its rows (8 bytes), and these. Written of it: the answer.
#include "native_io.hpp"

#include "homes/search.hpp"

// Finds the next home of a file; false at its end.
static bool find_next(FILE* file) {
  const arena::Scope scope;
  const Bytes rows = read_bytes(file);
  if (rows.data == nullptr) return false;
  const Bytes answer = homes::search(rows);
  fwrite(answer.data, 1, static_cast<unsigned long>(answer.size), stdout);
  return true;
}

int main(int count, char** words) {
  FILE* file = count == 2 ? fopen(words[1], "rb") : nullptr;
  if (file == nullptr) return 2;
  while (find_next(file)) continue;
  return fclose(file);
}
