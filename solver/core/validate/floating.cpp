// The rule floating: a thing lies on a surface of what carries it, or hangs at its wall; furniture stands on what it says.
#include "validate/room.hpp"

namespace validate {

constexpr i64 RESTS = PER_METRE / 100;      // a thing lies on a surface whose height differs by no more
constexpr i64 HANGS = PER_METRE / 100 * 3;  // a thing hangs at a wall whose face is no farther

enum class How : i32 { floats = 0, in_a_circle = 1, no_such_wall = 2, off_its_wall = 3 };

namespace {

// Who carries whom in a room: furniture and small things by the number of their ids.
class Carriers {
 public:
  explicit Carriers(const Room& room) : room_(room), by_name_(reserved<i32>(room.names)), listed_(reserved<i32>(room.bodies.size)) {
    for (i32& one : by_name_) one = -1;
    for (i32 i = 0; i < room.bodies.size; i++) {
      if (carries(i)) by_name_[room.bodies[i].row->name] = i;
    }
    List<i32> seen;
    for (i32 i = 0; i < room.bodies.size; i++) {
      i32& named = by_name_[room.bodies[i].row->name];
      listed_[i] = carries(i) && named >= 0 ? named : -1;
      if (listed_[i] >= 0) seen.add(i), named = -1;
    }
    for (const i32 i : seen) by_name_[room.bodies[i].row->name] = listed_[i];
  }

  bool carries(i32 i) const { return !room_.bodies[i].is(Sort::person); }
  // What carries a body by its own words, -1 nothing in the room: what hangs is carried by its wall.
  i32 below(i32 i) const {
    const Body& body = room_.bodies[i];
    return body.hangs() || body.row->on < 0 ? -1 : by_name_[body.row->on];
  }
  // The body at a place in the order of ids, -1 where the id was there before.
  i32 listed(i32 i) const { return listed_[i]; }
  // Whether what carries a body, and what carries that, comes back to the body; by the ids, so that no more steps than bodies are gone.
  bool in_a_circle(i32 i) const {
    i32 at = below(i);
    for (i32 steps = 0; at >= 0 && steps <= room_.bodies.size; steps++) {
      if (room_.bodies[at].row->name == room_.bodies[i].row->name) return true;
      at = below(at);
    }
    return false;
  }

 private:
  const Room& room_;
  Span<i32> by_name_;
  Span<i32> listed_;
};

// How far a middle misses a support: beside it, and above or below it.
struct Miss {
  i64 beside;
  i64 above;

  i64 worst() const { return most(beside, above); }
};

// The rectangle of a surface; of a body at another than a right angle, within the rectangle around that, as if it went all round.
Rect area_of(const Body& carrier, const Surface& one) {
  const Rect& box = carrier.box;
  if (carrier.row->turn == Turn::between) return grown(box, -least(least(one.left, one.right), least(one.back, one.front)));
  return drawn_in(box, one, carrier.row->quarters);
}

// The least miss of a body; the first of those that are alike.
class LeastMiss {
 public:
  explicit LeastMiss(const Body& body) : body_(body) {}

  void try_support(const Rect& box, i64 level) {
    const i64 beside = most(most(most(box.x0 - body_.x, body_.x - box.x1), most(box.z0 - body_.z, body_.z - box.z1)), i64{0});
    const i64 apart = magnitude(body_.y - level);
    const Miss miss{beside, apart > RESTS ? apart : 0};
    if (!tried_ || miss.worst() < least_.worst()) least_ = miss;
    tried_ = true;
  }
  void try_body(const Room& room, const Body& carrier) {
    for (const Surface& surface : room.surfaces_of(carrier)) {
      try_support(area_of(carrier, surface), carrier.y + surface.height);
    }
  }
  bool is_carried() const { return tried_ && least_.worst() == 0; }
  const Miss& least_miss() const { return least_; }

 private:
  const Body& body_;
  Miss least_{0, 0};
  bool tried_ = false;
};

}  // namespace

static void find_not_carried(const Room& room, const Carriers& carriers, i32 i, Findings& found) {
  const i32 parent = carriers.below(i);
  if (parent >= 0 && carriers.in_a_circle(i)) {
    tell(found, Rule::floating, i, parent, 0, 0, 0, 0, static_cast<i64>(How::in_a_circle));
    return;
  }
  LeastMiss miss(room.bodies[i]);
  if (parent >= 0) {
    miss.try_body(room, room.bodies[parent]);
  } else {
    miss.try_support(room.bounds, 0);
    for (i32 k = 0; k < room.bodies.size && !miss.is_carried(); k++) {
      const i32 other = carriers.listed(k);
      if (other >= 0 && other != i) miss.try_body(room, room.bodies[other]);
    }
  }
  const Miss& least_miss = miss.least_miss();
  if (miss.is_carried()) return;
  tell(found, Rule::floating, i, parent, least_miss.worst(), least_miss.beside, least_miss.above, 0, static_cast<i64>(How::floats));
}

// How far a box's back is from a piece of wall's face, or its middle from that piece's ends.
static i64 away(const Edge& edge, const Rect& box, i64 half_wall) {
  const i64 line = box.line(static_cast<Wall>(edge.side));
  const i64 face = edge.line + (edge.looks_ahead() ? half_wall : -half_wall);
  const i64 middle = edge.runs_east() ? floor_div(box.x0 + box.x1, 2) : floor_div(box.z0 + box.z1, 2);
  return most(magnitude(line - face), most(edge.start - middle, middle - edge.end));
}

static void find_off_its_wall(const Room& room, i32 i, Findings& found) {
  bool is_there = false;
  i64 least_away = 0;
  for (const Edge& edge : room.edges) {
    if (edge.side != room.bodies[i].row->wall) continue;
    const i64 here = away(edge, room.bodies[i].box, room.half_wall);
    least_away = is_there ? least(least_away, here) : here;
    is_there = true;
  }
  if (!is_there) tell(found, Rule::floating, i, -1, 0, 0, 0, 0, static_cast<i64>(How::no_such_wall));
  if (least_away > HANGS) tell(found, Rule::floating, i, -1, least_away, 0, 0, 0, static_cast<i64>(How::off_its_wall));
}

void find_floating(const Room& room, Findings& found) {
  const Carriers carriers(room);
  for (i32 i = 0; i < room.bodies.size; i++) {
    const Body& body = room.bodies[i];
    const bool must_be_carried = body.is(Sort::furniture) ? body.row->on >= 0 : body.is(Sort::decoration) && !body.hangs();
    if (must_be_carried) find_not_carried(room, carriers, i, found);
    if (body.hangs()) find_off_its_wall(room, i, found);
  }
}

}  // namespace validate
