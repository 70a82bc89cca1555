// A room's bytes -> the room; bodies as integers.
#include "validate/room.hpp"

namespace validate {

// The extents of a footprint along x and z; of one turned by another angle, of the rectangle around it, to the micrometre.
static Extent extents(const BodyRow& row) {
  const i64 width = exact(row.width), depth = exact(row.depth);
  if (row.turn == Turn::along) return {width, depth};
  if (row.turn == Turn::crosswise) return {depth, width};
  const f64 wide = static_cast<f64>(width), deep = static_cast<f64>(depth);
  const f64 x = wide * row.cosine_size + deep * row.sine_size, z = wide * row.sine_size + deep * row.cosine_size;
  return {MICROMETRE * rounded(x / 4.0), MICROMETRE * rounded(z / 4.0)};
}

static Body body_of(const BodyRow& row) {
  const Extent extent = extents(row);
  Body body{&row, {}, exact(row.x), exact(row.y), exact(row.z), 0, false};
  const i64 wide = floor_div(extent.x, 2), deep = floor_div(extent.z, 2);
  body.box = {body.x - wide, body.z - deep, body.x + wide, body.z + deep};
  body.high = body.y + exact(row.height);
  body.is_solid = !body.rests() && body.high - body.y > FLAT;
  return body;
}

Room read_room(Reader& reader) {
  const RoomRow& sent = reader.take<RoomRow>(1)[0];
  Room room{};
  room.half_wall = sent.half_wall;
  room.bounds = sent.bounds;
  room.names = sent.names;
  room.inside = reader.take<Rect>(sent.inside);
  room.missing = reader.take<Rect>(sent.missing);
  room.edges = reader.take<Edge>(sent.edges);
  room.ways = reader.take<Edge>(sent.ways);
  room.doors = reader.take<Zone>(sent.doors);
  room.windows = reader.take<Zone>(sent.windows);
  room.kinds = reader.take<Kind>(sent.kinds);
  room.surfaces = reader.take<Surface>(sent.surfaces);
  room.parts = reader.take<UnitBox>(sent.parts);
  const Span<BodyRow> rows = reader.take<BodyRow>(sent.bodies);
  room.bodies = reserved<Body>(rows.size);
  for (const Kind& kind : room.kinds) {
    const bool fits = kind.first_surface >= 0 && kind.surfaces >= 0 && kind.first_surface + kind.surfaces <= sent.surfaces &&
                      kind.first_part >= 0 && kind.parts >= 0 && kind.first_part + kind.parts <= sent.parts;
    if (!fits) fail(Failure::bad_request);
  }
  for (i32 i = 0; i < rows.size; i++) {
    const BodyRow& row = rows[i];
    const bool fits = row.kind >= 0 && row.kind < sent.kinds && row.name >= 0 && row.name < sent.names && row.on < sent.names;
    if (!fits) fail(Failure::bad_request);
    room.bodies[i] = body_of(row);
  }
  return room;
}

}  // namespace validate
