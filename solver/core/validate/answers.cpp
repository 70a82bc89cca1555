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

Bytes judge_room(Bytes rows_sent, i64 most) {
  Reader reader(rows_sent);
  const Room room = read_room(reader);
  Findings found{most, {}};
  find_standing(room, found);
  find_above_ceiling(room, found);
  find_floating(room, found);
  find_crossing(room, found);
  return bytes_of(found.rows.all());
}

Bytes walk_storey(Bytes rows_sent) {
  Reader reader(rows_sent);
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
    reinterpret_cast<WalkedRoom*>(rows.data)[i] = walked_floor(storey, walk, placed);
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
  return bytes_of(rows);
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
