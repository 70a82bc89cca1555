// Furniture and small things as JSON text, from the rows that were told of them (BODY of solver/body_rows.py). What a record's keys are and
// what bodies that look alike have in common comes from Python (solver/exchange/scene_text.py): text with gaps.
#pragma once

#include "plain/tables.hpp"
#include "plain/told_body.hpp"

namespace text {

// What fills a gap: ids as texts, null where there is none; metres; degrees; a wall's name or null; a text of the request.
enum class Gap : i64 { id = 0, on = 1, under = 2, wall = 3, x = 4, y = 5, z = 6, rotation = 7, colour = 8, none = 9 };

// Text up to a gap, and what fills that.
struct Piece {
  i64 size;
  Gap gap;
};

// Bodies that look alike: their text, and its pieces; how far the text goes on after `id`'s beginning with their name.
struct LookRow {
  i64 pieces, size, name_size;
};

// `carriers` of -1: they are carried by the bodies of the sort before.
struct BodiesRow {
  i32 bodies, carriers;
  i64 room;  // a text: the room's id, with which the ids of all of them begin
};

struct TextsRow {
  i32 looks, texts, sorts, bodies;
};

// TextsRow; the sizes of texts, and all of them as one; of each look LookRow, pieces, text, name; the look of every body, then the colour,
// a text, of each; of each sort BodiesRow, rows, the texts that are the ids of carriers -> the length of each sort's text, 8 bytes each;
// then the texts, lists of records.
Bytes bodies_text(Bytes rows);

}  // namespace text
