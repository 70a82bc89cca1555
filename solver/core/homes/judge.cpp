#include "homes/judge.hpp"

#include "plain/lists.hpp"

namespace homes {

namespace {

// A room outside its limits of area, width or aspect; a hallway less than two thirds longer than it is wide, where who only just fits has
// nowhere to go.
constexpr f64 SHORT = 20.0;
// A room that can only be entered through one that should not be walked through; an own bathroom away from its bedroom.
constexpr f64 UNREACHED = 30.0;
// A garage or an entry away from the street.
constexpr f64 STREETLESS = 30.0;
// A bedroom that can only be entered from the entrance room.
constexpr f64 AT_ENTRANCE = 6.0;
// Another room than a bedroom or a bathroom that only the entrance room leads to.
constexpr f64 OFF_ENTRY = 0.7;
// A bathroom that only rooms one lives in lead to.
constexpr f64 OFF_LIVING = 4.0;
// A bedroom, of several, from which one walks through a room one lives in to every bathroom; to the entrance.
constexpr f64 BATHROOM_AFAR = 4.0;
constexpr f64 PAST_LIVING = 2.0;
// A wet room without a wet neighbour.
constexpr f64 DRY = 4.0;
// A kitchen away from the dining room, or from the living room where there is none.
constexpr f64 KITCHEN_APART = 2.5;
// A living room away from the entry, a dining room away from the living room.
constexpr f64 LIVING_APART = 1.5;
// A room one lives in, or a hallway, that only the kitchen leads to: each more door leaves a kitchen less wall for its worktop.
constexpr f64 KITCHEN_BETWEEN = 3.0;
// A bedroom or a bathroom that only the kitchen leads to.
constexpr f64 PAST_KITCHEN = 5.0;
// The largest bedroom has no bathroom of its own, and another has.
constexpr f64 SMALL_SUITE = 4.0;
// Least outside wall that lights a habitable room: a window of 1.2 m and 0.3 m of wall at each end.
constexpr i64 LIT_MM = 1800;
// Of an outline's width over depth, for every unit beyond what costs nothing.
constexpr f64 OUTLINE_COST = 5.0;
// Hallway over floor that costs nothing; beyond, HALLWAY_COST for all of the floor.
constexpr f64 HALLWAY_SHARE = 0.08;
constexpr f64 HALLWAY_COST = 32.0;
// Of the squared deviation of a room's area from what is typical, over what is typical.
constexpr f64 AREA_COST = 1.5;

constexpr u64 lowest(u64 bits) { return bits & (0 - bits); }
i32 place_of_lowest(u64 bits) { return __builtin_ctzll(bits); }
i64 area(const Rect& box) { return box.width() * box.depth(); }
f64 ratio(i64 a, i64 b) { return static_cast<f64>(a) / static_cast<f64>(b); }

}  // namespace

Judge::Judge(Span<const PlannedRoom> rooms, Taste taste, i64 door_wall) : rooms_(rooms), taste_(taste), door_wall_(door_wall) {
  for (i32 i = 0; i < rooms.size; i++) {
    const PlannedRoom& room = rooms[i];
    const u64 bit = 1ULL << i;
    if (room.has(WAY_THROUGH)) ways_ |= bit;
    if (room.has(WET)) wet_ |= bit;
    if (room.entry()) entry_ |= bit;
    if (room.living() && room.has(WET)) kitchen_ |= bit;
    if (room.living() && room.has(DINING)) dining_ |= bit;
    if (!room.has(WAY_THROUGH) && !room.owned()) leaves_ |= bit;
    if (room.has(BED)) beds_ |= bit;
    if (room.owned()) suites_ |= 1ULL << room.owner;
    if (room.has(TOILET)) toilets_ |= bit;
  }
  living_ = ways_ & ~entry_ & ~kitchen_ & ~dining_;
}

HomeVerdict Judge::verdict(const Sheet& sheet) {
  HomeVerdict found = {};
  const f64 sized = sizes(sheet, found.short_rooms);
  look(sheet);
  const Ways ways = access(sheet);
  found.unreached = ways.unreached;
  for (i32 i = 0; i < rooms_.size; i++) {
    const PlannedRoom& room = rooms_[i];
    if (room.has(GARAGE) || room.entry()) found.streetless += covers_[i][static_cast<i32>(Wall::south)] > 0;
    if (room.has(HABITABLE)) found.dark += !is_lit(sheet.boxes[i], i);
  }
  const f64 walked = UNREACHED * ways.unreached + AT_ENTRANCE * ways.at_entrance + OFF_ENTRY * ways.others + OFF_LIVING * ways.off_living +
                     BATHROOM_AFAR * ways.bathless + PAST_LIVING * ways.past_living + STREETLESS * found.streetless +
                     KITCHEN_BETWEEN * ways.between + PAST_KITCHEN * ways.past_kitchen;
  found.cost = sized + (outline(sheet) + taste_.dark * found.dark) + company() + smallness(sheet) + walked;
  return found;
}

// Finds every stretch of wall that two rooms share.
void Judge::look(const Sheet& sheet) {
  const Span<const Rect> boxes = sheet.all();
  for (i32 i = 0; i < boxes.size; i++) beside_[i] = 0;
  for (i32 i = 0; i < rooms_.size; i++) {
    for (i32& count : covers_[i]) count = 0;
  }
  for (i32 i = 0; i < boxes.size; i++) {
    for (i32 j = 0; j < boxes.size; j++) {
      const Rect &one = boxes.data[i], &other = boxes.data[j];
      if (one.z1 == other.z0) meet(i, j, Wall::south, {most(one.x0, other.x0), least(one.x1, other.x1)});
      if (one.x1 == other.x0) meet(i, j, Wall::east, {most(one.z0, other.z0), least(one.z1, other.z1)});
    }
  }
}

// Notes a stretch of a wall of i that j lies at, if there is one.
void Judge::meet(i32 i, i32 j, Wall wall, Interval shared) {
  if (shared.low >= shared.high) return;
  if (shared.high - shared.low >= door_wall_) {
    beside_[i] |= 1ULL << j;
    beside_[j] |= 1ULL << i;
  }
  const i32 near = static_cast<i32>(wall), far = static_cast<i32>(opposite(wall));
  if (i < rooms_.size) covered_[i][near][covers_[i][near]++] = shared;
  if (j < rooms_.size) covered_[j][far][covers_[j][far]++] = shared;
}

f64 Judge::sizes(const Sheet& sheet, i64& short_rooms) const {
  f64 cost = 0.0;
  for (i32 i = 0; i < rooms_.size; i++) {
    const RoomSize& size = rooms_[i].size;
    const Rect& box = sheet.boxes[i];
    const i64 floor = area(box), low = least(box.width(), box.depth()), high = most(box.width(), box.depth());
    const f64 stray = ratio(floor, size.typical) - 1.0;
    cost += AREA_COST * stray * stray;
    if (floor < size.least || floor > size.most || low < size.width || static_cast<f64>(high) > size.aspect * static_cast<f64>(low)) {
      short_rooms++;
      const f64 missed = most(ratio(size.least, most<i64>(floor, 1)), ratio(floor, size.most));
      cost += SHORT * (1.0 + most(missed, ratio(size.width, most<i64>(low, 1))) - 1.0);
    }
  }
  for (i32 i = 0; i < sheet.hallways; i++) {
    const Rect& box = sheet.boxes[sheet.rooms + i];
    if (3 * most(box.width(), box.depth()) >= 5 * least(box.width(), box.depth())) continue;
    short_rooms++;
    cost += SHORT;
  }
  return cost;
}

f64 Judge::outline(const Sheet& sheet) const {
  const f64 wide = ratio(sheet.width, sheet.depth);
  f64 cost = OUTLINE_COST * most(most(taste_.low - wide, wide - taste_.high), 0.0);
  i64 walked = 0, floor = 0;
  for (i32 i = 0; i < sheet.hallways; i++) walked += area(sheet.boxes[sheet.rooms + i]);
  if (walked) {
    for (const Rect& box : sheet.all()) floor += area(box);
    cost += HALLWAY_COST * most(ratio(walked, floor) - HALLWAY_SHARE, 0.0);
  }
  return cost;
}

f64 Judge::company() const {
  f64 cost = 0.0;
  for (i32 i = 0; i < rooms_.size; i++) {
    if (wet_ >> i & 1 && !(beside_[i] & wet_)) cost += DRY;
  }
  for (i32 i = 0; i < rooms_.size; i++) {
    const u64 bit = 1ULL << i;
    if (bit & kitchen_ && !(beside_[i] & (dining_ ? dining_ : living_))) {
      cost += KITCHEN_APART;
    } else if (bit & dining_ && (kitchen_ | living_)) {
      cost += LIVING_APART * !(beside_[i] & living_);
    } else if (bit & living_ && entry_) {
      cost += LIVING_APART * !(beside_[i] & (entry_ | living_));
    }
  }
  return cost;
}

// What it costs that no bedroom with a bathroom of its own is as large as every other bedroom.
f64 Judge::smallness(const Sheet& sheet) const {
  i64 suite = 0, other = 0;
  for (i32 i = 0; i < rooms_.size; i++) {
    if (!(beds_ >> i & 1)) continue;
    i64& largest = suites_ >> i & 1 ? suite : other;
    largest = most(largest, area(sheet.boxes[i]));
  }
  return suite && suite < other ? SMALL_SUITE : 0.0;
}

// Counts rooms that no way leads to, bedrooms and others that only the entrance room leads to, bathrooms that only rooms one lives in lead
// to, private ones that only the kitchen leads to, bedrooms past such rooms; tells of a kitchen between.
Judge::Ways Judge::access(const Sheet& sheet) const {
  const u64 hall = (1ULL << (rooms_.size + sheet.hallways)) - (1ULL << rooms_.size);
  const u64 ways = ways_ | hall;
  const u64 start = entry_ ? lowest(entry_) : living_ ? lowest(living_) : hall ? lowest(hall) : 1;
  const u64 found = reached(ways, start), past = found & ~kitchen_, around = kitchen_ ? reached(past, start) : found;
  const u64 passages = entry_ | hall, washed = reached(passages, beside_of(toilets_ & leaves_) & passages), met = reached(passages, start);
  const u64 guarded = beds_ & (beds_ - 1) ? beds_ : 0;
  Ways counted = {__builtin_popcountll(ways & ~found), 0, 0, 0, 0, 0, 0, (past & ~around) != 0};
  for (i32 i = 0; i < rooms_.size; i++) {
    if (rooms_[i].owned()) counted.unreached += !(beside_[i] >> rooms_[i].owner & 1);
    if (!(leaves_ >> i & 1)) continue;
    const u64 doors = beside_[i] & found;
    const bool bed = beds_ >> i & 1, toilet = toilets_ >> i & 1;
    counted.bathless += (guarded & ~suites_) >> i & 1 && !(doors & washed);
    counted.past_living += guarded >> i & 1 && !(doors & met);
    if (!doors) {
      counted.unreached += !is_behind(i, found);
    } else if (doors == start && !toilet) {
      (bed ? counted.at_entrance : counted.others)++;
    } else if (bed || toilet) {
      counted.past_kitchen += !(doors & around);
      counted.off_living += toilet && !(doors & (entry_ | hall));
    }
  }
  return counted;
}

// The rooms beside any of some.
u64 Judge::beside_of(u64 rooms) const {
  u64 found = 0;
  for (u64 left = rooms; left; left &= left - 1) found |= beside_[place_of_lowest(left)];
  return found;
}

// The rooms that a way through rooms leads to.
u64 Judge::reached(u64 ways, u64 start) const {
  u64 found = start, fresh = start;
  while (fresh) {
    const i32 room = place_of_lowest(fresh);
    fresh &= fresh - 1;
    const u64 more = beside_[room] & ways & ~found;
    found |= more;
    fresh |= more;
  }
  return found;
}

// Tells whether a garage can be entered through a laundry that is reached itself.
bool Judge::is_behind(i32 room, u64 reached) const {
  const u64 through = rooms_[room].through & beside_[room];
  for (u64 left = through & leaves_; left; left &= left - 1) {
    if (beside_[place_of_lowest(left)] & reached) return true;
  }
  return false;
}

// Tells whether a window fits in a stretch of a room's walls that lies outside.
bool Judge::is_lit(const Rect& box, i32 room) const {
  for (const i32 count : covers_[room]) {
    if (count == 0) return true;
  }
  for (const Wall wall : WALLS) {
    const i32 at = static_cast<i32>(wall);
    const Interval whole = box.along(wall);
    Interval stretches[2 * MOST_ROOMS];
    const Span<Interval> sorted = {stretches, covers_[room][at]};
    for (i32 i = 0; i < sorted.size; i++) stretches[i] = covered_[room][at][i];
    stable_sort(sorted, [](const Interval& a, const Interval& b) { return a.low < b.low; });
    i64 from = whole.low;
    for (const Interval& stretch : sorted) {
      if (least(stretch.low, whole.high) - from >= LIT_MM) return true;
      from = most(from, stretch.high);
    }
    if (whole.high - from >= LIT_MM) return true;
  }
  return false;
}

}  // namespace homes
