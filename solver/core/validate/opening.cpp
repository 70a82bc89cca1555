// How far the fronts of a room's furniture open before a part of one meets something, and what: by small steps, each judged for itself but
// those in which no point of the part comes as far as the nearest thing is away.
// Everything is in the frame of the furniture, m, x to its right, y up, z to its front; boxes are told apart along the fifteen axes of two,
// round solids along some more: what these do not tell apart meets, by a few mm too soon at most.
#include "validate/room.hpp"
#include "validate/shell.hpp"

namespace validate {

constexpr f64 COSINE = 0.99996192306417131, SINE = 0.0087265354983739347;  // of a step of half a degree
constexpr i32 DIRECTIONS = 16;                                              // across a round solid, within half a turn
constexpr f64 ACROSS_COSINE = 0.98078528040323043, ACROSS_SINE = 0.19509032201612825;  // from one of them to the next
constexpr f64 STEP_DEGREES = 0.5, STEP_METRES = 0.0025, QUARTER_TURN = 90;
constexpr i64 STEPS = 2000;               // a front makes at most
constexpr f64 STEP_SHARE = 0.00873;       // of its distance from the hinge: no point moves farther in a step
constexpr f64 SURELY_METRES = 0.00001;    // bounds farther apart than this are so whatever was rounded
constexpr f64 TOUCHING_METRES = 0.00025;  // a front is so much smaller at every side: what touches it does not stop it
constexpr f64 CLEAR_METRES = 0.001;        // boxes whose bounds are that far apart need no closer look
constexpr f64 FLAT_METRES = 0.03;         // what lies on the floor and is no higher is walked on, and opened over
constexpr i32 NOTHING = -1, WALL = -2;
constexpr i64 FRONT_LOOKS = 70;           // what a front counts for each body of its room; measured

namespace {

struct Point3 {
  f64 x, y, z;
};
struct SolidBox {
  Point3 at, half;
  Point3 along[3];  // where its own axes point
  i32 body;
  Fills fills;
};
struct Span3 {
  Point3 low, high;
};
struct Obstacle {
  SolidBox box;
  Span3 span;  // wider by CLEAR_METRES at every side
};
// A piece of furniture's frame in the room.
struct Frame {
  f64 x, y, z, cosine, sine;
  Point3 turned(f64 east, f64 up, f64 south) const { return {east * cosine - south * sine, up, east * sine + south * cosine}; }
  Point3 point(f64 east, f64 up, f64 south) const { return turned(east - x, up - y, south - z); }
};

}  // namespace

static f64 dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Point3 cross(const Point3& a, const Point3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// How far a solid reaches from its middle along an axis.
static f64 reach(const SolidBox& box, const Point3& axis) {
  const f64 x = box.half.x * dot(box.along[0], axis), y = box.half.y * dot(box.along[1], axis), z = box.half.z * dot(box.along[2], axis);
  switch (box.fills) {
    case Fills::along_x: return absolute(x) + __builtin_sqrt(y * y + z * z);
    case Fills::along_y: return absolute(y) + __builtin_sqrt(x * x + z * z);
    case Fills::along_z: return absolute(z) + __builtin_sqrt(x * x + y * y);
    case Fills::ball: return __builtin_sqrt(x * x + y * y + z * z);
    default: return absolute(x) + absolute(y) + absolute(z);
  }
}

static bool part_along(const SolidBox& a, const SolidBox& b, const Point3& way, const Point3& axis) {
  return absolute(dot(way, axis)) > reach(a, axis) + reach(b, axis);
}

// From the nearest point of a solid's box to another's middle.
static Point3 away_from(const SolidBox& box, const Point3& middle) {
  const Point3 way = minus(middle, box.at);
  const f64 halves[3] = {box.half.x, box.half.y, box.half.z};
  Point3 left = way;
  for (i32 i = 0; i < 3; i++) {
    const f64 by = most(-halves[i], least(halves[i], dot(way, box.along[i])));
    left = minus(left, {box.along[i].x * by, box.along[i].y * by, box.along[i].z * by});
  }
  return left;
}

// Where the surface of a ball looks at which a way from its middle meets it, however stretched it is.
static Point3 normal_of(const SolidBox& ball, const Point3& way) {
  const f64 halves[3] = {ball.half.x, ball.half.y, ball.half.z};
  Point3 found{0, 0, 0};
  for (i32 i = 0; i < 3; i++) {
    const f64 by = dot(way, ball.along[i]) / most(halves[i] * halves[i], 1e-9);
    found = {found.x + ball.along[i].x * by, found.y + ball.along[i].y * by, found.z + ball.along[i].z * by};
  }
  return found;
}

// Whether a round solid is apart from another along an axis across its own, every 11 degrees, or along the shortest way between them; a
// ball, also along that way as it looks at its surface.
static bool apart_as_round(const SolidBox& round, const SolidBox& other) {
  if (round.fills == Fills::box) return false;
  const Point3 way = minus(other.at, round.at), shortest = away_from(other, round.at);
  if (dot(shortest, shortest) > 1e-9 && part_along(round, other, way, shortest)) return true;
  if (round.fills == Fills::ball) return dot(shortest, shortest) > 1e-9 && part_along(round, other, way, normal_of(round, shortest));
  const i32 axis = static_cast<i32>(round.fills) - 1;
  const Point3 &u = round.along[(axis + 1) % 3], &v = round.along[(axis + 2) % 3];
  f64 cosine = 1, sine = 0;
  for (i32 k = 0; k < DIRECTIONS; k++) {
    if (part_along(round, other, way, {u.x * cosine + v.x * sine, u.y * cosine + v.y * sine, u.z * cosine + v.z * sine})) return true;
    const f64 turned = cosine * ACROSS_COSINE - sine * ACROSS_SINE;
    sine = sine * ACROSS_COSINE + cosine * ACROSS_SINE, cosine = turned;
  }
  return false;
}

static bool meet_each_other(const SolidBox& a, const SolidBox& b) {
  const Point3 way = minus(b.at, a.at);
  for (i32 i = 0; i < 3; i++) {
    if (part_along(a, b, way, a.along[i]) || part_along(a, b, way, b.along[i])) return false;
  }
  for (i32 i = 0; i < 3; i++) {
    for (i32 k = 0; k < 3; k++) {
      const Point3 axis = cross(a.along[i], b.along[k]);
      if (dot(axis, axis) > 1e-9 && part_along(a, b, way, axis)) return false;
    }
  }
  return !apart_as_round(a, b) && !apart_as_round(b, a);
}

static Span3 span_of(const SolidBox& box) {
  const Point3 half{reach(box, {1, 0, 0}), reach(box, {0, 1, 0}), reach(box, {0, 0, 1})};
  return {minus(box.at, half), {box.at.x + half.x, box.at.y + half.y, box.at.z + half.z}};
}

// How far apart two are along the axis where they are farthest; below 0 where they share space.
static f64 apart(const Span3& a, const Span3& b) {
  const f64 x = most(a.low.x - b.high.x, b.low.x - a.high.x), y = most(a.low.y - b.high.y, b.low.y - a.high.y);
  return most(most(x, y), most(a.low.z - b.high.z, b.low.z - a.high.z));
}

static bool share(const Span3& a, const Span3& b) { return apart(a, b) < 0; }

// A box of a body, as seen from the furniture; shares of the body's own box.
static SolidBox box_of(const BodyRow& row, const UnitBox& part, const Frame& frame, i32 body) {
  const f64 across = ((part.x0 + part.x1) / 2 - 0.5) * row.width, along = ((part.z0 + part.z1) / 2 - 0.5) * row.depth;
  const Point3 at = frame.point(row.x + across * row.cosine + along * row.sine, row.y + (part.y0 + part.y1) / 2 * row.height,
                               row.z + along * row.cosine - across * row.sine);
  const Point3 half{(part.x1 - part.x0) / 2 * row.width, (part.y1 - part.y0) / 2 * row.height, (part.z1 - part.z0) / 2 * row.depth};
  return {at, half, {frame.turned(row.cosine, 0, -row.sine), {0, 1, 0}, frame.turned(row.sine, 0, row.cosine)}, body, part.fills};
}

static SolidBox wall_of(const ShellBox& box, const Frame& frame) {
  const Point3 half{(box.x1 - box.x0) / 2, (box.y1 - box.y0) / 2, (box.z1 - box.z0) / 2};
  const Point3 at = frame.point((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, (box.z0 + box.z1) / 2);
  return {at, half, {frame.turned(1, 0, 0), {0, 1, 0}, frame.turned(0, 0, 1)}, WALL, Fills::box};
}

static Point3 moved_point(const Front& front, const Point3& hinge, f64 cosine, f64 sine, f64 way, const Point3& p) {
  if (front.slides) return {p.x, p.y, p.z + way};
  const Point3 d = minus(p, hinge);
  if (front.axis == 1) return {hinge.x + d.x * cosine + d.z * sine, p.y, hinge.z + d.z * cosine - d.x * sine};
  return {p.x, hinge.y + d.y * cosine - d.z * sine, hinge.z + d.y * sine + d.z * cosine};
}

static SolidBox moved_box(const Front& front, const Point3& hinge, f64 cosine, f64 sine, f64 way, const SolidBox& box) {
  SolidBox now = box;
  now.at = moved_point(front, hinge, cosine, sine, way, box.at);
  if (front.slides) return now;
  for (Point3& axis : now.along) axis = moved_point(front, {0, 0, 0}, cosine, sine, 0, axis);
  return now;
}

// How far something that turns comes along an axis from its hinge.
struct Reach {
  f64 low = 0, high = 0;

  // A corner, where it is now and where it is after a quarter turn: on its way both are taken with factors from 0 to 1.
  void add(f64 now, f64 then) {
    low = least(low, least(now, 0.0) + least(then, 0.0));
    high = most(high, most(now, 0.0) + most(then, 0.0));
  }
  void widen(f64& from, f64& to, f64 hinge, f64 far, bool within_quarter) const {
    from = least(from, hinge - (within_quarter ? least(far, SURELY_METRES - low) : far));
    to = most(to, hinge + (within_quarter ? least(far, SURELY_METRES + high) : far));
  }
};

// All that a front comes to at most.
static Span3 swept(const Front& front, const Point3& hinge, const List<SolidBox>& parts, f64 length) {
  const bool upright = front.axis == 1;
  const f64 sign = upright == (front.end < 0) ? -1 : 1;
  f64 far = 0;
  Reach across, before;
  Span3 all = span_of(parts[0]);
  for (const SolidBox& part : parts) {
    const Span3 one = span_of(part);
    all.low = {least(all.low.x, one.low.x), least(all.low.y, one.low.y), least(all.low.z, one.low.z)};
    all.high = {most(all.high.x, one.high.x), most(all.high.y, one.high.y), most(all.high.z, one.high.z)};
    for (i32 corner = 0; corner < 4; corner++) {
      const f64 a = upright ? (corner & 1 ? one.high.x : one.low.x) - hinge.x : (corner & 1 ? one.high.y : one.low.y) - hinge.y;
      const f64 z = (corner & 2 ? one.high.z : one.low.z) - hinge.z;
      far = most(far, a * a + z * z);
      across.add(a, z * sign), before.add(z, -a * sign);
    }
  }
  if (front.slides) {
    all.high.z += length;
    return all;
  }
  far = __builtin_sqrt(far) + SURELY_METRES;
  const bool within_quarter = length <= QUARTER_TURN;
  before.widen(all.low.z, all.high.z, hinge.z, far, within_quarter);
  if (upright) across.widen(all.low.x, all.high.x, hinge.x, far, within_quarter);
  if (front.axis == 0) across.widen(all.low.y, all.high.y, hinge.y, far, within_quarter);
  return all;
}

// What a body takes up at most, as seen from the room.
static Span3 span_of(const BodyRow& row) {
  const f64 across = (row.width * row.cosine_size + row.depth * row.sine_size) / 2;
  const f64 along = (row.width * row.sine_size + row.depth * row.cosine_size) / 2;
  return {{row.x - across, row.y, row.z - along}, {row.x + across, row.y + row.height, row.z + along}};
}

// What a box of a piece's frame takes up at most, as seen from the room, and a little more.
static Span3 in_the_room(const Span3& box, const Frame& frame) {
  const f64 x = (box.low.x + box.high.x) / 2, z = (box.low.z + box.high.z) / 2, wide = box.high.x - x, deep = box.high.z - z;
  const f64 cosine = absolute(frame.cosine), sine = absolute(frame.sine);
  const Point3 at{frame.x + x * frame.cosine + z * frame.sine, frame.y, frame.z + z * frame.cosine - x * frame.sine};
  const Point3 half{wide * cosine + deep * sine + CLEAR_METRES, CLEAR_METRES, wide * sine + deep * cosine + CLEAR_METRES};
  return {{at.x - half.x, at.y + box.low.y - half.y, at.z - half.z}, {at.x + half.x, at.y + box.high.y + half.y, at.z + half.z}};
}

// The boxes that reach into some room: of other bodies, and walls. A small thing that carries nothing is its whole box; what lies on the
// furniture itself is taken off before a lid is lifted.
static List<Obstacle> obstacles(const Room& room, Span<ShellBox> shell, const List<bool>& carries, i32 own, const Frame& frame,
                                const Span3& within) {
  constexpr UnitBox whole{0, 1, 0, 1, 0, 1, Fills::box};
  List<Obstacle> found;
  const Point3 wider{CLEAR_METRES, CLEAR_METRES, CLEAR_METRES};
  const Span3 there = in_the_room(within, frame);
  const auto take = [&](const SolidBox& box) {
    const Span3 span = span_of(box);
    const Point3& high = span.high;
    if (share(span, within)) found.add({box, {minus(span.low, wider), {high.x + wider.x, high.y + wider.y, high.z + wider.z}}});
  };
  for (i32 i = 0; i < room.bodies.size; i++) {
    const BodyRow& row = *room.bodies[i].row;
    const bool flat = row.sort == Sort::decoration && !room.bodies[i].rests() && row.height <= FLAT_METRES;
    const bool aside = i == own || row.on == room.bodies[own].row->name || row.sort == Sort::person || flat;
    if (aside || !share(span_of(row), there) || !share(span_of(box_of(row, whole, frame, i)), within)) continue;
    const Span<UnitBox> parts = room.parts_of(room.bodies[i]);
    if (parts.size == 0 || (row.sort == Sort::decoration && !carries[i])) {
      take(box_of(row, whole, frame, i));
      continue;
    }
    for (const UnitBox& part : parts) take(box_of(row, part, frame, i));
  }
  for (const ShellBox& box : shell) {
    if (share({{box.x0, box.y0, box.z0}, {box.x1, box.y1, box.z1}}, there)) take(wall_of(box, frame));
  }
  return found;
}

// How far a point of a part moves at most in a step.
static f64 farthest_step(const Front& front, const Point3& hinge, const SolidBox& part) {
  if (front.slides) return STEP_METRES;
  const Point3 away = minus(part.at, hinge);
  return STEP_SHARE * (__builtin_sqrt(dot(away, away)) + __builtin_sqrt(dot(part.half, part.half)));
}

// A front of a body, by its number there, and the numbers of its parts.
struct Moving {
  const Front& front;
  i32 body, number;
  Span<i64> parts;
};

static Opened opened(const Room& room, Span<ShellBox> shell, const List<bool>& carries, const Moving& moving) {
  const Front& front = moving.front;
  const BodyRow& row = *room.bodies[moving.body].row;
  const Frame frame{row.x, row.y, row.z, row.cosine, row.sine};
  const Span<UnitBox> all = room.parts_of(room.bodies[moving.body]);
  const Point3 hinge{front.x * row.width, front.y * row.height, front.z * row.depth};
  List<SolidBox> parts;
  List<i64> clear_until;  // by part: the first step in which it may meet anything
  List<f64> farthest;     // how far a point of it moves at most in a step
  for (const i64 part : moving.parts) {
    SolidBox box = box_of(row, all[part], frame, moving.body);
    const Point3 half = minus(box.half, {TOUCHING_METRES, TOUCHING_METRES, TOUCHING_METRES});
    box.half = {most(half.x, 0.0), most(half.y, 0.0), most(half.z, 0.0)};
    parts.add(box);
    clear_until.add(0);
    farthest.add(farthest_step(front, hinge, box));
  }
  const f64 length = absolute(front.slides ? front.end * row.depth : front.end), step = front.slides ? STEP_METRES : STEP_DEGREES;
  const List<Obstacle> others = obstacles(room, shell, carries, moving.body, frame, swept(front, hinge, parts, length));
  f64 cosine = 1, sine = 0, way = 0;
  const f64 by = front.end < 0 ? -SINE : SINE;
  for (i64 k = 0; k < STEPS && others.size() > 0; k++) {
    for (i32 i = 0; i < parts.size(); i++) {
      if (k < clear_until[i]) continue;
      const SolidBox now = moved_box(front, hinge, cosine, sine, front.end < 0 ? -way : way, parts[i]);
      const Span3 bounds = span_of(now);
      f64 room_left = INFINITE;
      for (const Obstacle& other : others) {
        const f64 gap = apart(bounds, other.span);
        room_left = least(room_left, gap);
        if (gap >= 0 || !meet_each_other(now, other.box)) continue;
        return {whole(nearest(most(way - step, 0.0) * 1e6)), other.box.body, moving.body, moving.number, 0};
      }
      const f64 surely = room_left - SURELY_METRES;
      clear_until[i] = k + 1 + (surely > 0 ? least(whole(surely / farthest[i]), STEPS) : 0);
    }
    if (way >= length) break;
    way = least(way + step, length);
    const f64 turned = cosine * COSINE - sine * by;
    sine = sine * COSINE + cosine * by, cosine = turned;
  }
  return {whole(nearest(length * 1e6)), NOTHING, moving.body, moving.number, 0};
}

// Which bodies carry something.
static List<bool> carrying(const Room& room) {
  List<bool> is_carrier, carries;
  for (i32 i = 0; i < room.names; i++) is_carrier.add(false);
  for (const Body& body : room.bodies) {
    if (body.row->on >= 0) is_carrier[body.row->on] = true;
  }
  for (const Body& body : room.bodies) carries.add(is_carrier[body.row->name]);
  return carries;
}

void find_opened(const Room& room, Looks& looks, List<Opened>& found) {
  i64 fronts = 0;
  for (const Body& body : room.bodies) fronts += body.is(Sort::furniture) ? room.fronts_of(body).size : 0;
  if (fronts == 0 || !looks.are_left_after(FRONT_LOOKS * fronts * room.bodies.size)) return;
  const Span<ShellBox> shell = shell_of(room, looks);
  const List<bool> carries = carrying(room);
  for (i32 i = 0; i < room.bodies.size && looks.are_left_after(0); i++) {
    if (!room.bodies[i].is(Sort::furniture)) continue;
    const Span<Front> own = room.fronts_of(room.bodies[i]);
    i64* const numbers = room.kind_of(room.bodies[i]).numbers.data;
    for (i32 k = 0; k < own.size; k++) {
      const arena::Mark mark = arena::mark();
      const Opened way = opened(room, shell, carries, {own[k], i, k, {numbers + own[k].first, static_cast<i32>(own[k].parts)}});
      arena::release(mark);
      found.add(way);
    }
  }
}

}  // namespace validate
