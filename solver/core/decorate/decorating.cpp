#include "decorate/decorating.hpp"

namespace decorate {

static void check_row(const Decorating& known, const Row& row) {
  part_of(known.choices, row.choices);
  part_of(known.words, row.rooms);
  part_of(known.words, row.not_in);
}

static void check_decorating(const Decorating& known) {
  check(known.turns.size == DEGREES && known.indoor_entry < known.entries.size);
  for (const Choice& choice : known.choices) {
    check(choice.kind >= 0 && choice.kind < known.kinds.size && choice.sizes.count > 0);
    part_of(known.sizes, choice.sizes);
  }
  for (const Kind& kind : known.kinds) {
    check(kind.colours > 0);
    known.surfaces_of(kind.surfaces);
  }
  for (const Lies& row : known.lies) {
    check_row(known, row.row);
    part_of(known.places, row.at);
    part_of(known.words, row.surface);
    part_of(known.words, row.on);
  }
  for (const Hangs& row : known.hangs) {
    check_row(known, row.row);
    part_of(known.shares, row.at);
  }
  for (const Stands& row : known.stands) {
    check_row(known, row.row);
    part_of(known.words, row.of);
  }
  for (const Entry& entry : known.entries) {
    part_of(known.lies, entry.lies);
    part_of(known.hangs, entry.hangs);
    part_of(known.stands, entry.stands);
    part_of(known.lies, entry.holds);
  }
}

Decorating read_decorating(Bytes rows) {
  Reader reader(rows.data, rows.size);
  const DecoratingHeader& header = reader.take<DecoratingHeader>(1)[0];
  Decorating known{};
  known.entries = reader.take<Entry>(header.entries);
  known.lies = reader.take<Lies>(header.lies);
  known.hangs = reader.take<Hangs>(header.hangs);
  known.stands = reader.take<Stands>(header.stands);
  known.choices = reader.take<Choice>(header.choices);
  known.sizes = reader.take<Size>(header.sizes);
  known.kinds = reader.take<Kind>(header.kinds);
  known.surfaces = reader.take<Surface>(header.surfaces);
  known.words = reader.take<i32>(header.words);
  known.places = reader.take<Share>(header.places);
  known.shares = reader.take<f64>(header.shares);
  known.turns = reader.take<Turn>(header.turns);
  known.indoor_entry = header.indoor_entry;
  known.seat_word = header.seat_word;
  check_decorating(known);
  return known;
}

}  // namespace decorate
