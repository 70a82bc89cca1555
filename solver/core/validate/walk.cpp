// The walk of a storey.
#include "validate/walk.hpp"

namespace validate {

constexpr i64 WALL_SLACK = PER_METRE / 4;  // two walls this close are one wall's two faces: a way through one goes through both

// Adds the floor inside a doorway between walls that lie apart.
static void add_bridges(const Storey& storey, const Placed& placed, const Opening& way, List<Rect>& bridges) {
  if (way.to >= storey.rooms.size) fail(Failure::bad_request);
  const Placed& beyond = storey.rooms[way.to];
  const Edge cut = way.edge.moved(placed.x, placed.z);
  for (const Edge& edge : beyond.room.edges) {
    if (edge.side != static_cast<i64>(opposite(static_cast<Wall>(cut.side)))) continue;
    const Edge wall = edge.moved(beyond.x, beyond.z);
    const i64 gap = cut.looks_ahead() ? cut.line - wall.line : wall.line - cut.line;
    const i64 start = most(cut.start, wall.start), end = least(cut.end, wall.end);
    if (gap > 0 && gap <= storey.deepest_wall && start < end) bridges.add(cut.strip(start, end, 0, gap));
  }
}

static Span<Rect> bridges_of(const Storey& storey) {
  List<Rect> bridges;
  for (const Placed& placed : storey.rooms) {
    for (i32 k = 0; k < placed.room.own; k++) {
      const Opening& one = placed.room.openings[k];
      if (one.is_way() && one.to >= 0) add_bridges(storey, placed, one, bridges);
    }
  }
  return bridges.all();
}

Storey read_storey(Reader& reader) {
  const StoreyRow& sent = reader.take<StoreyRow>(1)[0];
  Storey storey{sent.half_wall, sent.reach, sent.deepest_wall, most(sent.most_boxes, 1), {}, {}, {}};
  storey.entrances = reader.take<Rect>(sent.entrances);
  const Span<Turned> turns = reader.take<Turned>(sent.turns);
  const Span<Kind> kinds = read_kinds(reader, sent.kinds);
  if (sent.rooms < 0) fail(Failure::bad_request);
  storey.rooms = reserved<Placed>(sent.rooms);
  for (Placed& placed : storey.rooms) {
    const Point at = reader.take<Point>(1)[0];
    placed = {read_room(reader, kinds, turns, sent.half_wall), at.x, at.z};
  }
  storey.bridges = bridges_of(storey);
  return storey;
}

// What the centre must stay out of along a piece of wall line: all of it but its ways through, sorted. At a corner the wall goes on by half
// its thickness, at a jamb it ends.
static void add_walls(const Edge& edge, const List<Interval>& ways, i64 half_wall, i64 reach, List<Rect>& found) {
  const i64 deep = half_wall + reach;
  i64 start = edge.start, before = deep;
  for (const Interval& way : ways) {
    if (way.low > start) found.add(edge.strip(start - before, way.low + reach, deep, deep));
    if (way.high >= start) start = way.high, before = reach;
  }
  if (start < edge.end) found.add(edge.strip(start - before, edge.end + deep, deep, deep));
}

// The ways through walls of a storey, by direction and line.
static List<Edge> all_ways(const Storey& storey) {
  List<Edge> ways;
  for (const Placed& placed : storey.rooms) {
    const Room& room = placed.room;
    for (i32 k = 0; k < room.own; k++) {
      if (room.openings[k].is_way()) ways.add(room.openings[k].edge.moved(placed.x, placed.z));
    }
  }
  stable_sort(ways.all(), [](const Edge& a, const Edge& b) {
    return a.runs_east() != b.runs_east() ? b.runs_east() : a.line < b.line;
  });
  return ways;
}

// The ways through a piece of wall line: those that run along it, no farther than a wall is thick, and the bridges that end at it.
static void ways_through(const List<Edge>& ways, Span<Rect> bridges, const Edge& edge, List<Interval>& found) {
  i32 at = count_before(ways.all(), [&](const Edge& way) {
    return way.runs_east() != edge.runs_east() ? edge.runs_east() : way.line < edge.line - WALL_SLACK;
  });
  for (; at < ways.size() && ways[at].runs_east() == edge.runs_east() && ways[at].line <= edge.line + WALL_SLACK; at++) {
    const Edge& way = ways[at];
    if (way.start < edge.end && edge.start < way.end) found.add({most(way.start, edge.start), least(way.end, edge.end)});
  }
  for (const Rect& bridge : bridges) {
    const Interval along = edge.runs_east() ? Interval{bridge.x0, bridge.x1} : Interval{bridge.z0, bridge.z1};
    const Interval across = edge.runs_east() ? Interval{bridge.z0, bridge.z1} : Interval{bridge.x0, bridge.x1};
    if ((across.low != edge.line && across.high != edge.line) || along.low >= edge.end || edge.start >= along.high) continue;
    found.add({most(along.low, edge.start), least(along.high, edge.end)});
  }
  stable_sort(found.all(), begins_before);
}

static List<Rect> obstacles_of(const Storey& storey) {
  List<Rect> found;
  const List<Edge> ways = all_ways(storey);
  List<Interval> through;
  for (const Placed& placed : storey.rooms) {
    for (const Body& body : placed.room.bodies) {
      if (body.is_solid && body.low() < HEADROOM) found.add(grown(moved(body.box, placed.x, placed.z), storey.reach));
    }
    for (const Edge& one : placed.room.edges) {
      const Edge edge = one.moved(placed.x, placed.z);
      through.cut(0);
      ways_through(ways, storey.bridges, edge, through);
      add_walls(edge, through, storey.half_wall, storey.reach, found);
    }
  }
  return found;
}

// Calls `look(tile, window)` for every tile that a box meets.
template <class Look> static void look_at(const Walk& walk, const Rect& box, Look look) {
  for (const Grid& tile : walk.tiles) {
    const i32 last_x = tile.xs.size - 1, last_z = tile.zs.size - 1;
    if (last_x < 1 || last_z < 1) continue;
    if (meet(box, {tile.xs[0], tile.zs[0], tile.xs[last_x], tile.zs[last_z]})) look(tile, window_of(tile, box));
  }
}

Walk near(const Walk& walk, const Storey& storey, const Placed& placed) {
  Rect all = placed.room.bounds;
  for (const Body& body : placed.room.bodies) all = all.with(body.box);
  Walk found{{}, walk.entered};
  const Rect reached = grown(moved(all, placed.x, placed.z), storey.reach + 1);
  look_at(walk, reached, [&](const Grid& tile, const CellWindow&) { found.tiles.add(tile); });
  return found;
}

// Where in a room a centre is clear of all its walls, the doors in them shut: boxes that do not overlap.
static List<Rect> clear_centres(const Storey& storey, const Placed& placed) {
  List<Rect> walls, found;
  const i64 deep = storey.half_wall + storey.reach;
  for (const Edge& edge : placed.room.edges) walls.add(edge.strip(edge.start - deep, edge.end + deep, deep, deep));
  find_free(placed.room.inside, walls.all(), storey.most_boxes, found);
  return found;
}

// Calls `look(component, wide, deep)` for all floor of a room that is clear of its walls: what lies in doorways is not.
template <class Look> static void look_at_floor(const Storey& storey, const Walk& walk, const Placed& placed, Look look) {
  for (const Rect& own : clear_centres(storey, placed)) {
    const Rect box = moved(own, placed.x, placed.z);
    look_at(walk, box, [&](const Grid& tile, const CellWindow& at) {
      for (i32 i = at.x0; i < at.x1; i++) {
        const i64 wide = least(tile.xs[i + 1], box.x1) - most(tile.xs[i], box.x0);
        for (i32 k = at.z0; k < at.z1; k++) {
          look(tile.cells.at(i, k), wide, least(tile.zs[k + 1], box.z1) - most(tile.zs[k], box.z0));
        }
      }
    });
  }
}

// The component that has most floor of rooms, the first of those that are alike; 0 where no floor is free.
static i32 largest(const Storey& storey, const Walk& walk, i32 count) {
  const arena::Scope scope;
  const Span<f64> sums = zeroes<f64>(count + 1);
  for (const Placed& placed : storey.rooms) {
    look_at_floor(storey, walk, placed, [&](i32 component, i64 wide, i64 deep) {
      sums[component] += static_cast<f64>(wide) * static_cast<f64>(deep);
    });
  }
  i32 found = 0;
  for (i32 one = 1; one <= count; one++) {
    if (sums[one] > (found == 0 ? 0.0 : sums[found])) found = one;
  }
  return found;
}

Walk walk_of(const Storey& storey) {
  List<Rect> floors;
  for (const Placed& placed : storey.rooms) {
    for (const Rect& box : placed.room.inside) floors.add(moved(box, placed.x, placed.z));
  }
  floors.add_all(storey.bridges);
  Walk walk{tiles_of(floors.all(), obstacles_of(storey).all(), storey.most_boxes), {}};
  const i32 count = label(walk.tiles);
  walk.entered = zeroes<bool>(count + 1);
  if (storey.entrances.size == 0) walk.entered[largest(storey, walk, count)] = true;
  for (const Rect& entrance : storey.entrances) {
    look_at(walk, entrance, [&](const Grid& tile, const CellWindow& at) {
      for (i32 i = at.x0; i < at.x1; i++) {
        for (i32 k = at.z0; k < at.z1; k++) walk.entered[tile.cells.at(i, k)] = true;
      }
    });
  }
  walk.entered[0] = false;
  return walk;
}

WalkedRoom walked_floor(const Storey& storey, const Walk& walk, const Placed& placed) {
  const arena::Scope scope;
  WalkedRoom found;
  look_at_floor(storey, walk, placed, [&](i32 component, i64 wide, i64 deep) {
    if (component > 0) found.any.add_product(wide, deep);
    if (walk.entered[component]) found.entered.add_product(wide, deep);
  });
  return found;
}

bool touches(const Walk& walk, const Rect& box, Wall side, i64 reach) {
  const bool runs_east = runs_along_x(side);
  const i64 line = box.line(side) - inwards(side) * reach;
  const Edge edge{static_cast<i64>(opposite(side)), line, runs_east ? box.x0 : box.z0, runs_east ? box.x1 : box.z1};
  bool found = false;
  look_at(walk, edge.strip(edge.start, edge.end, 1, 0), [&](const Grid& tile, const CellWindow& at) {
    for (i32 i = at.x0; i < at.x1; i++) {
      for (i32 k = at.z0; k < at.z1; k++) found = found || walk.entered[tile.cells.at(i, k)];
    }
  });
  return found;
}

u8 missed_sides(const Storey& storey, const Walk& walk, const Placed& placed, const Body& body) {
  const Kind& kind = placed.room.kind_of(body);
  if (!body.is(Sort::furniture) || (kind.any_of | kind.all_of) == 0) return 0;
  u8 touched = 0;
  i32 met = 0;
  for (i32 turn = 0; turn < 4; turn++) {
    if (((kind.any_of | kind.all_of) >> turn & 1) == 0) continue;
    const Wall side = wall_ahead(90 * (body.row->quarters + turn));
    if (!touches(walk, moved(body.box, placed.x, placed.z), side, storey.reach)) continue;
    met |= 1 << turn;
    touched |= 1 << static_cast<i32>(side);
  }
  const bool is_enough = (kind.all_of & ~met) == 0 && (kind.any_of == 0 || (kind.any_of & met) != 0);
  return is_enough ? 0 : 16 | touched;
}

void find_swept_floor(const Storey& storey, const Walk& walk, const Placed& placed, List<Rect>& found) {
  const Rect near = grown(moved(placed.room.bounds, placed.x, placed.z), storey.reach);
  Rect clear = grown(placed.room.bounds, -storey.half_wall);
  clear.x1 = most(clear.x0, clear.x1), clear.z1 = most(clear.z0, clear.z1);
  List<Rect> centres, swept, walls;
  look_at(walk, near, [&](const Grid& tile, const CellWindow& at) {
    const auto is_reached = [&](i32 i, i32 k) {
      return i >= at.x0 && i < at.x1 && k >= at.z0 && k < at.z1 && walk.entered[tile.cells.at(i, k)];
    };
    rectangles(tile, is_reached, centres);
  });
  for (const Rect& one : centres) {
    const Rect box = grown(moved(one, -placed.x, -placed.z), storey.reach);
    if (meet(box, clear)) swept.add(box.common(clear));
  }
  walls.add_all(placed.room.missing);
  const i64 half = storey.half_wall;
  for (const Edge& edge : placed.room.edges) walls.add(edge.strip(edge.start - half, edge.end + half, half, half));
  find_free(swept.all(), walls.all(), storey.most_boxes, found);
}

}  // namespace validate
