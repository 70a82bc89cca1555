#include "decorate/stages.hpp"
#include "floor/nearest.hpp"
#include "plain/rounding.hpp"

namespace decorate {

namespace {

// Between two things on a surface. Our choice.
constexpr i64 GAP_MM = 5;
// How far from a table a chair may stand to count as a seat at it. Our choice.
constexpr i64 SEAT_MM = 300;
// What is longer from front to back is to lie on. Our choice.
constexpr i64 LONGEST_SEAT_MM = 1000;

// A place wished for: on which carrier's surface, where on it (share of the room's x and z), how turned; with `middle`, its middle along
// x or z is wished there instead.
struct SurfaceSpot {
  i64 carrier;
  Surface surface;
  Share share;
  i64 rotation;
  bool has_x, has_z;
  Point middle;
};

// Whole centimetres of a length, rounded down; at least one.
i64 centimetres(f64 length) { return most<i64>(10, floor_div(whole(length), 10) * 10); }

}  // namespace

// Tells whether a chair stands before a table's edge, facing it.
static bool sits_at(const DecoratedRoom& room, const Carrier& chair, const Carrier& table) {
  const Point ahead = facing(chair.rotation);
  if ((ahead.x ? chair.rect.width() : chair.rect.depth()) > LONGEST_SEAT_MM) return false;
  bool is_seat = false;
  for (const Surface& surface : chair.surfaces) is_seat = is_seat || surface.word == room.known.seat_word;
  const i64 reach = floor_div(ahead.x ? chair.rect.width() : chair.rect.depth(), 2) + SEAT_MM;
  return is_seat && Rect::around(chair.rect.centre(), {2, 2}).swept({ahead.x * reach, ahead.z * reach}).overlaps(table.rect);
}

// Adds a place at the edge before every chair that faces a table.
static void add_seats(const DecoratedRoom& room, i64 table, const Surface& surface, List<SurfaceSpot>& spots) {
  for (i32 k = 0; k < room.pieces.size; k++) {
    const Carrier& chair = room.carriers[k];
    if (!room.is_sat_under(k, table) && !sits_at(room, chair, room.carriers[table])) continue;
    const Point ahead = facing(chair.rotation);
    const Share share{0.5 - static_cast<f64>(ahead.x) / 2, 0.5 - static_cast<f64>(ahead.z) / 2};
    spots.add({table, surface, share, (chair.rotation + 180) % 360, ahead.x == 0, ahead.x != 0, chair.rect.centre()});
  }
}

// What a row's things lie on: things on the carrier, of the first kind that is there, or the carrier.
static List<i64> carriers_below(const DecoratedRoom& room, i64 carrier, const Lies& row) {
  List<i64> found;
  for (const i32 word : part_of(room.known.words, row.on)) {
    if (word == ITSELF) {
      found.add(carrier);
      return found;
    }
    for (i64 k = room.pieces.size; k < room.carriers.size(); k++) {
      const Carrier& thing = room.carriers[k];
      if (thing.parent == carrier && thing.word == word && thing.surfaces.size > 0) found.add(k);
    }
    if (found.size() > 0) return found;
  }
  return found;
}

// Tells whether a row means a surface of its own carrier, or the last of the others'.
static bool means(const DecoratedRoom& room, const Lies& row, const Carrier& carrier, i32 surface, bool own) {
  const Span<i32> asked = part_of(room.known.words, row.surface);
  if (!own || asked.size == 0) return surface == carrier.surfaces.size - 1;
  for (const i32 word : asked) {
    if (word == ITSELF || word == carrier.surfaces[surface].word) return true;
  }
  return false;
}

// Adds a row's places on a surface, as its carrier is turned.
static void add_places(const DecoratedRoom& room, i64 carrier, const Surface& surface, const Lies& row, List<SurfaceSpot>& spots) {
  const i64 rotation = room.carriers[carrier].rotation;
  const Point ahead = facing(rotation);
  const f64 dx = static_cast<f64>(ahead.x), dz = static_cast<f64>(ahead.z);
  for (const Share& at : part_of(room.known.places, row.at)) {
    const f64 across = at.across - 0.5, along = at.along - 0.5;
    const Share share{0.5 + (dz * across + dx * along), 0.5 + (dz * along - dx * across)};
    spots.add({carrier, surface, share, (rotation + row.turn) % 360, false, false, {0, 0}});
  }
}

// The places of a row on a carrier, and on what is already on it.
static Span<SurfaceSpot> spots_of(const DecoratedRoom& room, i64 carrier, const Lies& row) {
  List<SurfaceSpot> spots;
  for (const i64 below : carriers_below(room, carrier, row)) {
    const Carrier& on = room.carriers[below];
    for (i32 k = 0; k < on.surfaces.size; k++) {
      if (!means(room, row, on, k, below == carrier)) continue;
      if (row.at_seats) {
        add_seats(room, below, on.surfaces[k], spots);
      } else {
        add_places(room, below, on.surfaces[k], row, spots);
      }
    }
  }
  return spots.all();
}

static Rect wish_of(const Rect& area, const SurfaceSpot& spot, Extent extent) {
  const i64 x0 = spot.has_x ? spot.middle.x - floor_div(extent.x, 2)
                            : area.x0 + rounded(static_cast<f64>(area.width() - extent.x) * spot.share.across);
  const i64 z0 = spot.has_z ? spot.middle.z - floor_div(extent.z, 2)
                            : area.z0 + rounded(static_cast<f64>(area.depth() - extent.z) * spot.share.along);
  return {x0, z0, x0 + extent.x, z0 + extent.z};
}

// The extents that fill the wished share of a surface; a thing's own where the share is 0.
static Size filled(const Rect& area, const SurfaceSpot& spot, const Share& fill, const Size& own) {
  const bool lengthwise = spot.rotation % 180 == 0;
  const f64 wide = static_cast<f64>(lengthwise ? area.width() : area.depth());
  const f64 deep = static_cast<f64>(lengthwise ? area.depth() : area.width());
  const i64 width = fill.across != 0 ? centimetres(wide * fill.across) : own.width;
  return {width, fill.along != 0 ? centimetres(deep * fill.along) : own.depth, own.height};
}

// Puts a thing at a spot or as near as it can; tells whether it found a place.
static bool put(DecoratedRoom& room, const SurfaceSpot& spot, const Lies& row, const Choice& choice) {
  const Carrier& carrier = room.carriers[spot.carrier];
  const Rect area = drawn_in(carrier.rect, spot.surface, floor_mod(carrier.rotation, 360) / 90);
  const i64 low = carrier.low + spot.surface.height;
  const i64 askew = row.upright ? 0 : room.jitter(room.known.kind_of(choice));
  Span<Size> tried = room.known.sizes_of(choice);
  Size only;
  if (row.fills) {
    only = filled(area, spot, row.fill, tried[0]);
    tried = {&only, 1};
  }
  const i64 height = tried[0].height;
  if (height > (spot.surface.clearance == NO_LIMIT ? room.room.ceiling - low : spot.surface.clearance)) return false;
  List<Rect> blocks;
  room.near(area, {low, low + height}, spot.carrier, blocks);
  for (Rect& rect : blocks) rect = rect.shrunk(-GAP_MM);
  room.opened_over({low, low + height}, blocks);
  for (const Size& size : tried) {
    for (i32 angle = 0; angle < (askew ? 2 : 1); angle++) {
      const i64 rotation = spot.rotation + (angle == 0 ? askew : 0);
      const Rect wish = wish_of(area, spot, room.bounds_of(size, rotation)).held_in(area);
      const NearestPlace nearest = nearest_place(wish, area, blocks.all(), row.reach);
      if (!nearest.found) continue;
      room.add(choice, row.row, nearest.place, low, size, rotation, spot.carrier, Wall::none);
      return true;
    }
  }
  return false;
}

void lay(DecoratedRoom& room, Span<i64> carriers) {
  const Entry* entry = room.known.entry_of(room.carriers[carriers[0]].word);
  if (entry == nullptr) return;
  for (const Lies& row : part_of(room.known.lies, entry->lies)) {
    const Turns turns = room.wanted(row.row);
    if (turns.choices.size == 0) continue;
    List<Span<SurfaceSpot>> every;
    i32 longest = 0;
    for (const i64 carrier : carriers) longest = most(longest, every.add(spots_of(room, carrier, row)).size);
    for (i32 k = 0; k < longest; k++) {
      for (const Span<SurfaceSpot>& spots : every) {
        if (k < spots.size && put(room, spots[k], row, turns.at(k))) break;
      }
    }
  }
}

static bool is_asked_for(const DecoratedRoom& room, const Lies& row, const Surface& surface) {
  for (const i32 word : part_of(room.known.words, row.surface)) {
    if (word == surface.word) return true;
  }
  return false;
}

void fill(DecoratedRoom& room, i64 piece) {
  const Entry* entry = room.known.entry_of(room.carriers[piece].word);
  const Span<Surface> insides = room.known.surfaces_of(room.pieces[static_cast<i32>(piece)].insides);
  if (entry == nullptr || insides.size == 0) return;
  for (const Lies& row : part_of(room.known.lies, entry->holds)) {
    List<SurfaceSpot> spots;
    for (const Surface& surface : insides) {
      if (is_asked_for(room, row, surface)) add_places(room, piece, surface, row, spots);
    }
    if (spots.size() == 0) continue;
    const Turns turns = room.wanted(row.row);
    if (turns.choices.size == 0) continue;
    const i32 count = spots.all().size, first = count > 1 ? room.stream.below(count) : 0;
    i32 laid = 0;
    for (i32 k = 0; k < count && laid < row.row.most; k++) {
      if (put(room, spots[(first + k) % count], row, turns.at(laid))) laid++;
    }
  }
}

}  // namespace decorate
