// Answers natively, with every index checked: `native CALL FILE` reads what the host would send and writes what it would read.
//
// Of a request: of each of its parts the length (8 bytes), and the part. Written of it: the answer.
#include <string.h>

#include "decorate/decorate.hpp"
#include "furnish/furnish.hpp"
#include "homes/search.hpp"
#include "native_io.hpp"
#include "native_steps.hpp"
#include "openings/house.hpp"
#include "rooms/made.hpp"
#include "validate/validate.hpp"

constexpr i64 ANY_NUMBER = 1LL << 60;

static Bytes make_room(Bytes type, Bytes room) { return rooms::made_room(type, room, true, 400'000); }

static Bytes judge_storey(Bytes storey, Bytes asked) { return validate::judge_storey(storey, asked, ANY_NUMBER, ANY_NUMBER); }

static void tell(Bytes answer) { fwrite(answer.data, 1, static_cast<unsigned long>(answer.size), stdout); }

// Answers the next request of a file, of one part or of two; false at its end.
template <Bytes (*answer)(Bytes)> static bool next(FILE* file) {
  const arena::Scope scope;
  const Bytes rows = read_bytes(file);
  if (rows.data != nullptr) tell(answer(rows));
  return rows.data != nullptr;
}

template <Bytes (*answer)(Bytes, Bytes)> static bool next(FILE* file) {
  const arena::Scope scope;
  const Bytes known = read_bytes(file);
  if (known.data != nullptr) tell(answer(known, read_bytes(file)));
  return known.data != nullptr;
}

struct Call {
  const char* name;
  bool (*next)(FILE* file);
};

static const Call CALLS[] = {
    {"make", placement::make_next},
    {"decorate", next<decorate::decorate_room>},
    {"furnish", next<furnish::furnish_room>},
    {"make_room", next<make_room>},
    {"search_home", next<homes::search>},
    {"open_walls", next<openings::open_walls>},
    {"door_places", next<openings::door_places>},
    {"judge_storey", next<judge_storey>},
    {"free_floors", next<validate::free_floors>},
    {"measure_storey", next<validate::measure_storey>},
};

int main(int count, char** words) {
  FILE* file = count == 3 ? fopen(words[2], "rb") : nullptr;
  if (file == nullptr) return 2;
  for (const Call& call : CALLS) {
    if (strcmp(call.name, words[1]) != 0) continue;
    while (call.next(file)) continue;
    return fclose(file);
  }
  return 2;
}
