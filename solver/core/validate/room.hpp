// A room as the rules see it: its walls, zones and bodies in steps of a quarter micrometre (solver/validator/lattice.py tells why).
#pragma once

#include "plain/lists.hpp"
#include "plain/told_body.hpp"
#include "validate/validate.hpp"

namespace validate {

constexpr i64 PER_METRE = 4000000;
constexpr i64 MICROMETRE = 4;
constexpr i64 FLAT = PER_METRE / 50;  // what is no higher is not a body

// The nearest whole number; of two as near, the even one, as Python's round() says.
inline f64 nearest(f64 x) { return __builtin_rint(x); }
inline i64 rounded(f64 x) { return whole(nearest(x)); }

// Metres to the micrometre, in steps. Nothing is farther away than a million kilometres.
inline i64 exact(f64 metres) {
  if (!(absolute(metres) <= 1e9)) fail(Failure::bad_request);
  return MICROMETRE * rounded(metres * 1e6);
}

constexpr Rect grown(const Rect& box, i64 by) { return box.shrunk(-by); }
constexpr Rect moved(const Rect& box, i64 x, i64 z) { return {box.x0 + x, box.z0 + z, box.x1 + x, box.z1 + z}; }

// How much of x and of z two boxes share; above 0 in both where they overlap.
constexpr Extent shared(const Rect& a, const Rect& b) {
  return {least(a.x1, b.x1) - most(a.x0, b.x0), least(a.z1, b.z1) - most(a.z0, b.z0)};
}
constexpr bool meet(const Rect& a, const Rect& b) {
  const Extent both = shared(a, b);
  return both.x > 0 && both.z > 0;
}

// A straight piece of wall line; the room lies to the south of its north wall.
struct Edge {
  i64 side;  // a Wall
  i64 line;
  i64 start;
  i64 end;

  constexpr bool runs_east() const { return runs_along_x(static_cast<Wall>(side)); }
  constexpr bool looks_ahead() const { return inwards(static_cast<Wall>(side)) > 0; }
  // The box over an interval of the edge that reaches into the room and out of it.
  constexpr Rect strip(i64 from, i64 to, i64 into, i64 out) const {
    const i64 low = line - (looks_ahead() ? out : into), high = line + (looks_ahead() ? into : out);
    return runs_east() ? Rect{from, low, to, high} : Rect{low, from, high, to};
  }
  constexpr Edge moved(i64 x, i64 z) const {
    const i64 across = runs_east() ? z : x, along = runs_east() ? x : z;
    return {side, line + across, start + along, end + along};
  }
};

// Floor that an opening keeps free of what stands between two heights.
struct Zone {
  Rect box;
  i64 sill;
  i64 top;
};

enum class OpeningKind : i32 { window = 0, door = 1, passage = 2, garage_door = 3, other = 4 };

// Where an opening leads, where not to a room of the storey, by its number: what is not judged; outside; to no room that there is.
enum class Leads : i32 { anywhere = -1, outside = -2, nowhere = -3 };

// An opening at its place on a room's walls; of the boxes fitted to openings so many are its own, which follow those of the one before it.
struct Opening {
  Edge edge;      // from where to where
  i64 sill, top;  // as the rules read them, in steps
  f64 low, high;  // as it is cut out of the wall, m
  OpeningKind kind;
  i32 to;  // a room's number, or a `Leads`
  i32 fitted;
  i32 flags;

  bool keeps_free() const { return flags & 1; }    // its square, in this room
  bool says_height() const { return flags & 2; }
  bool is_door() const { return kind == OpeningKind::door || kind == OpeningKind::passage; }
  bool is_way() const { return is_door() || kind == OpeningKind::garage_door; }
};

// A box that is fitted to an opening: along the wall from where that begins, up from the floor, across from the wall's middle line, m.
struct FittedBox {
  f64 start, end, low, high, near, far;
};

// A kind of body: how many surfaces, parts, fronts, and numbers of these' parts follow; the sides that it is used from, one of them or all
// of them, as bits by how many quarter turns they are from the front: right, back, left.
struct KindRow {
  i32 surfaces, parts, fronts, numbers, any_of, all_of;
};

// What carries things: how high above the underside, how far in from the edges as it is seen from the front's side.
struct Surface {
  i64 height;
  i64 left, right, back, front;
};

// How a part fills the box around it: as a box, a cylinder along x, y or z, or a ball.
enum class Fills : i64 { box = 0, along_x = 1, along_y = 2, along_z = 3, ball = 4 };

// The box around a part, shares of its body's box.
struct UnitBox {
  f64 x0, x1, y0, y1, z0, z1;
  Fills fills;
};

enum class Sort : i32 { furniture = 0, decoration = 1, person = 2 };
enum class Turn : i32 { along = 0, crosswise = 1, between = 2 };

// A body as it is sent: metres; cosine and sine as they are, and without sign of the same angle within one turn.
struct BodyRow {
  f64 x, y, z, width, depth, height;
  f64 cosine, sine, cosine_size, sine_size;
  Turn turn;
  i32 quarters;  // how often it was turned by a right angle: its front looks south, east, north, west
  Sort sort;
  i32 name;   // ids as numbers: equal where the ids are
  i32 on;     // whom it says carries it, -1 nobody
  i32 under;  // the table, -1 none
  i32 wall;   // where it must stand or hang, -1 nowhere, 4 at no wall that there is
  i32 kind;
};

// A body's footprint and heights.
struct Body {
  const BodyRow* row;
  Rect box;
  i64 x, y, z;  // its middle, and its underside
  i64 high;
  bool is_solid;  // it stands on the floor's level of the plan: what the rules for standing speak of

