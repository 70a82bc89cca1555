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

static BodyRow body_row(const ToldBody& thing, const Turned& turned, i64 kind, Sort sort) {
  constexpr f64 MM = 1000.0;
  const auto middle = [](i64 low, i64 high) { return static_cast<f64>(low + high) / (2.0 * MM); };
  const auto metres = [](i64 length) { return static_cast<f64>(length) / MM; };
  BodyRow row{};
  row.x = middle(thing.rect.x0, thing.rect.x1), row.y = metres(thing.low), row.z = middle(thing.rect.z0, thing.rect.z1);
  row.width = metres(thing.width), row.depth = metres(thing.depth), row.height = metres(thing.height);
  row.cosine = turned.cosine, row.sine = turned.sine, row.cosine_size = turned.cosine_size, row.sine_size = turned.sine_size;
  row.turn = turned.turn, row.quarters = turned.quarters, row.sort = sort;
  row.wall = thing.wall == static_cast<i32>(Wall::none) ? -1 : thing.wall;
  row.kind = kind >= 0 && kind < (1 << 30) ? static_cast<i32>(kind) : -1;
  return row;
}

// Reads bodies that are sent as they were put there, and their kinds; their ids are numbered from `first` on.
static void read_things(Reader& reader, i32 count, Span<Turned> turns, Sort sort, i32 first, List<BodyRow>& rows) {
  const Span<ToldBody> things = reader.take<ToldBody>(count);
  const Span<i64> kinds = reader.take<i64>(count);
  const i32 before = rows.size();
  for (i32 i = 0; i < count; i++) {
    const i32 degrees = things[i].rotation;
    if (degrees < 0 || degrees >= turns.size) fail(Failure::bad_request);
    rows.add(body_row(things[i], turns[degrees], kinds[i], sort)).name = first + i;
  }
  const auto id = [&](i32 number) {
    if (number >= rows.size()) fail(Failure::bad_request);
    return number < 0 ? -1 : rows[number].name;
  };
  for (i32 i = 0; i < count; i++) rows[before + i].on = id(things[i].on), rows[before + i].under = id(things[i].under);
}

// Reads the bodies: furniture, small things, people.
static Span<BodyRow> body_rows(const RoomRow& sent, Span<Turned> turns, Reader& reader) {
  const Span<BodyRow> told = reader.take<BodyRow>(sent.bodies);
  if (sent.furniture == 0 && sent.things == 0) return told;
  List<BodyRow> rows;
  i32 furniture = 0;
  while (furniture < told.size && told[furniture].sort == Sort::furniture) rows.add(told[furniture++]);
  if (furniture > 0 && sent.furniture > 0) fail(Failure::bad_request);
  read_things(reader, sent.furniture, turns, Sort::furniture, 0, rows);
  read_things(reader, sent.things, turns, Sort::decoration, sent.first_thing, rows);
  for (i32 i = furniture; i < told.size; i++) rows.add(told[i]);
  return rows.all();
}

Span<Kind> read_kinds(Reader& reader, i32 count) {
  if (count < 0) fail(Failure::bad_request);
  const auto is_within = [](i64 first, i64 many, i64 all) { return first >= 0 && many >= 0 && first <= all - many; };
  List<Kind> kinds;
  for (i32 i = 0; i < count; i++) {
    const KindRow& row = reader.take<KindRow>(1)[0];
    Kind kind{{}, {}, {}, {}, row.any_of, row.all_of};
    kind.surfaces = reader.take<Surface>(row.surfaces);
    kind.parts = reader.take<UnitBox>(row.parts);
    kind.fronts = reader.take<Front>(row.fronts);
    kind.numbers = reader.take<i64>(row.numbers);
    bool fits = true;
    for (const i64 number : kind.numbers) fits = fits && is_within(number, 1, row.parts);
    for (const Front& front : kind.fronts) {
      fits = fits && front.parts > 0 && is_within(front.first, front.parts, row.numbers) && absolute(front.end) <= 180;
    }
    if (!fits) fail(Failure::bad_request);
    kinds.add(kind);
  }
  return kinds.all();
}

Room read_room(Reader& reader, Span<Kind> kinds, Span<Turned> turns, i64 half_wall) {
  const RoomRow& sent = reader.take<RoomRow>(1)[0];
  Room room{};
  room.half_wall = half_wall;
  room.bounds = sent.bounds;
  room.ceiling = sent.ceiling;
  room.is_outdoor = sent.outdoor != 0;
  room.names = sent.names;
  room.inside = reader.take<Rect>(sent.inside);
  room.missing = reader.take<Rect>(sent.missing);
  room.edges = reader.take<Edge>(sent.edges);
  if (sent.openings < 0 || sent.beyond < 0 || sent.beyond > (1 << 30) - sent.openings) fail(Failure::bad_request);
  room.openings = reader.take<Opening>(sent.openings + sent.beyond);
  room.own = sent.openings;
  room.fitted = reader.take<FittedBox>(sent.fitted);
  room.kinds = kinds;
  const Span<BodyRow> rows = body_rows(sent, turns, reader);
  room.bodies = reserved<Body>(rows.size);
  for (i32 i = 0; i < rows.size; i++) {
    const BodyRow& row = rows[i];
    const bool fits = row.kind >= 0 && row.kind < kinds.size && row.name >= 0 && row.name < sent.names && row.on < sent.names;
    if (!fits) fail(Failure::bad_request);
    room.bodies[i] = body_of(row);
  }
  return room;
}

constexpr i64 DOOR_DEPTH = PER_METRE * 9 / 10;  // a door's square is as deep as the door is wide, at most this
constexpr i64 WINDOW_DEPTH = PER_METRE / 2;     // so much tall pieces leave free before a window,
constexpr i64 WINDOW_MARGIN = PER_METRE / 10;   // and beside it

Zone zone_of(const Room& room, i32 opening) {
  const Opening& one = room.openings[opening];
  const Edge& edge = one.edge;
  const bool is_own = opening < room.own;
  if (one.kind == OpeningKind::window && is_own) {
    return {edge.strip(edge.start - WINDOW_MARGIN, edge.end + WINDOW_MARGIN, WINDOW_DEPTH, 0), one.sill, one.top};
  }
  if (!one.is_door() || !one.keeps_free()) return {};
  const i64 deep = least(edge.end - edge.start, DOOR_DEPTH);
  return {edge.strip(edge.start, edge.end, is_own ? deep : 0, is_own ? 0 : deep), one.sill, one.top};
}

}  // namespace validate
