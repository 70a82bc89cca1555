#include "placement/making.hpp"

#include "placement/grid.hpp"
#include "placement/options.hpp"
#include "plain/intervals.hpp"

namespace placement {

constexpr i64 MARGIN_MM = 2;  // rounding to millimetres moves each of two bodies by less than one
constexpr i64 NEAR_WALL_MM = 150;  // a companion whose back is this close to its parent's wall counts as standing at it

static Rect clear_of(const Room& room) { return {room.space->low[0], room.space->low[1], room.space->high[0], room.space->high[1]}; }

void Making::make() {
  whole_ = arranged(room_);
  if (!is_found()) {
    made_.failed = 1;
    return;
  }
  made_.optimal = engine().nodes.result->exhausted;
  made_.solves = whole_.solves;
  problem_ = final_problem(desk());
  const bool walk = whole_.walk || is_walkable_as_found();
  Settled settled = placement::settle(desk(), walk, asked_.tidy != 0);
  WholeRoom wider;
  if (walk && settled == Settled::not_walkable && is_found_for_wider(wider)) {
    whole_ = wider;
    made_.widened = 1;
    settled = placement::settle(desk(), true, asked_.tidy != 0);
  }
  if (walk && settled == Settled::not_walkable && whole_.ways != 0) {  // what is left is not quite so wide
    engine().room.space->ways = 0;
    settled = placement::settle(desk(), true, asked_.tidy != 0);
  }
  conclude(walk, settled);
}

void Making::tell(Desk& desk, bool walk) {
  whole_.desk = &desk;
  whole_.asked = numbered(room_);
  whole_.complete = whole_.best = true;
  whole_.proven = engine().nodes.result->exhausted != 0;
  made_.solves = engine().nodes.result->solves;
  const bool walked = walk || is_walkable_as_found();
  conclude(walked, placement::settle(desk, walked, asked_.tidy != 0));
}

WholeRoom Making::arranged(const Room& room) {
  if (asked_.wide != 0) return arrange_wide(room, asked_.limits, asked_.budget, made_.spent);
  f64 left = asked_.budget;
  const WholeRoom found = arrange_whole(room, asked_.limits, left, asked_.walk != 0);
  made_.spent += asked_.budget - left;
  return found;
}

// The room for a person of that width, with ways between its doors of another width.
Room Making::for_person(i64 robot, i64 ways) const {
  Room room = room_;
  room.space.data = reserved<SpaceRow>(1).data;
  *room.space.data = *room_.space.data;
  room.space->robot = robot;
  room.space->ways = ways;
  room.doors = doors_of(*room.space.data, doorways_);
  return room;
}

// Finds a room for a somewhat wider person: as it was found, else anew.
bool Making::is_found_for_wider(WholeRoom& wider) {
  const i64 robot = room_.space->robot + MARGIN_MM, ways = whole_.ways ? whole_.ways + MARGIN_MM : 0;
  if (arrange_again(for_person(robot, ways), whole_, asked_.limits.final_qps, wider)) return true;
  wider = arranged(for_person(robot, 0));
  wider.proven = wider.best = false;
  return wider.walk && wider.desk->engine.nodes.result->found;
}

// Tells whether what was found, rounded to millimetres, is walkable.
bool Making::is_walkable_as_found() const {
  const Table<i64>& p = engine().grid.positions;
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < engine().work.sizes[axis]; v++) p.at(axis, v) = ::whole(floor(engine().nodes.best.at(axis, v) * 1000 + 0.5));
  }
  return walkable(engine().room, engine().work, engine().grid, p);
}

void Making::conclude(bool walk, Settled settled) {
  made_.failed = settled == Settled::no_whole_place || settled == Settled::not_valid;
  made_.walked = walk;
  made_.walkable = settled == Settled::walkable;
  made_.proven = whole_.proven;
  made_.best = whole_.best;
  made_.cost = engine().nodes.best_cost[0] + total_preference(engine().room, desk().decisions);
  made_.added = desk().added[0];
  if (made_.failed) return;
  add_placed();
  add_left_out();
}

void Making::add_placed() {
  const Room& room = engine().room;
  for (i32 k = 0; k < room.pieces.size; k++) {
    const i64 decision = desk().decisions[k];
    if (decision == ABSENT || room.pieces[k].empty != 0) continue;
    const Part& body = engine().work.parts[engine().work.body_part[k]];
    PlacedRow row = {};
    row.piece = whole_.asked.pieces[k];
    row.candidate = whole_.asked.candidates[candidate_of(decision)];
    row.rotation = engine().work.rotation[k];
    const Table<i64>& p = engine().grid.positions;
    row.footprint.x0 = p.at(0, body.variable[0]) + body.offset[0];
    row.footprint.z0 = p.at(1, body.variable[1]) + body.offset[1];
    row.footprint.x1 = row.footprint.x0 + body.extent[0];
    row.footprint.z1 = row.footprint.z0 + body.extent[1];
    row.wall = wall_of(row);
    placed_.add(row);
  }
}

