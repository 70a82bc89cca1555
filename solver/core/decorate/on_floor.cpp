#include "decorate/stages.hpp"
#include "floor/nearest.hpp"

namespace decorate {

namespace {

// What stands at a wall stands this far from its face, as furniture does.
constexpr i64 OFF_WALL_MM = 30;
// How much floor before a cupboard's doors things that do not lie about leave free. Our choice.
constexpr i64 FRONT_MM = 300;
// How much wider than asked the ways through a room are kept where its furniture leaves them so wide, the widest first: 0.8 m is what a
// person with a tray or a wheelchair takes, 0.7 m a robot with a margin.
constexpr i64 WIDER_MM[] = {200, 100, 50};
// How far rugs that lie under pieces end before walls, and in how many parts of their reach they become smaller. Our choice.
constexpr i64 RUG_OFF_WALL_MM = 100;
constexpr i64 RUG_PARTS = 4;
// Between rugs that lie one behind another. Our choice.
constexpr i64 RUG_APART_MM = 600;
// How far a rug in the middle goes to lie beside furniture. Our choice.
constexpr i64 RUG_MOVES_MM = 500;
// Places tried for a thing that stands anywhere. Our choice.
constexpr i32 TRIES = 3;

// A place wished for: inside an area, near a point, turned so.
struct Spot {
  Rect area;
  Point wish;
  i64 rotation;
};

// The floor of a room, and where on it things may go.
class Floor {
 public:
  explicit Floor(DecoratedRoom& room);

  void spread(const Stands& row, const Choice& choice);
  void lay_under(const Stands& row, const Choice& choice);
  void scatter(const Stands& row, const Turns& turns);

 private:
  const Piece* first_named(const Stands& row) const;
  bool is_named(const Stands& row, const Piece& piece) const;
  bool has_floor(const Rect& place) const;
  bool is_at_wall(const Piece& piece) const;
  NearestPlace rug_place(const Stands& row, const Rect& wish) const;
  List<Rect> not_under(const Stands* row) const;
  Rect cut_at_furniture(const Stands& row, const Piece& holder, const Rect& wish, Extent beyond) const;
  List<Spot> spots_of(const Stands& row);
  void add_beside(const Stands& row, List<Spot>& spots);
  Spot at_wall(Wall wall, i64 along) const;
  bool stood(const Stands& row, const Choice& choice, const Spot& spot);
  bool leaves_ways(const Rect& body);
  List<Rect> blocks_at(const Stands& row, const Spot& spot, const Size& size) const;

