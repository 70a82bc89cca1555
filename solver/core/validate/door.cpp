// What the host calls of validation: rooms and storeys as bytes -> rows (solver/validator/sent_rooms.py reads and writes them).
#include "walk.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

using namespace validate;

// What is measured of a room's walk: the free centres that can be come to, and all of them.
struct WalkedRoom {
  Area entered;
  Area any;
};

// Areas of a room: between its wall lines, clear of walls, that without what bodies cover, all without what furniture on the floor covers.
struct MeasuredRoom {
  Area all, clear, uncovered, unfurnished;
};

template <class T> static i64 answer(Span<T> rows) {
  return static_cast<i64>(rows.size) * static_cast<i64>(sizeof(T)) << 32 | static_cast<i64>(reinterpret_cast<u64>(rows.data));
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

// Each returns its answer's size, bytes, in the upper half, and where it begins in the lower.
extern "C" {

// A room -> what in it breaks a rule.
EXPORT(judge_room) i64 door_judge_room(u8* data, i64 size) {
  Reader reader(data, size);
  const Room room = read_room(reader);
  Findings found;
  find_standing(room, found);
  find_floating(room, found);
  find_crossing(room, found);
  return answer(found.all());
}

// A storey -> a WalkedRoom for each of its rooms, then for all of their bodies in turn a byte: 1, 2, 4, 8 where the north, south, east, west
// side can be come to; at the end, 8 bytes each: how many tiles and cells there are, and whether
// there is floor that one can come to.
EXPORT(walk_storey) i64 door_walk_storey(u8* data, i64 size) {
  Reader reader(data, size);
  const Storey storey = read_storey(reader);
  const Walk walk = walk_of(storey);
  i32 bodies = 0;
  struct {
    i64 tiles, cells, is_entered;
  } counts{walk.tiles.size(), 0, 0};
  for (const Placed& placed : storey.rooms) bodies += placed.room.bodies.size;
  for (const Grid& tile : walk.tiles) counts.cells += static_cast<i64>(tile.cells.rows) * tile.cells.columns;
  const i32 told = storey.rooms.size * static_cast<i32>(sizeof(WalkedRoom));
  const Span<u8> rows = reserved<u8>(told + bodies + static_cast<i32>(sizeof(counts)));
  u8* side = rows.data + told;
  for (i32 i = 0; i < storey.rooms.size; i++) {
    const Placed& placed = storey.rooms[i];
    reinterpret_cast<WalkedRoom*>(rows.data)[i] = {walked_floor(walk, placed, true), walked_floor(walk, placed, false)};
    for (const Body& body : placed.room.bodies) {
      *side = 0;
      for (i32 k = 0; k < 4 && body.is(Sort::furniture); k++) {
        *side |= touches(walk, moved(body.box, placed.x, placed.z), WALLS[k], storey.reach) << k;
      }
      side++;
    }
  }
  for (const bool one : walk.entered) counts.is_entered |= one;
  __builtin_memcpy(side, &counts, sizeof(counts));
  return answer(rows);
}

// A storey -> the rectangles of each room's free floor: first how many of each room, then all of them.
EXPORT(free_floors) i64 door_free_floors(u8* data, i64 size) {
  Reader reader(data, size);
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
  return answer(rows.all());
}

// A storey -> a MeasuredRoom for each of its rooms.
EXPORT(measure_storey) i64 door_measure_storey(u8* data, i64 size) {
  Reader reader(data, size);
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
  return answer(rows);
}
}
