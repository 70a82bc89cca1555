#include "homes/drafts.hpp"

namespace homes {

void Chunk::insert(i32 at, Column column) {
  add(column);
  for (i32 i = size - 1; i > at; i--) swap(columns[i], columns[i - 1]);
}

Chunk Chunk::part(i32 from, i32 to) const {
  Chunk found;
  for (i32 i = from; i < to; i++) found.add(columns[i]);
  return found;
}

Chunk Chunk::reversed() const {
  Chunk found = *this;
  found.reverse();
  return found;
}

Rect Block::placed(Rect box) const {
  if (mirrored) {
    const i64 west = along() - box.x1;
    box.x1 = along() - box.x0;
    box.x0 = west;
  }
  const Rect lying = turned ? Rect{box.z0, box.x0, box.z1, box.x1} : box;
  return lying.moved(rect.x0, rect.z0);
}

i32 Draft::first(i32 strip) const {
  check_index(strip, strips);
  i32 first = 0;
  for (i32 k = 0; k < strip; k++) first += count[k];
  return first;
}

void Draft::add_strip(Span<const Column> added, i64 deep) {
  if (strips >= MOST_STRIPS || columns + added.size > MOST_ROOMS) fail(Failure::bad_request);
  for (i32 i = 0; i < added.size; i++) column[columns++] = added.data[i];
  count[strips] = static_cast<u8>(added.size);
  depth[strips++] = deep;
}

void Draft::insert(i32 strip, i32 at, Column added) {
  if (columns >= MOST_ROOMS) fail(Failure::bad_request);
  const i32 place = first(strip) + at;
  for (i32 i = columns++; i > place; i--) column[i] = column[i - 1];
  column[place] = added;
  count[strip]++;
}

Column Draft::take(i32 strip, i32 at) {
  check_index(at, count[strip]);
  const i32 place = first(strip) + at;
  const Column taken = column[place];
  columns--;
  for (i32 i = place; i < columns; i++) column[i] = column[i + 1];
  count[strip]--;
  return taken;
}

void Draft::turn_round(i32 strip) {
  const i32 from = first(strip);
  for (i32 i = from, j = from + count[strip] - 1; i < j; i++, j--) swap(column[i], column[j]);
}

void Draft::copy_to(Draft& other) const {
  other.kind = kind;
  other.bend = bend;
  other.turn = turn;
  other.entry = entry;
  other.apart = apart;
  other.strips = strips;
  other.columns = columns;
  other.blocks = blocks;
  for (i32 i = 0; i < columns; i++) other.column[i] = column[i];
  for (i32 k = 0; k < strips; k++) {
    other.count[k] = count[k];
    other.depth[k] = depth[k];
  }
}

void Sheet::begin(i32 count) {
  rooms = count;
  hallways = 0;
  width = depth = 0;
  for (i32 i = 0; i < count; i++) boxes[i] = {0, 0, 0, 0};
}

}  // namespace homes
