// The rule shapes_cross: no part of one body is in a part of another. Parts are boxes here, turned with their body; how deep they are in
// each other is counted in steps. Bodies far apart, the most by far, are told by floats first.
#include "validate/room.hpp"

namespace validate {

constexpr i64 TOUCHING = PER_METRE / 500;  // parts that are no deeper in each other only touch
constexpr f64 CROSSED_METRES = 0.02;

namespace {

// A body and the room it takes up at most, m.
struct Bounds {
  f64 west, east, north, south, bottom, top;
  i32 body;
};

// A part in the room: its middle, half its extents along its own axes, how it is turned, its heights.
struct PlacedPart {
  i64 x, z, half_x, half_z;
  f64 cosine, sine;
  i64 low, high;
};

}  // namespace

static List<Bounds> bounds_of_all(const Room& room) {
  List<Bounds> found;
  for (i32 i = 0; i < room.bodies.size; i++) {
    const BodyRow& row = *room.bodies[i].row;
    if (!(row.height > CROSSED_METRES || row.y > 0)) continue;
    f64 width = row.width / 2, depth = row.depth / 2;
    if (row.turn == Turn::crosswise) swap(width, depth);
    if (row.turn == Turn::between) width = depth = width + depth;
    found.add({row.x - width, row.x + width, row.z - depth, row.z + depth, row.y, row.y + row.height, i});
  }
  stable_sort(found.all(), [](const Bounds& a, const Bounds& b) { return a.west < b.west; });
  return found;
}

static bool is_carrier(const Body& one, const Body& of) { return of.row->under == one.row->name || of.row->on == one.row->name; }

static PlacedPart placed(const Body& body, const UnitBox& part) {
  const BodyRow& row = *body.row;
  const f64 width = static_cast<f64>(exact(row.width)), depth = static_cast<f64>(exact(row.depth));
  const f64 height = static_cast<f64>(exact(row.height));
  const f64 across = nearest((part.x0 + part.x1 - 1.0) / 2.0 * width), along = nearest((part.z0 + part.z1 - 1.0) / 2.0 * depth);
  i64 half_x = rounded((part.x1 - part.x0) / 2.0 * width), half_z = rounded((part.z1 - part.z0) / 2.0 * depth);
  const i64 x = body.x + rounded(across * row.cosine + along * row.sine), z = body.z + rounded(along * row.cosine - across * row.sine);
  const i64 low = body.y + rounded(part.y0 * height), high = body.y + rounded(part.y1 * height);
  if (row.turn == Turn::between) return {x, z, half_x, half_z, row.cosine, row.sine, low, high};
  if (row.turn == Turn::crosswise) swap(half_x, half_z);
  return {x, z, half_x, half_z, 1.0, 0.0, low, high};
}

static List<PlacedPart> parts_in(const Room& room, const Body& body) {
  List<PlacedPart> found;
  for (const UnitBox& part : room.parts_of(body)) found.add(placed(body, part));
  return found;
}

// How far a part has to move, along any axis of the two, to leave the other one; not above 0 where they are apart.
static i64 depth_of(const PlacedPart& a, const PlacedPart& b) {
  const i64 tall = least(a.high - b.low, b.high - a.low);
  if (tall <= TOUCHING) return tall;
  const i64 dx = b.x - a.x, dz = b.z - a.z;
  if (a.sine == 0.0 && b.sine == 0.0) {
    return least(tall, least(a.half_x + b.half_x - magnitude(dx), a.half_z + b.half_z - magnitude(dz)));
  }
  const f64 cosine = absolute(a.cosine * b.cosine + a.sine * b.sine), sine = absolute(a.sine * b.cosine - a.cosine * b.sine);
  const f64 far_x = static_cast<f64>(dx), far_z = static_cast<f64>(dz);
  f64 shared = INFINITE;
  const auto along_axes_of = [&](const PlacedPart& one, const PlacedPart& other) {
    const f64 across = absolute(far_x * one.cosine - far_z * one.sine), along = absolute(far_x * one.sine + far_z * one.cosine);
    const f64 half_x = static_cast<f64>(other.half_x), half_z = static_cast<f64>(other.half_z);
    shared = least(shared, static_cast<f64>(one.half_x) + half_x * cosine + half_z * sine - across);
    shared = least(shared, static_cast<f64>(one.half_z) + half_x * sine + half_z * cosine - along);
  };
  along_axes_of(a, b);
  along_axes_of(b, a);
  return least(tall, rounded(shared));
}

// How deep any part of one body is in any of another.
static i64 deepest(const Room& room, const Body& a, const Body& b) {
  arena::Scope scope;
  const List<PlacedPart> mine = parts_in(room, a), its = parts_in(room, b);
  i64 deep = 0;
  for (const PlacedPart& one : mine) {
    for (const PlacedPart& other : its) deep = most(deep, depth_of(one, other));
  }
  return deep;
}

// Where both bodies stand on the floor and neither is under or on the other, overlap speaks of them.
void find_crossing(const Room& room, Findings& found) {
  const List<Bounds> bodies = bounds_of_all(room);
  for (i32 k = 0; k < bodies.size() && !found.is_full(); k++) {
    const Bounds& a = bodies[k];
    const Body& one = room.bodies[a.body];
    for (i32 later = k + 1; later < bodies.size() && bodies[later].west < a.east && !found.is_full(); later++) {
      const Bounds& b = bodies[later];
      const Body& other = room.bodies[b.body];
      if (b.bottom >= a.top || a.bottom >= b.top || b.north >= a.south || a.north >= b.south) continue;
      const bool both_on_floor = !one.rests() && !other.rests();
      if (both_on_floor && !is_carrier(one, other) && !is_carrier(other, one)) continue;
      const i64 deep = deepest(room, one, other);
      if (deep > TOUCHING) tell(found, Rule::shapes_cross, a.body, b.body, deep);
    }
  }
}

}  // namespace validate
