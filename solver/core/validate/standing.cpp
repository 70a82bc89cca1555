// The rules for where bodies stand: out_of_bounds, overlap, wall_far, blocks_door, blocks_window, above_ceiling. All in integers.
#include "validate/room.hpp"

namespace validate {

constexpr i64 WALL_REACH = PER_METRE / 5;            // a piece with a wall is no farther than this from its line,
constexpr i64 FACE_REACH = PER_METRE * 3 / 20;       // or than this from its face, where the wall is thick
constexpr i64 SITTING_ROOM = PER_METRE / 100 * 15;  // how much of a tucked chair's depth must stay out from under its table

// How a body overlaps another.
enum class Sharing : i32 { space = 0, tucked = 1 };

// Where a body leaves its room: to the west, east, north, south, into a corner that is not part of the room.
static void find_out_of_bounds(const Room& room, Findings& found) {
  for (i32 i = 0; i < room.bodies.size; i++) {
    if (!room.bodies[i].is_solid) continue;
    const Rect box = grown(room.bodies[i].box, room.half_wall), &bounds = room.bounds;
    const i64 ways[] = {bounds.x0 - box.x0, box.x1 - bounds.x1, bounds.z0 - box.z0, box.z1 - bounds.z1};
    i32 way = 0;
    i64 amount = ways[0];
    for (i32 k = 1; k < 4; k++) {
      if (ways[k] > amount) amount = ways[way = k];
    }
    for (const Rect& part : room.missing) {
      const Extent both = shared(box, part);
      if (least(both.x, both.z) > amount) amount = least(both.x, both.z), way = 4;
    }
    if (amount > 0) tell(found, Rule::out_of_bounds, i, way, amount);
  }
}

static void collide(const Room& room, i32 first, i32 second, Findings& found) {
  const Body &a = room.bodies[first], &b = room.bodies[second];
  const Extent both = shared(a.box, b.box);
  const i64 tall = least(a.high, b.high) - most(a.low(), b.low());
  if (both.x <= 0 || both.z <= 0 || tall <= 0 || a.row->on == b.row->name || b.row->on == a.row->name) return;
  const bool is_chair = a.row->under == b.row->name;
  if (!is_chair && b.row->under != a.row->name) {
    tell(found, Rule::overlap, first, second, least(least(both.x, both.z), tall), both.x, both.z, tall, static_cast<i64>(Sharing::space));
    return;
  }
  const Body& chair = is_chair ? a : b;
  const i64 depth = exact(chair.row->depth), tucked = chair.row->quarters % 2 ? both.x : both.z;
  const i64 amount = tucked - most<i64>(0, depth - SITTING_ROOM);
  const i32 table = is_chair ? second : first;
  if (amount > 0) tell(found, Rule::overlap, is_chair ? first : second, table, amount, tucked, depth, 0, static_cast<i64>(Sharing::tucked));
}

// Two bodies share space; but a chair may be tucked under its table, and a thing may stand on another. By first body, then by second.
static void find_overlap(const Room& room, Findings& found) {
  const bool by_x = room.bounds.width() >= room.bounds.depth();
  const auto low = [&](i32 i) { return by_x ? room.bodies[i].box.x0 : room.bodies[i].box.z0; };
  const auto high = [&](i32 i) { return by_x ? room.bodies[i].box.x1 : room.bodies[i].box.z1; };
  List<i32> ranked;
  for (i32 i = 0; i < room.bodies.size; i++) {
    if (room.bodies[i].is_solid) ranked.add(i);
  }
  stable_sort(ranked.all(), [&](i32 a, i32 b) { return low(a) < low(b); });
  const i32 before = found.rows.size();
  for (i32 k = 0; k < ranked.size() && !found.is_full(); k++) {
    for (i32 later = k + 1; later < ranked.size() && low(ranked[later]) < high(ranked[k]) && !found.is_full(); later++) {
      collide(room, least(ranked[k], ranked[later]), most(ranked[k], ranked[later]), found);
    }
  }
  stable_sort(Span<Finding>{found.rows.begin() + before, found.rows.size() - before}, [](const Finding& a, const Finding& b) {
    const i64 first = least(a.body, a.other), other = least(b.body, b.other);
    return first != other ? first < other : most(a.body, a.other) < most(b.body, b.other);
  });
}

// How far a box is from the edge's line; 0 where the line runs through it.
static i64 distance(const Rect& box, const Edge& edge) {
  const i64 low = edge.runs_east() ? box.z0 : box.x0, high = edge.runs_east() ? box.z1 : box.x1;
  return most<i64>(0, most(low - edge.line, edge.line - high));
}

static bool stands_before(const Rect& box, const Edge& edge) {
  const i64 start = edge.runs_east() ? box.x0 : box.z0, end = edge.runs_east() ? box.x1 : box.z1;
  return start < edge.end && edge.start < end;
}

// How far from the wall's line a piece with a wall may be: no less than 0.15 m from its face.
static i64 wall_reach(const Room& room) { return most(WALL_REACH, room.half_wall + FACE_REACH); }

// A piece is far from its wall: of the pieces of that wall from those that it stands before, else from all.
static void find_wall_far(const Room& room, Findings& found) {
  for (i32 i = 0; i < room.bodies.size; i++) {
    const Body& body = room.bodies[i];
    if (!body.is_solid || !body.is(Sort::furniture) || body.row->wall < 0) continue;
    i64 before = -1, any = -1;
    for (const Edge& edge : room.edges) {
      if (edge.side != body.row->wall) continue;
      const i64 away = distance(body.box, edge);
      any = any < 0 ? away : least(any, away);
      if (stands_before(body.box, edge)) before = before < 0 ? away : least(before, away);
    }
    const i64 away = before < 0 ? any : before;
    if (away > wall_reach(room)) tell(found, Rule::wall_far, i, -1, away - wall_reach(room), away);
  }
}

// A body stands in the square of a door; furniture taller than the sill stands before a window.
static void find_blocking(const Room& room, Rule rule, Findings& found) {
  for (i32 k = 0; k < room.openings.size; k++) {
    if ((room.openings[k].kind == OpeningKind::window) != (rule == Rule::blocks_window)) continue;
    const Zone zone = zone_of(room, k);
    for (i32 i = 0; i < room.bodies.size; i++) {
      const Body& body = room.bodies[i];
      const bool counts = body.is_solid && (rule == Rule::blocks_door || body.is(Sort::furniture));
      if (!counts || body.low() >= zone.top || body.high <= zone.sill || !meet(body.box, zone.box)) continue;
      const Extent both = shared(body.box, zone.box);
      tell(found, rule, i, k, least(both.x, both.z), body.high - zone.sill);
    }
  }
}

// A piece or a thing, wherever it stands, hangs or lies, is too high for its room. People may stoop.
void find_above_ceiling(const Room& room, Findings& found) {
  for (i32 i = 0; i < room.bodies.size; i++) {
    const i64 above = room.bodies[i].high - room.ceiling;
    if (above > 0 && !room.bodies[i].is(Sort::person)) tell(found, Rule::above_ceiling, i, -1, above);
  }
}

void find_standing(const Room& room, Findings& found) {
  find_out_of_bounds(room, found);
  find_overlap(room, found);
  find_wall_far(room, found);
  find_blocking(room, Rule::blocks_door, found);
  find_blocking(room, Rule::blocks_window, found);
}

}  // namespace validate
