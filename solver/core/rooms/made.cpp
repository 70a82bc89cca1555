#include "rooms/made.hpp"

#include "furnish/furnisher.hpp"

namespace rooms {

using placement::PlacedRow;

constexpr placement::RoomLimits LIMITS = {3000, 2000, 16, 50, 2, 8, 24000};

static WantingRoom read(Bytes type_rows, Bytes room_rows) {
  WantingRoom room;
  room.type = furnish::read_room_type(type_rows.data, type_rows.size);
  furnish::RoomHeader header;
  Reader reader(room_rows.data, room_rows.size);
  room.scope = furnish::read_room(reader, header);
  room.header = reader.take<PlaceHeader>(1)[0];
  if (room.header.doorways < 0 || room.header.doorways > 1 << 16) fail(Failure::bad_request);
  room.doorways = reader.take<Doorway>(static_cast<i32>(room.header.doorways));
  for (const Doorway& one : room.doorways) {
    if (static_cast<i32>(one.wall) < 0 || static_cast<i32>(one.wall) > 3) fail(Failure::bad_request);
  }
  room.wanted = furnish::wanted_in(room.type, header, room.scope).rows;
  return room;
}

// The number of a wanted piece among those that stand, -1 where it does not.
static i32 standing(Span<PlacedRow> placed, i64 piece) {
  for (i32 i = 0; i < placed.size; i++) {
    if (placed[i].piece == piece) return i;
  }
  return -1;
}

// The pieces that stand as bodies.
static List<ToldBody> bodies_of(const WantingRoom& room, Span<PlacedRow> placed) {
  List<ToldBody> bodies;
  const auto name_of = [&](const ToldBody& body) { return room.type.kinds[body.kind].name; };
  for (const PlacedRow& one : placed) {
    const furnish::Candidate& way = room.wanted.candidates[one.candidate];
    i64 size[3];
    room.size_of(way, size);
    ToldBody body = {};
    body.kind = way.kind;
    body.on = way.is_on ? standing(placed, way.parent) : -1;
    body.under = way.is_under ? standing(placed, way.parent) : -1;
    body.wall = static_cast<i32>(one.wall);
    body.rotation = static_cast<i32>(one.rotation);
    body.number = 1;
    for (const ToldBody& other : bodies) body.number += name_of(other) == name_of(body);
    body.rect = one.footprint;
    body.low = way.bottom;
    body.width = size[0], body.depth = size[1], body.height = size[2];
    bodies.add(body);
  }
  return bodies;
}

static Bytes written(const WantingRoom& room, const placement::Making& making) {
  List<NameRow> names;
  for (const furnish::PieceRow& piece : room.wanted.pieces) names.add({piece.spec, piece.number, piece.floor_side});
  List<furnish::Candidate> ways;
  for (const PlacedRow& row : making.placed()) ways.add(room.wanted.candidates[row.candidate]);
  const List<ToldBody> bodies = bodies_of(room, making.placed());
  i64 count = names.size();
  Writer writer(making.size() + 8 + bytes_of(names.all()) + bytes_of(ways.all()) + bytes_of(bodies.all()));
  making.put(writer);
  writer.put(Span<i64>{&count, 1});
  writer.put(names.all());
  writer.put(ways.all());
  writer.put(bodies.all());
  return writer.written();
}

Bytes made_room(Bytes type_rows, Bytes room_rows, bool tidy, f64 budget) {
  const arena::Mark mark = arena::mark();
  const WantingRoom room = read(type_rows, room_rows);
  placement::Making making(asked_room(room), room.doorways, {LIMITS, budget, true, true, tidy});
  making.make();
  return moved_down(mark, written(room, making));
}

}  // namespace rooms
