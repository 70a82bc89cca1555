// What stands around a room for what opens in it: its walls without their holes, and what is fitted to these, m in the room's frame.
#include "validate/shell.hpp"

namespace validate {

constexpr i64 STRETCH_LOOKS = 60;  // what a hole counts at each stretch of wall that it is over; measured

static f64 metres(i64 steps) { return static_cast<f64>(steps) / static_cast<f64>(PER_METRE); }

namespace {

struct Span1 {
  f64 low, high;
};

// A wall's line, how high the wall is, and the boxes that are added along it.
struct Line {
  bool runs_east;
  f64 at, height;
  List<ShellBox>& boxes;

  void add(const Span1& along, const Span1& up, const Span1& across) const {
    const f64 near = at + across.low, far = at + across.high;
    if (runs_east) {
      boxes.add({along.low, up.low, near, along.high, up.high, far});
    } else {
      boxes.add({near, up.low, along.low, far, up.high, along.high});
    }
  }
};

// An interval along a wall, and which heights a hole takes there.
struct Cut {
  Span1 along, up;
};

}  // namespace

static Line line_of(const Edge& edge, const Room& room, List<ShellBox>& boxes) {
  return {edge.runs_east(), metres(edge.line), metres(room.ceiling), boxes};
}

// Adds the stretches of a wall's height that none of the holes over an interval takes.
static void add_between(const Line& line, const Span1& along, List<Cut>& over, f64 half) {
  stable_sort(over.all(), [](const Cut& a, const Cut& b) { return a.up.low < b.up.low; });
  f64 reached = 0.0;
  for (const Cut& one : over) {
    if (one.up.low > reached) line.add(along, {reached, least(one.up.low, line.height)}, {-half, half});
    reached = most(reached, one.up.high);
  }
  if (reached < line.height) line.add(along, {reached, line.height}, {-half, half});
}

// Adds a wall, cut at the sides of its holes, which come in the order in which they begin; it goes on by half its thickness at its ends.
static void add_wall(const Edge& edge, const Line& line, Span<Cut> holes, f64 half, Looks& looks) {
  const f64 start = metres(edge.start) - half, end = metres(edge.end) + half;
  List<f64> stops;
  stops.add(start);
  for (const Cut& hole : holes) {
    const f64 sides[] = {hole.along.low, hole.along.high};
    for (const f64 at : sides) {
      if (start < at && at < end) stops.add(at);
    }
  }
  stops.add(end);
  stable_sort(stops.all(), [](f64 a, f64 b) { return a < b; });
  List<Cut> over;
  i32 next = 0;
  for (i32 k = 0; k + 1 < stops.size(); k++) {
    const f64 low = stops[k], high = stops[k + 1];
    if (low == high) continue;
    while (next < holes.size && holes[next].along.low <= low) over.add(holes[next++]);
    keep_where(over, [&](const Cut& one) { return one.along.high > low; });
    if (!looks.are_left_after(STRETCH_LOOKS * over.size())) return;
    add_between(line, {low, high}, over, half);
  }
}

Span<ShellBox> shell_of(const Room& room, Looks& looks) {
  const f64 half = metres(room.half_wall);
  List<ShellBox> boxes;
  List<Cut> cuts;
  for (const Edge& edge : room.edges) {
    cuts.cut(0);
    if (!looks.are_left_after(room.openings.size)) return {};
    for (const Opening& hole : room.openings) {
      if (hole.edge.runs_east() != edge.runs_east() || hole.edge.line != edge.line) continue;
      cuts.add({{metres(hole.edge.start), metres(hole.edge.end)}, {hole.low, hole.high}});
    }
    stable_sort(cuts.all(), [](const Cut& a, const Cut& b) { return a.along.low < b.along.low; });
    add_wall(edge, line_of(edge, room, boxes), cuts.all(), half, looks);
  }
  i32 first = 0;
  for (const Opening& hole : room.openings) {
    if (hole.fitted < 0 || hole.fitted > room.fitted.size - first) fail(Failure::bad_request);
    const Line line = line_of(hole.edge, room, boxes);
    const f64 at = metres(hole.edge.start);
    for (const i32 end = first + hole.fitted; first < end; first++) {
      const FittedBox& one = room.fitted[first];
      line.add({at + one.start, at + one.end}, {one.low, one.high}, {one.near, one.far});
    }
  }
  return boxes.all();
}

}  // namespace validate
