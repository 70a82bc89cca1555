#include "decorate/stages.hpp"
#include "floor/nearest.hpp"
#include "plain/rounding.hpp"

namespace decorate {

namespace {

// A piece whose back is no farther from a wall's face than this stands at that wall. Our choice.
constexpr i64 BEHIND_MM = 150;
// Furniture that stands this near to the wall, and as high, would hide what hangs there. Our choice.
constexpr i64 VIEW_MM = 300;
// From the room's corners, from the ceiling, from one another. Our choice.
constexpr i64 CORNER_MM = 50, CEILING_MM = 100, APART_MM = 120;

// A place wished for: over an interval of a wall, at a share of it, the underside's height, over which carrier.
struct WallSpot {
  Wall wall;
  Interval span;
  f64 share;
  i64 underside;
  i64 over;
};

}  // namespace

// Tells whether one walks, or a leaf swings, through the square before a door at a height: up to the opening's top.
static bool is_below_lintel(const DecoratedRoom& room, const Doorway& door, i64 height) {
  const Interval along = door.square.along(door.wall);
  for (const Opening& opening : room.openings) {
    const bool is_of_door = opening.wall == static_cast<i32>(door.wall) && opening.along.low < along.high && along.low < opening.along.high;
    if (is_of_door && height < opening.top) return true;
  }
  return false;
}

// What is in the way along a wall between two heights: openings, ways through doors, what hangs there, what would hide it.
static List<Rect> blocks_at(const DecoratedRoom& room, Wall wall, i64 depth, Interval heights) {
  const Rect& clear = room.room.clear;
  List<Rect> found, near;
  for (const Opening& opening : room.openings) {
    if (opening.wall != static_cast<i32>(wall) || heights.low >= opening.top || opening.bottom >= heights.high) continue;
    found.add(strip(clear, wall, opening.along, depth));
  }
  for (const Doorway& door : room.doors) {
    if (is_below_lintel(room, door, heights.low)) found.add(door.square);
  }
  room.near(strip(clear, wall, clear.along(wall), most(depth, VIEW_MM)), heights, NOBODY, near);
  for (const Rect& rect : near) {
    const Interval along = rect.along(wall);
    found.add(strip(clear, wall, {along.low - APART_MM, along.high + APART_MM}, depth));
  }
  return found;
}

// Hangs a thing at a spot or as near as it can with its middle over the span; tells whether it found a place.
static bool hang_at(DecoratedRoom& room, const WallSpot& spot, const Hangs& row, const Choice& choice) {
  const Rect& clear = room.room.clear;
  const Interval whole_wall = clear.along(spot.wall);
  for (const Size& size : room.known.sizes_of(choice)) {
    const i64 top = spot.underside + size.height, half = floor_div(size.width, 2);
    if (top > room.room.ceiling - CEILING_MM) continue;
    const Interval ends{most(spot.span.low - half, whole_wall.low + CORNER_MM), least(spot.span.high + half, whole_wall.high - CORNER_MM)};
    const i64 shift = rounded(static_cast<f64>(spot.span.low) + static_cast<f64>(spot.span.high - spot.span.low - size.width) * spot.share);
    const Rect area = strip(clear, spot.wall, ends, size.depth);
    const Rect wish = strip(clear, spot.wall, {shift, shift + size.width}, size.depth).held_in(area);
    const List<Rect> blocks = blocks_at(room, spot.wall, size.depth, {spot.underside, top});
    const NearestPlace nearest = nearest_place(wish, area, blocks.all(), ANYWHERE);
    if (!nearest.found) continue;
    room.add(choice, row.row, nearest.place, spot.underside, size, rotation_at(spot.wall), spot.over, spot.wall);
    return true;
  }
  return false;
}

void hang(DecoratedRoom& room, i64 number) {
  const Carrier piece = room.carriers[number];
  const Entry* entry = room.known.entry_of(piece.word);
  const Wall wall = wall_behind(piece.rotation);
  if (entry == nullptr || room.room.outdoor || !room.room.plain) return;
  if (piece.rect.wall_distance(wall, room.room.clear) > BEHIND_MM) return;
  const Point ahead = facing(piece.rotation);
  for (const Hangs& row : part_of(room.known.hangs, entry->hangs)) {
    const i64 underside = most(row.height, piece.high + row.gap);
    const Turns turns = room.wanted(row.row);
    if (turns.choices.size == 0) continue;
    const Span<f64> at = part_of(room.known.shares, row.at);
    for (i32 k = 0; k < at.size; k++) {
      const f64 share = ahead.z - ahead.x > 0 ? at[k] : 1 - at[k];
      hang_at(room, {wall, piece.rect.along(wall), share, underside, number}, row, turns.at(k));
    }
  }
}

void hang_free(DecoratedRoom& room) {
  const Entry* entry = room.known.entry_of(room.room.word);
  if (entry == nullptr || room.room.outdoor || !room.room.plain) return;
  const Rect& clear = room.room.clear;
  Wall walls[] = {WALLS[0], WALLS[1], WALLS[2], WALLS[3]};
  const auto length = [&](Wall wall) { return clear.along(wall).high - clear.along(wall).low; };
  stable_sort(Span<Wall>{walls, 4}, [&](Wall a, Wall b) { return length(a) > length(b); });
  for (const Hangs& row : part_of(room.known.hangs, entry->hangs)) {
    const Turns turns = room.wanted(row.row);
    if (turns.choices.size == 0) continue;
    const Span<f64> at = part_of(room.known.shares, row.at);
    for (i32 k = 0; k < at.size; k++) {
      for (const Wall wall : walls) {
        if (hang_at(room, {wall, clear.along(wall), at[k], row.height, NOBODY}, row, turns.at(k))) break;
      }
    }
  }
}

}  // namespace decorate
