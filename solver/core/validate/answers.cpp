// Rooms and storeys as bytes -> the rows that are said of them.
#include "validate/validate.hpp"

#include "validate/plan.hpp"
#include "validate/walk.hpp"

namespace validate {

// Areas of a room: between its wall lines, clear of walls, that without what bodies cover, all without what furniture on the floor covers.
struct MeasuredRoom {
  Area all, clear, uncovered, unfurnished;
};

static Area free_area(Span<Rect> floors, const List<Rect>& obstacles, i32 most_boxes) {
  arena::Scope scope;
  Area area;
  for (const Grid& tile : tiles_of(floors, obstacles.all(), most_boxes)) {
    for (i32 i = 0; i < tile.cells.rows; i++) {
      i64 deep = 0;
      for (i32 k = 0; k < tile.cells.columns; k++) deep += tile.cells.at(i, k) ? tile.depth(k) : 0;
      area.add_product(tile.width(i), deep);
    }
  }
  return area;
}

// What is said of a storey's floor, and of a room that was judged.
struct WalkedFloor {
  i64 tiles, cells, is_entered, judged, looks;
};
struct Judged {
  i64 findings, of_plan, opened;
};

static WalkedFloor floor_of(const Walk& walk) {
  WalkedFloor floor{walk.tiles.size(), 0, 0, 0, 0};
  for (const Grid& tile : walk.tiles) floor.cells += static_cast<i64>(tile.cells.rows) * tile.cells.columns;
  for (const bool one : walk.entered) floor.is_entered |= one;
  return floor;
}

namespace {

// What is found in the rooms that are judged.
struct Told {
  List<Judged> judged;
  Findings found, of_plan;
  List<Opened> opened;
  Looks looks;

  bool is_too_much() const { return found.is_full() || of_plan.is_full() || looks.done > looks.most; }
};

}  // namespace

// Judges the rooms asked for, each in turn, until too much is found.
static void judge(const Storey& storey, Bytes asked, Told& told) {
  if (asked.size == 0) return;
  const Plan plan(storey, told.looks);
  for (Reader reader(asked); !reader.is_at_end();) {
    const i64 number = reader.take<i64>(1)[0];
    if (number < 0 || number >= storey.rooms.size) fail(Failure::bad_request);
    const Room& room = storey.rooms[static_cast<i32>(number)].room;
    const Judged before{told.found.rows.size(), told.of_plan.rows.size(), told.opened.size()};
    find_standing(room, told.found);
    find_above_ceiling(room, told.found);
    find_floating(room, told.found);
    find_crossing(room, told.found);
    if (!told.is_too_much()) plan.find(static_cast<i32>(number), told.looks, told.of_plan);
    if (!told.is_too_much()) find_opened(room, told.looks, told.opened);
    const i64 findings = told.found.rows.size() - before.findings, of_plan = told.of_plan.rows.size() - before.of_plan;
    told.judged.add({findings, of_plan, told.opened.size() - before.opened});
    if (told.is_too_much()) return;
  }
}

Bytes judge_storey(Bytes rows_sent, Bytes asked, i64 most, i64 most_looks) {
  Reader reader(rows_sent);
  const Storey storey = read_storey(reader);
  Told found{{}, {most, {}}, {most, {}}, {}, {most_looks, 0}};
  judge(storey, asked, found);
  const Walk walk = walk_of(storey);
  WalkedFloor floor = floor_of(walk);
  floor.judged = found.judged.size(), floor.looks = found.looks.done;
  List<WalkedRoom> areas;
  List<u8> sides;
  for (const Placed& placed : storey.rooms) {
    const Walk here = near(walk, storey, placed);
    areas.add(walked_floor(storey, here, placed));
    for (const Body& body : placed.room.bodies) sides.add(missed_sides(storey, here, placed, body));
  }
  List<u8> told;
  const auto tell_all = [&](Bytes rows) { told.add_all({rows.data, static_cast<i32>(rows.size)}); };
  tell_all(as_bytes(Span<WalkedFloor>{&floor, 1}));
  tell_all(as_bytes(areas.all()));
  tell_all(as_bytes(found.judged.all()));
  tell_all(as_bytes(found.found.rows.all()));
  tell_all(as_bytes(found.of_plan.rows.all()));
  tell_all(as_bytes(found.opened.all()));
  tell_all(as_bytes(sides.all()));
  return as_bytes(told.all());
}

// Adds what the openings of some kind keep free of a room's floor.
static void add_kept(const Room& room, bool of_windows, List<Rect>& found) {
  for (i32 k = 0; k < room.openings.size; k++) {
    const Zone zone = zone_of(room, k);
    const bool is_any = zone.box.width() > 0 || zone.box.depth() > 0;
    if (is_any && (room.openings[k].kind == OpeningKind::window) == of_windows) found.add(zone.box);
  }
}

Bytes free_floors(Bytes rows_sent) {
  Reader reader(rows_sent);
  const Storey storey = read_storey(reader);
  const Walk walk = walk_of(storey);
  List<Rect> found;
  List<i64> rows;
  for (const Placed& placed : storey.rooms) {
    const i32 before = found.size();
    find_swept_floor(storey, walk, placed, found);
    const i32 swept = found.size();
    add_kept(placed.room, false, found);
    const i32 doors = found.size();
    add_kept(placed.room, true, found);
    rows.add(swept - before), rows.add(doors - swept), rows.add(found.size() - doors);
  }
  for (const Rect& box : found) rows.add(box.x0), rows.add(box.z0), rows.add(box.x1), rows.add(box.z1);
  return as_bytes(rows.all());
}

Bytes measure_storey(Bytes rows_sent) {
  Reader reader(rows_sent);
  const Storey storey = read_storey(reader);
  const Span<MeasuredRoom> rows = reserved<MeasuredRoom>(storey.rooms.size);
  const i64 half = storey.half_wall;
  for (i32 i = 0; i < rows.size; i++) {
    const Room& room = storey.rooms[i].room;
    List<Rect> nothing, walls, covered, furniture;
    for (const Edge& edge : room.edges) walls.add(edge.strip(edge.start - half, edge.end + half, half, half));
    covered.add_all(walls.all());
    for (const Body& body : room.bodies) {
      if (body.is_solid && body.low() < HEADROOM) covered.add(body.box);
      if (body.is_solid && body.is(Sort::furniture) && body.low() <= 0) furniture.add(body.box);
    }
    const auto area = [&](const List<Rect>& taken) { return free_area(room.inside, taken, storey.most_boxes); };
    rows[i] = {area(nothing), area(walls), area(covered), area(furniture)};
  }
  return as_bytes(rows);
}
}  // namespace validate
