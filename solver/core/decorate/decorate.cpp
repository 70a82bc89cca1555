#include "decorate/decorate.hpp"

#include "decorate/stages.hpp"

namespace decorate {

namespace {

// The answer's beginning; the things follow.
struct AnswerHeader {
  u64 stream;
  i64 things;
};

}  // namespace

// Lays things on the pieces one by one, or on all of a word together where their rows say so.
static void lay_on_pieces(DecoratedRoom& room) {
  const Span<bool> done = zeroes<bool>(room.pieces.size);
  for (i32 k = 0; k < room.pieces.size; k++) {
    if (done[k]) continue;
    List<i64> group;
    group.add(k);
    const i32 word = room.pieces[k].word;
    const Entry* entry = room.known.entry_of(word);
    for (i32 other = k + 1; entry != nullptr && entry->together && other < room.pieces.size; other++) {
      if (room.pieces[other].word != word) continue;
      done[other] = true;
      group.add(other);
    }
    lay(room, group.all());
  }
}

// Lays things on the things: a mounted shelf is a parent like any other.
static void lay_on_things(DecoratedRoom& room) {
  for (i64 k = room.pieces.size; k < room.carriers.size(); k++) {  // grows meanwhile
    if (room.carriers[k].surfaces.size > 0) lay(room, {&k, 1});
  }
}

Bytes decorate_room(Bytes catalog_rows, Bytes room_rows) {
  const Decorating known = read_decorating(catalog_rows);
  DecoratedRoom room(known, room_rows);
  lay_on_pieces(room);
  for (i32 k = 0; k < room.pieces.size; k++) hang(room, k);
  hang_free(room);
  lay_on_things(room);
  stand(room);
  for (i32 k = 0; k < room.pieces.size; k++) fill(room, k);
  AnswerHeader header{room.stream.state(), room.things.size()};
  Writer writer(sizeof(header) + bytes_of(room.things.all()));
  writer.put(Span<AnswerHeader>{&header, 1});
  writer.put(room.things.all());
  return writer.written();
}

}  // namespace decorate
