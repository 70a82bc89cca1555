#include "homes/deal.hpp"

#include "plain/lists.hpp"

namespace homes {

namespace {

// How often a small wet room lies behind another one, and an own bathroom behind a small wet room next to its bedroom.
constexpr f64 PAIRED = 0.55;
// How often it else lies beside the bedroom, not behind it.
constexpr f64 BESIDE = 0.8;
// How often another small wet room is dealt to the wet end of a suite.
constexpr f64 AT_SUITE = 0.85;
constexpr i64 DEPTH_MM = 150;

// In [low, high).
f64 uniform(Stream& stream, f64 low, f64 high) { return low + (high - low) * stream.unit(); }

}  // namespace

Dealer::Dealer(Span<const PlannedRoom> rooms, Columns& columns, Stream& stream) : rooms_(rooms), columns_(columns), stream_(stream) {
  for (i32 i = 0; i < rooms.size; i++) {
    const PlannedRoom& room = rooms[i];
    if (room.entry()) entries_.add(i);
    if (room.has(GARAGE)) garages_.add(i);
    if (room.living()) public_.add(i);
    if (room.small() && !room.owned()) small_.add(i);
    if (!room.has(WAY_THROUGH) && !room.small() && !room.has(GARAGE)) others_.add(i);
  }
}

void Dealer::deal(Kind kind, Draft& draft) const {
  if (kind == Kind::rows) return rows(draft);
  if (kind == Kind::full) return full(draft);
  if (kind == Kind::ranch) return ranch(draft);
  if (kind == Kind::axial) return axial(draft);
  fail(Failure::bad_request);
}

i64 Dealer::depth(Interval depths) const {
  return depths.low + DEPTH_MM * stream_.below(static_cast<i32>((depths.high - depths.low) / DEPTH_MM + 1));
}

// In a strip that is not `shallow` nothing small stands beside the kitchen: it would be too slim. Rooms `without` are dealt elsewhere.
void Dealer::chunks(bool shallow, const RoomList& without, Deal& deal) const {
  RoomList small, baths, others;
  for (const i32 room : small_.all()) {
    if (!without.has(room)) small.add(room);
  }
  stream_.shuffle(small.all());
  for (const i32 room : small.all()) (is_bath(room) ? baths : others).add(room);
  deal.living = living_order();
  if (shallow && stream_.chance(AT_KITCHEN)) {
    const bool dry = others.size && (!baths.size || stream_.chance(0.7));
    beside_kitchen(deal.living, dry ? others : baths);
  }
  Chunk suites[MOST_ROOMS], wet;
  i32 suite_count = 0;
  deal.apart.size = 0;
  for (const i32 room : others_.all()) {
    if (own_bath(room) >= 0) {
      suites[suite_count++] = suite(room, baths, others);
    } else {
      deal.apart.add().add(Column::of(room));
    }
  }
  Chunk singles;
  while (others.size && baths.size && stream_.chance(PAIRED)) {
    const i32 bath = baths.take();
    singles.add(Column::of(bath, others.take()));
  }
  for (const i32 room : others.all()) singles.add(Column::of(room));
  for (const i32 room : baths.all()) singles.add(Column::of(room));
  for (const Column& column : singles.all()) {
    if (suite_count && stream_.chance(AT_SUITE)) {
      join(suites[stream_.below(suite_count)], column);
    } else {
      wet.add(column);
    }
  }
  for (i32 i = 0; i < suite_count; i++) deal.apart.add() = suites[i];
  if (wet.size) deal.apart.add() = wet;
  stream_.shuffle(deal.apart.chunks());
}

i32 Dealer::own_bath(i32 room) const {
  i32 found = -1;
  for (i32 i = 0; i < rooms_.size; i++) {
    if (rooms_[i].owner == room) found = i;
  }
  return found;
}

// Moves one of the rooms beside the kitchen, not between it and the dining room.
void Dealer::beside_kitchen(Chunk& living, RoomList& rooms) const {
  i32 kitchen = -1;
  for (i32 k = 0; k < living.size; k++) {
    if (is_wet(living.columns[k])) kitchen = k;
  }
  if (kitchen < 0 || !rooms.size) return;
  living.insert(kitchen == living.size - 1 ? living.size : kitchen, Column::of(rooms.take()));
}

// Adds a small wet room at the wet end of a suite.
void Dealer::join(Chunk& suite, Column column) const {
  const Column& first = suite.columns[0];
  suite.insert(rooms_[first.rooms[first.size - 1]].small() ? 0 : suite.size, column);
}

// A bedroom with its own bathroom: behind a small wet room next to it, beside it, or behind it.
Chunk Dealer::suite(i32 room, RoomList& baths, RoomList& others) const {
  const i32 bath = own_bath(room);
  RoomList& fronts = baths.size && (!others.size || stream_.chance(0.6)) ? baths : others;
  Chunk chunk;
  if (fronts.size && stream_.chance(PAIRED)) {
    chunk.add(Column::of(room));
    chunk.add(Column::of(fronts.take(), bath));
  } else if (stream_.chance(BESIDE)) {
    chunk.add(Column::of(room));
    chunk.add(Column::of(bath));
    if (fronts.size) chunk.add(Column::of(fronts.take()));
  } else {
    chunk.add(Column::of(room, bath));
  }
  return either(chunk);
}

// Living rooms at one end, the largest first, kitchens at the other or in the middle.
Chunk Dealer::living_order() const {
  RoomList living, kitchens;
  for (const i32 room : public_.all()) (rooms_[room].has(WET) ? kitchens : living).add(room);
  stable_sort(living.all(), [&](i32 a, i32 b) { return rooms_[a].size.typical > rooms_[b].size.typical; });
  const i32 at = stream_.chance(0.75) ? living.size : least(1, living.size);
  Chunk found;
  for (i32 i = 0; i < at; i++) found.add(Column::of(living.rooms[i]));
  for (const i32 room : kitchens.all()) found.add(Column::of(room));
  for (i32 i = at; i < living.size; i++) found.add(Column::of(living.rooms[i]));
  return found;
}

i64 Dealer::floor_of(Span<const Column> columns) const {
  i64 floor = 0;
  for (const Column& column : columns) floor += columns_.area(column);
  return floor;
}

void Dealer::sort(Span<Chunk> chunks) const {
  stable_sort(chunks, [&](const Chunk& a, const Chunk& b) { return floor_of(a.all()) > floor_of(b.all()); });
}

bool Dealer::fits(const Chunk& chunk, i64 depth) const {
  for (const Column& column : chunk.all()) {
    if (columns_.width(column, depth).misses) return false;
  }
  return true;
}

// Adds chunks to either end of the strip that is the shorter one, mostly.
void Dealer::fill(Chunk* strips, const i64* depths, ChunkList& chunks) const {
  sort(chunks.chunks());
  for (const Chunk& chunk : chunks.chunks()) {
    f64 lengths[2];
    bool fitting[2];
    for (i32 k = 0; k < 2; k++) lengths[k] = static_cast<f64>(length(strips[k].all(), depths[k])) * uniform(stream_, 0.9, 1.1);
    for (i32 k = 0; k < 2; k++) fitting[k] = fits(chunk, depths[k]);
    const bool any = fitting[0] || fitting[1];
    const i32 shorter = (fitting[1] || !any) && ((any && !fitting[0]) || lengths[1] < lengths[0]) ? 1 : 0;
    if (stream_.chance(0.5)) {
      Chunk whole = chunk;
      whole.add(strips[shorter]);
      strips[shorter] = whole;
    } else {
      strips[shorter].add(chunk);
    }
  }
}

Chunk Dealer::entry() const {
  Chunk found;
  if (entries_.size) found.add(Column::of(entries_.rooms[0]));
  return found;
}

// The entry as a column; in a strip for cars, and now and then elsewhere, something small lies between it and the hallway.
Chunk Dealer::front() const {
  Chunk found = entry();
  if (!found.size || !small_.size || !(garages_.size || stream_.chance(0.15))) return found;
  i32 behind = -1;
  for (const i32 room : small_.all()) {
    if (!is_bath(room)) behind = room;
  }
  if (behind < 0) behind = small_.rooms[small_.size - 1];
  found.columns[0] = Column::of(behind, entries_.rooms[0]);
  return found;
}

// The entry's column, the public rooms and the private ones, for strips along the street.
void Dealer::dealt(Deal& deal) const {
  deal.front = front();
  RoomList without;
  for (const Column& column : deal.front.all()) {
    for (i32 k = 0; k < column.size; k++) without.add(column.rooms[k]);
  }
  chunks(!garages_.size, without, deal);
}

// The entry beside the living room, or what lies behind it beside the kitchen, or between the two.
Chunk Dealer::along_street(const Chunk& front, const Chunk& living) const {
  Chunk found = front;
  if (!front.size || front.columns[0].size == 1 || stream_.chance(0.3)) {
    found.add(living);
    return found;
  }
  const i32 cut = least(stream_.below(2), living.size);
  found = living.part(0, cut);
  found.add(front);
  found.add(living.part(cut, living.size).reversed());
  return found;
}

Chunk Dealer::with_garages(const Chunk& strip) const {
  Chunk found;
  for (const i32 room : garages_.all()) found.add(Column::of(room));
  found.add(strip);
  return found;
}

}  // namespace homes