  i64 low() const { return y; }
  bool is(Sort sort) const { return row->sort == sort; }
  bool hangs() const { return row->sort == Sort::decoration && row->wall >= 0; }
  // A small thing on something, at a wall, or above the floor.
  bool rests() const { return row->sort == Sort::decoration && (row->on >= 0 || row->wall >= 0 || row->y != 0.0); }
};

// How a body is turned that is told as it was put into the room: one for every whole degree, as the host's cosine and sine have it.
struct Turned {
  f64 cosine, sine, cosine_size, sine_size;
  Turn turn;
  i32 quarters;
};

// What is sent as it was put there: `furniture`, its ids numbered from 0 on, and then no other furniture is sent; and `things`, between the
// furniture and the people, their ids numbered from `first_thing` on.
struct RoomRow {
  Rect bounds;
  i64 ceiling;
  i32 inside, missing, edges, openings, beyond, fitted, bodies, names, furniture, things, first_thing, outdoor;
};

// A front of a kind: a point of its axis (0 the body's x, 1 y) in shares from the middle of its footprint at its underside; how far it
// opens, degrees, or the share of the body's depth that it slides along z; where the numbers of its parts are, among those of the kind.
struct Front {
  f64 x, y, z;
  f64 end;
  i64 axis;
  i64 slides;
  i64 first, parts;
};

struct Kind {
  Span<Surface> surfaces;
  Span<UnitBox> parts;
  Span<Front> fronts;
  Span<i64> numbers;
  i32 any_of, all_of;
};

struct Room {
  i64 half_wall;
  Rect bounds;
  i64 ceiling;         // how high it is above its floor
  bool is_outdoor;
  Span<Rect> inside;   // boxes that cover its floor
  Span<Rect> missing;  // boxes that cover the rest of its bounds
  Span<Edge> edges;
  Span<Opening> openings;  // that it lists itself, and behind them, from number `own` on, those that only others list
  i32 own;
  Span<FittedBox> fitted;
  Span<Kind> kinds;  // of its storey
  Span<Body> bodies;
  i32 names;

  const Kind& kind_of(const Body& body) const { return kinds[body.row->kind]; }
  Span<Surface> surfaces_of(const Body& body) const { return kind_of(body).surfaces; }
  Span<UnitBox> parts_of(const Body& body) const { return kind_of(body).parts; }
  Span<Front> fronts_of(const Body& body) const { return kind_of(body).fronts; }
};

Span<Kind> read_kinds(Reader& reader, i32 count);
Room read_room(Reader& reader, Span<Kind> kinds, Span<Turned> turns, i64 half_wall);

// What an opening of a room keeps free there; of what keeps nothing free a box without extent.
Zone zone_of(const Room& room, i32 opening);

// How far a front of a body opens, millionths of a degree or of a metre, and what it meets then: a body, -1 nothing, -2 a wall.
struct Opened {
  i64 travel;
  i32 meets, body, front, unused;
};

// A broken rule: who, with whom, by how much, and what its words say besides.
struct Finding {
  i64 rule;
  i64 body;
  i64 other;
  i64 amount;
  i64 a, b, c;
  i64 how;
};

// In the order of the answers' rules (solver/validator/judging.py).
enum class Rule : i32 {
  out_of_bounds,
  overlap,
  wall_far,
  blocks_door,
  blocks_window,
  floating,
  shapes_cross,
  above_ceiling,
  rooms_overlap,
  opening_wrong,
};

// What was found, and how much may be: with one more, which is too much, nothing more is looked for.
struct Findings {
  i64 most;
  List<Finding> rows;

  bool is_full() const { return rows.size() > most; }
};

inline void tell(Findings& found, Rule rule, i64 body, i64 other, i64 amount, i64 a = 0, i64 b = 0, i64 c = 0, i64 how = 0) {
  if (!found.is_full()) found.rows.add({static_cast<i64>(rule), body, other, amount, a, b, c, how});
}

void find_standing(const Room& room, Findings& found);
void find_above_ceiling(const Room& room, Findings& found);
void find_floating(const Room& room, Findings& found);
void find_crossing(const Room& room, Findings& found);

// Work that is counted, in looks at two walls or rooms: beyond what may be done no more is.
struct Looks {
  i64 most;
  i64 done;

  bool are_left_after(i64 more) {
    done += more;
    return done <= most;
  }
};

// How far the fronts of a room's furniture open.
void find_opened(const Room& room, Looks& looks, List<Opened>& found);

}  // namespace validate