// The wall that a piece stands at: its own, or that of the piece at whose slot it has its back to it, too.
::Wall Making::wall_of(const PlacedRow& row) const {
  const CandidateRow& way = room_.candidates[row.candidate];
  const ::Wall own = static_cast<::Wall>(way.wall);
  if (own != ::Wall::none || way.parent < 0 || way.bottom != 0) return own;
  const ::Wall behind = wall_behind(row.rotation);
  for (const PlacedRow& other : placed_) {
    if (other.piece == way.parent && other.wall == behind) {
      return row.footprint.wall_distance(behind, clear_of(room_)) <= NEAR_WALL_MM ? behind : ::Wall::none;
    }
  }
  return ::Wall::none;
}

void Making::add_left_out() {
  for (i32 k = 0; k < room_.pieces.size; k++) {
    if (room_.pieces[k].required < 0) add_left(k, static_cast<Fate>(-room_.pieces[k].required));
  }
  for (const LeftOut& one : whole_.left_out) {
    if (room_.pieces[one.piece].empty == 0) add_left(one.piece, one.certain ? CANNOT_STAND : NOT_FOUND);
  }
  const Room& room = engine().room;
  for (i32 k = 0; k < room.pieces.size; k++) {
    if (desk().decisions[k] != ABSENT || room.pieces[k].empty != 0) continue;
    add_left(whole_.asked.pieces[k], whole_.complete ? static_cast<Fate>(desk().fates[k]) : SPENT);
  }
}

// Tells whether a way to stand is smaller than another one: by its footprint, then by width, depth, height.
static bool is_smaller(const CandidateRow& a, const CandidateRow& b) {
  if (a.width * a.depth != b.width * b.depth) return a.width * a.depth < b.width * b.depth;
  if (a.width != b.width) return a.width < b.width;
  return a.depth != b.depth ? a.depth < b.depth : a.height < b.height;
}

void Making::add_left(i64 piece, Fate fate) {
  const PieceRow& own = room_.pieces[piece];
  LeftOutRow row = {};
  row.piece = piece;
  row.fate = fate;
  row.skip_cost = room_.skip_costs[piece];
  row.parent = row.kind = -1;
  const CandidateRow* smallest = nullptr;
  bool at_parents = true;  // at one in all ways: else it may stand elsewhere, too
  for (i64 k = own.candidates[0]; k < own.candidates[1]; k++) {
    const CandidateRow& way = room_.candidates[k];
    if (smallest == nullptr || is_smaller(way, *smallest)) smallest = &way;
    row.at_walls |= way.wall != NO_WALL;
    at_parents &= way.parent >= 0;
  }
  if (smallest != nullptr) {
    if (at_parents) row.parent = smallest->parent;
    row.kind = smallest->kind, row.width = smallest->width, row.depth = smallest->depth;
    for (i32 k = 0; k < 4; k++) row.free[k] = longest_free(WALLS[k], smallest->depth, smallest->height);
  }
  left_out_.add(row);
}

// The longest interval along a wall where a body of that depth and height meets no zone and no piece.
i64 Making::longest_free(::Wall wall, i64 depth, i64 height) const {
  const Rect clear = clear_of(room_);
  const Interval all = clear.along(wall);
  const Rect band = strip(clear, wall, all, least(depth + room_.space->gap, least(clear.depth(), clear.width())));
  List<Interval> blocked;
  for (i32 k = 0; k < room_.zones.size; k++) {
    const Zone& zone = room_.zones[k];
    const Rect rect = {zone.low[0], zone.low[1], zone.high[0], zone.high[1]};
    if (height > zone.above && rect.overlaps(band)) blocked.add(rect.along(wall));
  }
  for (const PlacedRow& one : placed_) {
    if (room_.candidates[one.candidate].bottom < height && one.footprint.overlaps(band)) blocked.add(one.footprint.along(wall));
  }
  i64 longest = 0;
  for (const Interval& free : ::gaps_between(all, blocked.all())) longest = most(longest, free.high - free.low);
  return longest;
}

static Span<const i64> numbers_of(const FinalProblem* problem) {
  return {reinterpret_cast<const i64*>(problem), problem == nullptr ? 0 : static_cast<i32>(problem->size)};
}

i64 Making::size() const {
  return static_cast<i64>(sizeof(MadeRoom)) + bytes_of(placed_.all()) + bytes_of(left_out_.all()) + bytes_of(numbers_of(problem_));
}

void Making::put(Writer& writer) const {
  const Span<const i64> problem = numbers_of(problem_);
  MadeRoom made = made_;
  made.placed = placed_.size();
  made.left_out = left_out_.size();
  made.problem = problem.size;
  writer.put(Span<MadeRoom>{&made, 1});
  writer.put(placed_.all());
  writer.put(left_out_.all());
  writer.put(problem);
}

}  // namespace placement
