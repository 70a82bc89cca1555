// Rooms and storeys as bytes -> the rows that are said of them.
#include "validate/validate.hpp"

#include "validate/walk.hpp"

namespace validate {

// Areas of a room: between its wall lines, clear of walls, that without what bodies cover, all without what furniture on the floor covers.
struct MeasuredRoom {
  Area all, clear, uncovered, unfurnished;
};

template <class T> static Bytes bytes_of(Span<T> rows) {
  return {reinterpret_cast<u8*>(rows.data), static_cast<i64>(rows.size) * static_cast<i64>(sizeof(T))};
}

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
  i64 tiles, cells, is_entered, judged;
};
struct Judged {
  i64 findings, opened;
};

static WalkedFloor floor_of(const Walk& walk) {
  WalkedFloor floor{walk.tiles.size(), 0, 0, 0};
  for (const Grid& tile : walk.tiles) floor.cells += static_cast<i64>(tile.cells.rows) * tile.cells.columns;
  for (const bool one : walk.entered) floor.is_entered |= one;
  return floor;
}

// Which sides of a body can be come to, as bits.
static u8 touched_sides(const Storey& storey, const Walk& walk, const Placed& placed, const Body& body) {
  u8 sides = 0;
  for (i32 k = 0; k < 4 && body.is(Sort::furniture); k++) {
    if (touches(walk, moved(body.box, placed.x, placed.z), WALLS[k], storey.reach)) sides |= 1 << k;
  }
  return sides;
}

// Judges the rooms asked for, each in turn, until too much is found.
static void judge(const Storey& storey, Bytes asked, List<Judged>& judged, Findings& found, List<Opened>& opened) {
  for (Reader reader(asked); !reader.is_at_end();) {
    const AskedRow& own = reader.take<AskedRow>(1)[0];
    if (own.room < 0 || own.room >= storey.rooms.size) fail(Failure::bad_request);
    const Room& room = storey.rooms[static_cast<i32>(own.room)].room;
    const Judged before{found.rows.size(), opened.size()};
    find_standing(room, found);
    find_above_ceiling(room, found);
    find_floating(room, found);
    find_crossing(room, found);
    if (!found.is_full()) find_opened(room, own, reader, opened);
    judged.add({found.rows.size() - before.findings, opened.size() - before.opened});
    if (found.is_full()) return;
  }
}

Bytes judge_storey(Bytes rows_sent, Bytes asked, i64 most) {
  Reader reader(rows_sent);
  const Storey storey = read_storey(reader);
  List<Judged> judged;
  Findings found{most, {}};
  List<Opened> opened;
  judge(storey, asked, judged, found, opened);
  const Walk walk = walk_of(storey);
  WalkedFloor floor = floor_of(walk);
  floor.judged = judged.size();
  List<WalkedRoom> areas;
  List<u8> sides;
  for (const Placed& placed : storey.rooms) {
    areas.add(walked_floor(storey, walk, placed));
    for (const Body& body : placed.room.bodies) sides.add(touched_sides(storey, walk, placed, body));
  }
  List<u8> told;
  const auto tell_all = [&](Bytes rows) { told.add_all({rows.data, static_cast<i32>(rows.size)}); };
  tell_all(bytes_of(Span<WalkedFloor>{&floor, 1}));
  tell_all(bytes_of(areas.all()));
  tell_all(bytes_of(judged.all()));
  tell_all(bytes_of(found.rows.all()));
  tell_all(bytes_of(opened.all()));
  tell_all(bytes_of(sides.all()));
  return bytes_of(told.all());
}

Bytes free_floors(Bytes rows_sent) {
  Reader reader(rows_sent);
  const Storey storey = read_storey(reader);
  const Walk walk = walk_of(storey);
  List<Rect> found;
  const Span<i64> counts = reserved<i64>(storey.rooms.size);
  for (i32 i = 0; i < storey.rooms.size; i++) {
    const i32 before = found.size();
    find_swept_floor(storey, walk, storey.rooms[i], found);
    counts[i] = found.size() - before;
  }
  List<i64> rows;
  rows.add_all(counts);
  for (const Rect& box : found) rows.add(box.x0), rows.add(box.z0), rows.add(box.x1), rows.add(box.z1);
  return bytes_of(rows.all());
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
  return bytes_of(rows);
}
}  // namespace validate