  DecoratedRoom& room_;
  const Rect clear_;
  List<Goal> goals_;
  FreeFloor free_;
  FreeFloor ways_;
};

List<Goal> goals_of(Span<Piece> pieces) {
  List<Goal> goals;
  for (const Piece& piece : pieces) {
    if (piece.sides) goals.add({piece.rect, piece.sides, piece.need_all});
  }
  return goals;
}

// The floor that the furniture leaves free for who is so wide.
static FreeFloor floor_for(const DecoratedRoom& room, i64 robot, Span<Goal> goals) {
  FreeFloor floor(room.room.clear, robot, room.doors, goals);
  for (const Piece& piece : room.pieces) {
    if (piece.in_the_way) floor.add(piece.rect);
  }
  for (const Zone& zone : room.zones) {
    if (zone.is_outline) floor.add(zone.rect);
  }
  return floor;
}

// The floor from door to door for the widest who comes to all of them; where nobody wider does, for who is as wide as asked.
static FreeFloor widest_ways(const DecoratedRoom& room) {
  for (const i64 wider : WIDER_MM) {
    FreeFloor floor = floor_for(room, room.room.robot + wider, {nullptr, 0});
    if (floor.connects()) return floor;
  }
  return floor_for(room, room.room.robot, {nullptr, 0});
}

Floor::Floor(DecoratedRoom& room)
    : room_(room),
      clear_(room.room.clear),
      goals_(goals_of(room.pieces)),
      free_(floor_for(room, room.room.robot, goals_.all())),
      ways_(widest_ways(room)) {}

// Lays a rug in the middle of the room, along its longer side, or several one behind another where one would be too long.
void Floor::spread(const Stands& row, const Choice& choice) {
  const i64 wide = room_.room.wide, deep = room_.room.deep, longer = most(wide, deep), lesser = least(wide, deep);
  Size size = room_.known.kind_of(choice).size;
  if (row.fills) {
    const i64 widest = row.widest ? row.widest : longer;
    size.width = floor_div(whole(static_cast<f64>(longer) * row.fill), 10) * 10;
    size.depth = floor_div(least(whole(static_cast<f64>(lesser) * row.fill), widest), 10) * 10;
  }
  const i64 count = row.fills && row.longest ? floor_div(size.width + RUG_APART_MM - 1, row.longest + RUG_APART_MM) + 1 : 1;
  const i64 step = floor_div(floor_div(size.width + RUG_APART_MM, count), 10) * 10;
  if (count > 1) size.width = step - RUG_APART_MM;
  const i64 rotation = wide >= deep ? 0 : 90;
  const Extent extent = room_.bounds_of(size, rotation);
  for (i64 k = 0; k < count; k++) {
    const i64 aside = (2 * k + 1 - count) * step;
    const i64 x = floor_div(wide - extent.x + (rotation ? 0 : aside), 2), z = floor_div(deep - extent.z + (rotation ? aside : 0), 2);
    const Rect wish{x, z, x + extent.x, z + extent.z};
    const NearestPlace nearest = rug_place(row, wish);
    if (!nearest.found || !has_floor(nearest.place)) continue;
    const Rect& place = nearest.place;
    const Size laid{rotation ? place.depth() : place.width(), rotation ? place.width() : place.depth(), size.height};
    room_.add(choice, row.row, place, 0, laid, rotation, NOBODY, Wall::none);
  }
}

// Floor without rugs: under what stands at the walls and is not named, if there is a row that names, and what doors open over.
List<Rect> Floor::not_under(const Stands* row) const {
  List<Rect> found;
  for (const Piece& piece : room_.pieces) {
    if (is_at_wall(piece) && !(row && is_named(*row, piece))) found.add(piece.rect);
  }
  for (const Doorway& door : room_.doors) {
    if (door.swings_in) found.add(door.square);
  }
  return found;
}

// Where a rug wished for in the middle lies before what stands at the walls, and not under it: as near and as large as there is room.
// One that is to cover the floor lies under all. Half as long a mat is a mat, half as broad a strip.
NearestPlace Floor::rug_place(const Stands& row, const Rect& wish) const {
  if (row.fills && !row.widest) return {true, wish};
  const List<Rect> blocks = not_under(nullptr);
  const bool along_x = wish.width() >= wish.depth();
  for (i64 length = RUG_PARTS; 2 * length >= RUG_PARTS; length--) {
    for (i64 breadth = RUG_PARTS; breadth + 1 >= RUG_PARTS; breadth--) {
      const i64 less_long = floor_div((RUG_PARTS - length) * most(wish.width(), wish.depth()), 20 * RUG_PARTS) * 10;
      const i64 less_broad = floor_div((RUG_PARTS - breadth) * least(wish.width(), wish.depth()), 20 * RUG_PARTS) * 10;
      const i64 x = along_x ? less_long : less_broad, z = along_x ? less_broad : less_long;
      const Rect own{wish.x0 + x, wish.z0 + z, wish.x1 - x, wish.z1 - z};
      const NearestPlace nearest = nearest_place(own, clear_, blocks.all(), RUG_MOVES_MM);
      if (nearest.found) return nearest;
    }
  }
  return {false, wish};
}

// Tells whether a piece stands on the floor, its back at a wall.
bool Floor::is_at_wall(const Piece& piece) const {
  const Point ahead = facing(piece.rotation);
  return piece.low == 0 && !has_floor(piece.rect.swept({-2 * ahead.x * OFF_WALL_MM, -2 * ahead.z * OFF_WALL_MM}));
}

// Tells whether all of a rectangle is floor of the room.
bool Floor::has_floor(const Rect& place) const {
  if (!clear_.contains(place)) return false;
  for (const Zone& zone : room_.zones) {
    if (zone.is_outline && place.overlaps(zone.rect)) return false;
  }
  return true;
}

// The piece that stands on the floor and is named first; none where the room has none that is named.
const Piece* Floor::first_named(const Stands& row) const {
  for (const i32 word : part_of(room_.known.words, row.of)) {
    for (const Piece& piece : room_.pieces) {
      if (piece.word == word && piece.low == 0) return &piece;
    }
  }
  return nullptr;
}

bool Floor::is_named(const Stands& row, const Piece& piece) const {
  return has(part_of(room_.known.words, row.of), piece.word);
}

// Takes as much off a rug on one side of its piece as on the other, where it still reaches so far beyond it.
static Rect evened(const Rect& own, Rect place, Extent beyond) {
  const i64 x = least(own.x0 - place.x0, place.x1 - own.x1), z = least(own.z0 - place.z0, place.z1 - own.z1);
  if (x >= beyond.x) place.x0 = own.x0 - x, place.x1 = own.x1 + x;
  if (z >= beyond.z) place.z0 = own.z0 - z, place.z1 = own.z1 + z;
  return place;
}

// Cuts off a rug what would lie under furniture at the walls that is not named, or under a door's leaf, at the side that leaves most of
// it once evened; never what lies under its own piece.
Rect Floor::cut_at_furniture(const Stands& row, const Piece& holder, const Rect& wish, Extent beyond) const {
  Rect place = evened(holder.rect, wish, beyond);
  const Rect own = holder.rect.common(place);
  for (const Rect& off : not_under(&row)) {
    if (!place.overlaps(off)) continue;
    const Rect left[] = {{off.x1, place.z0, place.x1, place.z1}, {place.x0, place.z0, off.x0, place.z1},
                         {place.x0, off.z1, place.x1, place.z1}, {place.x0, place.z0, place.x1, off.z0}};
    Rect best{0, 0, 0, 0};
    for (const Rect& cut : left) {
      const Rect part = evened(holder.rect, cut, beyond);
      if (part.contains(own) && part.width() * part.depth() > best.width() * best.depth()) best = part;
    }
    if (best.width() > 0) place = best;
  }
  return place;
}

// So much floor around a piece as a rug under it reaches beyond; with a part of the piece left bare not beside and behind that.
static Rect rug_under(const Stands& row, const Piece& piece, i64 beyond) {
  Rect grown = piece.rect.shrunk(-beyond);
  if (row.bare <= 0) return grown;
  const Wall behind = wall_behind(piece.rotation);
  const i64 depth = runs_along_x(behind) ? piece.rect.depth() : piece.rect.width();
  i64& back = behind == Wall::north ? grown.z0 : behind == Wall::south ? grown.z1 : behind == Wall::west ? grown.x0 : grown.x1;
  back += inwards(behind) * (beyond + whole(static_cast<f64>(depth) * row.bare));
  return grown;
}

// Lays a rug under a piece, so far beyond it as the row reaches and the floor goes, on both sides alike where that leaves a part of
// its reach, and what else it lies under; in a corner of a room that is no rectangle a smaller one.
void Floor::lay_under(const Stands& row, const Choice& choice) {
  const Piece* piece = first_named(row);
  if (piece == nullptr) return;
  const Rect inner = clear_.shrunk(RUG_OFF_WALL_MM);
  for (i64 part = RUG_PARTS; part > 0; part--) {
    const i64 beyond = floor_div(row.reach * part, RUG_PARTS);
    const Rect grown = rug_under(row, *piece, beyond);
    Rect place = grown.common(inner);
    if (place.x1 <= place.x0 || place.z1 <= place.z0) continue;
    Extent evenly{floor_div(beyond, RUG_PARTS), floor_div(beyond, RUG_PARTS)};
    for (const Piece& other : room_.pieces) {
      const Rect apart = piece->rect.common(other.rect);
      if (is_named(row, other) && other.rect.overlaps(grown)) evenly = {most(evenly.x, -apart.width()), most(evenly.z, -apart.depth())};
    }
    place = cut_at_furniture(row, *piece, place, evenly);
    place.x1 -= floor_mod(place.width(), 10);
    place.z1 -= floor_mod(place.depth(), 10);
    if (place.width() <= 0 || place.depth() <= 0 || !has_floor(place)) continue;
    const i64 height = room_.known.kind_of(choice).size.height;
    const bool lies_along_x = place.width() >= place.depth();
    const Size size{most(place.width(), place.depth()), least(place.width(), place.depth()), height};
    room_.add(choice, row.row, place, 0, size, lies_along_x ? 0 : 90, NOBODY, Wall::none);
    return;
  }
}

Spot Floor::at_wall(Wall wall, i64 along) const {
  const Rect inner = clear_.shrunk(OFF_WALL_MM);
  return {inner, inner.point_at(wall, along, 0), rotation_at(wall)};
}

// Adds places at both ends of the pieces named, the first names first, along the wall behind them.
void Floor::add_beside(const Stands& row, List<Spot>& spots) {
  for (const i32 word : part_of(room_.known.words, row.of)) {
    for (const Piece& piece : room_.pieces) {
      if (piece.word != word || piece.low != 0) continue;
      const Wall wall = wall_behind(piece.rotation);
      const Interval along = piece.rect.along(wall);
      i64 ends[] = {along.low, along.high};
      room_.stream.shuffle(Span<i64>{ends, 2});
      for (const i64 end : ends) spots.add(at_wall(wall, end));
    }
  }
}

List<Spot> Floor::spots_of(const Stands& row) {
  List<Spot> spots;
  Stream& stream = room_.stream;
  if (row.where == Where::corner) {
    Point corners[] = {{clear_.x0, clear_.z0}, {clear_.x0, clear_.z1}, {clear_.x1, clear_.z0}, {clear_.x1, clear_.z1}};
    stream.shuffle(Span<Point>{corners, 4});
    for (const Point& corner : corners) {
      spots.add(at_wall(corner.z == clear_.z0 ? Wall::north : Wall::south, corner.x));
      spots.add(at_wall(corner.x == clear_.x0 ? Wall::west : Wall::east, corner.z));
    }
  } else if (row.where == Where::free) {
    const Rect inner = clear_.shrunk(OFF_WALL_MM);
    for (i32 k = 0; k < TRIES && inner.width() >= 0 && inner.depth() >= 0; k++) {
      const i64 x = inner.x0 + stream.below(static_cast<i32>(inner.width() + 1));
      const i64 z = inner.z0 + stream.below(static_cast<i32>(inner.depth() + 1));
      spots.add({inner, {x, z}, 90 * stream.below(4)});
    }
  } else {
    if (row.where == Where::beside) add_beside(row, spots);
    if (row.where == Where::beside && spots.size() == 0) return spots;
    Wall walls[] = {WALLS[0], WALLS[1], WALLS[2], WALLS[3]};
    stream.shuffle(Span<Wall>{walls, 4});
    for (const Wall wall : walls) {
      const Interval along = clear_.along(wall);
      if (along.high >= along.low) spots.add(at_wall(wall, along.low + stream.below(static_cast<i32>(along.high - along.low + 1))));
    }
  }
  return spots;
}

// What a thing must keep out of around a spot.
List<Rect> Floor::blocks_at(const Stands& row, const Spot& spot, const Size& size) const {
  const Rect around = Rect{spot.wish.x, spot.wish.z, spot.wish.x, spot.wish.z}.shrunk(-(row.reach + 2 * (size.width + size.depth)));
  List<Rect> found;
  const auto add = [&](const Rect& rect) {
    if (around.overlaps(rect)) found.add(rect);
  };
  for (const Zone& zone : room_.zones) {
    if (size.height > zone.above) add(zone.rect);
  }
  for (const DecoratedRoom::Block& block : room_.blocks) {
    if (block.low < size.height) add(block.rect);
  }
  if (size.height > FLAT_MM) {
    for (const Rect& rect : room_.kept) add(rect);
  }
  for (const Piece& piece : room_.pieces) {
    const Point ahead = facing(piece.rotation);
    if (row.where != Where::free && piece.faced) add(piece.rect.swept({ahead.x * FRONT_MM, ahead.z * FRONT_MM}));
  }
  return found;
}

// The free place nearest to a spot: along the wall it is at, or anywhere within the row's reach.
NearestPlace free_place(const Stands& row, const Spot& spot, Extent extent, Span<Rect> blocks) {
  Rect area = spot.area;
  if (row.where != Where::free) {
    const Wall wall = wall_behind(spot.rotation);
    area = strip(area, wall, area.along(wall), runs_along_x(wall) ? extent.z : extent.x);
  }
  return nearest_place(Rect::around(spot.wish, extent).held_in(area), area, blocks, row.reach);
}

// Tells whether all stays within reach, and the ways between doors as wide as they are, with one more body.
bool Floor::leaves_ways(const Rect& body) {
  return room_.doors.size > 0 && ways_.connects_with(body) && free_.connects_with(body);
}

// Stands a thing near a spot; tells whether it found a place. Where nobody could come in before, no body may stand.
bool Floor::stood(const Stands& row, const Choice& choice, const Spot& spot) {
  const Kind& kind = room_.known.kind_of(choice);
  const i64 askew = room_.jitter(kind);
  const List<Rect> blocks = blocks_at(row, spot, kind.size);
  for (const Size& size : room_.known.sizes_of(choice)) {
    for (i32 angle = 0; angle < (askew ? 2 : 1); angle++) {
      const i64 rotation = spot.rotation + (angle == 0 ? askew : 0);
      if (size.height > room_.room.ceiling && !room_.room.outdoor) continue;
      const NearestPlace nearest = free_place(row, spot, room_.bounds_of(size, rotation), blocks.all());
      const bool is_body = size.height > FLAT_MM;
      if (!nearest.found || (is_body && !leaves_ways(nearest.place))) continue;
      room_.add(choice, row.row, nearest.place, 0, size, rotation, NOBODY, Wall::none);
      if (is_body) {
        free_.add(nearest.place);
        ways_.add(nearest.place);
      }
      return true;
    }
  }
  return false;
}

// Stands a row's things one after the other, each at the first spot that has a place; a corner holds one of them.
void Floor::scatter(const Stands& row, const Turns& turns) {
  i64 count = row.count;
  if (row.per_area != 0) count = most<i64>(1, least(count, whole(room_.room.width * room_.room.depth / row.per_area)));
  const List<Spot> spots = spots_of(row);
  const Span<bool> gone = zeroes<bool>(spots.size());
  for (i64 k = 0; k < count; k++) {
    for (i32 at = 0; at < spots.size(); at++) {
      if (gone[at] || !stood(row, turns.at(k), spots[at])) continue;
      if (row.where == Where::corner) gone[at / 2 * 2] = gone[at / 2 * 2 + 1] = true;
      break;
    }
  }
}

}  // namespace

static void stand_rows(DecoratedRoom& room, Floor& floor, const Entry& entry) {
  for (const Stands& row : part_of(room.known.stands, entry.stands)) {
    const Turns turns = room.wanted(row.row);
    if (turns.choices.size == 0 || least(room.room.width, room.room.depth) < row.min_side) continue;
    if (row.where == Where::middle) {
      floor.spread(row, turns.at(0));
    } else if (row.where == Where::under) {
      floor.lay_under(row, turns.at(0));
    } else {
      floor.scatter(row, turns);
    }
  }
}

void stand(DecoratedRoom& room) {
  const Entry* own = room.known.entry_of(room.room.word);
  const Entry* indoor = room.known.entry_of(room.known.indoor_entry);
  Floor floor(room);
  if (!room.room.outdoor && (own == nullptr || own->indoor) && indoor != nullptr) stand_rows(room, floor, *indoor);
  if (own != nullptr) stand_rows(room, floor, *own);
}

}  // namespace decorate
