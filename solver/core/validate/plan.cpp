// What is wrong with a plan.
#include "validate/plan.hpp"

namespace validate {

static Rect bounds_of(const Placed& placed) { return moved(placed.room.bounds, placed.x, placed.z); }

Plan::Plan(const Storey& storey, Looks& looks) : storey_(storey) {
  List<i32> ranked, open;
  for (i32 i = 0; i < storey.rooms.size; i++) {
    ranked.add(i);
    const Placed& placed = storey.rooms[i];
    for (const Edge& own : placed.room.edges) {
      if (own.side < 0 || own.side > 3) fail(Failure::bad_request);
      const Edge edge = own.moved(placed.x, placed.z);
      walls_[edge.side].add({edge.line, edge.start, edge.end, i});
    }
  }
  for (List<HouseWall>& walls : walls_) stable_sort(walls.all(), [](const HouseWall& a, const HouseWall& b) { return a.line < b.line; });
  stable_sort(ranked.all(), [&](i32 a, i32 b) { return bounds_of(storey.rooms[a]).x0 < bounds_of(storey.rooms[b]).x0; });
  for (const i32 room : ranked) {
    const Rect own = bounds_of(storey.rooms[room]);
    if (!looks.are_left_after(open.size())) return;
    keep_where(open, [&](i32 one) { return bounds_of(storey.rooms[one]).x1 > own.x0; });
    for (const i32 one : open) {
      if (bounds_of(storey.rooms[one]).overlaps(own)) pairs_.add({least(one, room), most(one, room)});
    }
    open.add(room);
  }
  stable_sort(pairs_.all(), [](const Pair& a, const Pair& b) { return a.first != b.first ? a.first < b.first : a.later < b.later; });
}

// How much of an interval none of some parts covers.
static i64 uncovered(i64 start, i64 end, List<Interval>& parts) {
  for (const Interval& part : parts) {
    if (part.low <= start && end <= part.high) return 0;  // as nearly always
  }
  stable_sort(parts.all(), begins_before);
  i64 missing = 0, at = start;
  for (const Interval& part : parts) {
    if (part.high <= at || part.low >= end) continue;
    missing += most<i64>(part.low - at, 0);
    at = least(part.high, end);
  }
  return missing + end - at;
}

// The largest extents, less a wall's, that a box of one room and one of another have in common.
static Extent shared_floor(const Placed& one, const Placed& other, i64 wall) {
  Extent best{0, 0};
  bool is_any = false;
  for (const Rect& a : one.room.inside) {
    for (const Rect& b : other.room.inside) {
      const Extent both = shared(moved(a, one.x, one.z), moved(b, other.x, other.z));
      const Extent less{both.x - wall, both.z - wall};
      if (!is_any || least(less.x, less.z) > least(best.x, best.z)) best = less;
      is_any = true;
    }
  }
  return best;
}

void Plan::find_overlaps(i32 room, Looks& looks, Findings& found) const {
  i32 at = count_before(pairs_.all(), [&](const Pair& pair) { return pair.first < room; });
  for (; at < pairs_.size() && pairs_[at].first == room; at++) {
    const i32 later = pairs_[at].later;
    const Placed &one = storey_.rooms[room], &other = storey_.rooms[later];
    if (!looks.are_left_after(static_cast<i64>(one.room.inside.size) * other.room.inside.size)) return;
    const Extent both = shared_floor(one, other, 2 * storey_.half_wall);
    const i64 amount = least(both.x, both.z);
    if (amount > 0) tell(found, Rule::rooms_overlap, -1, later, amount, both.x, both.z);
  }
}

// Other rooms' walls that are an opening's other side, for a part of its width or for all.
List<HouseWall> Plan::beyond(i32 room, const Edge& cut, Looks& looks) const {
  const i64 deepest = storey_.deepest_wall;
  const i64 first = cut.looks_ahead() ? cut.line - deepest : cut.line, last = cut.looks_ahead() ? cut.line : cut.line + deepest;
  const List<HouseWall>& walls = walls_[static_cast<i32>(opposite(static_cast<Wall>(cut.side)))];
  i32 at = count_before(walls.all(), [&](const HouseWall& wall) { return wall.line < first; });
  List<HouseWall> found;
  for (; at < walls.size() && walls[at].line <= last && looks.are_left_after(1); at++) {
    const HouseWall& wall = walls[at];
    if (wall.start < cut.end && cut.start < wall.end && wall.room != room) found.add(wall);
  }
  return found;
}

static bool says(Finding& wrong, Wrong how, i64 amount, i64 other = -1) {
  wrong.how = static_cast<i64>(how), wrong.amount = amount, wrong.other = other;
  return true;
}

// Of an opening to the outside: no room lies behind it, but outdoors. Of one to a room: that room's wall lies behind all of it.
bool Plan::leads_elsewhere(i32 room, Finding& wrong, Looks& looks) const {
  const Placed& placed = storey_.rooms[room];
  const Opening& own = placed.room.openings[wrong.body];
  if (own.to == static_cast<i32>(Leads::nowhere)) return says(wrong, Wrong::leads_nowhere, 0);
  const bool is_outside = own.to == static_cast<i32>(Leads::outside);
  if ((own.to < 0 && !is_outside) || (is_outside && placed.room.is_outdoor)) return false;
  const Edge cut = own.edge.moved(placed.x, placed.z);
  i32 behind = is_outside ? -1 : own.to;
  List<Interval> walls;
  for (const HouseWall& wall : beyond(room, cut, looks)) {
    if (behind < 0 && !storey_.rooms[wall.room].room.is_outdoor) behind = wall.room;
    if (wall.room == behind) walls.add({wall.start, wall.end});
  }
  if (behind < 0) return false;
  const i64 missing = uncovered(cut.start, cut.end, walls);
  if (is_outside) return says(wrong, Wrong::faces_room, cut.end - cut.start - missing, behind);
  return missing > 0 && says(wrong, Wrong::misses_room, missing, behind);
}

// Of an opening: none of those listed before it in the same line of wall is in its way.
bool Plan::meets_another(i32 room, Finding& wrong, Looks& looks) const {
  const Span<Opening>& all = storey_.rooms[room].room.openings;
  const Opening& own = all[wrong.body];
  for (i32 k = 0; k < wrong.body && looks.are_left_after(1); k++) {
    const Opening& other = all[k];
    if (other.edge.side != own.edge.side || other.edge.line != own.edge.line) continue;
    const bool are_apart = most(own.edge.start - other.edge.end, other.edge.start - own.edge.end) >= 0;
    if (are_apart || other.top <= own.sill || other.sill >= own.top) continue;
    return says(wrong, Wrong::meets, least(own.edge.end, other.edge.end) - most(own.edge.start, other.edge.start), k);
  }
  return false;
}

bool Plan::finds_wrong(i32 room, Finding& wrong, Looks& looks) const {
  const Room& own = storey_.rooms[room].room;
  const Opening& one = own.openings[wrong.body];
  List<Interval> parts;
  for (const Edge& edge : own.edges) {
    if (edge.side == one.edge.side && edge.line == one.edge.line) parts.add({edge.start, edge.end});
  }
  const i64 over = uncovered(one.edge.start, one.edge.end, parts), above = one.top - own.ceiling;
  if (over > 0) return says(wrong, Wrong::leaves_wall, over);
  if (leads_elsewhere(room, wrong, looks) || meets_another(room, wrong, looks)) return true;
  // one above a sill that has the height of those that say none may have been meant lower
  const bool is_sure = one.sill <= 0 || one.says_height() || one.sill >= own.ceiling;
  return above > 0 && is_sure && says(wrong, Wrong::reaches_above, above);
}

void Plan::find(i32 room, Looks& looks, Findings& found) const {
  find_overlaps(room, looks, found);
  for (i32 k = 0; k < storey_.rooms[room].room.own && looks.are_left_after(storey_.rooms[room].room.edges.size); k++) {
    Finding wrong{static_cast<i64>(Rule::opening_wrong), k, -1, 0, 0, 0, 0, 0};
    const arena::Mark mark = arena::mark();
    const bool is_wrong = finds_wrong(room, wrong, looks);
    arena::release(mark);
    if (is_wrong && !found.is_full()) found.rows.add(wrong);
  }
}

}  // namespace validate
