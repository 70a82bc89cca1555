#include "decorate/room.hpp"

#include "plain/rounding.hpp"

namespace decorate {

// What hangs higher is walked under: the height of a door.
constexpr i64 HEADROOM_MM = 2000;
// Nothing hangs on a wall that a front comes so near to as it opens. Our choice.
constexpr i64 AT_WALL_MM = 150;
// How far askew a thing may lie, degrees.
constexpr i32 JITTER = 15;

DecoratedRoom::DecoratedRoom(const Decorating& decorating, Bytes rows) : known(decorating), stream(0) {
  Reader reader(rows.data, rows.size);
  room = reader.take<RoomHeader>(1)[0];
  const Span<Thing> sent = reader.take<Thing>(room.pieces);
  const Span<i64> numbers = reader.take<i64>(room.pieces);
  const Span<Manner> manners = reader.take<Manner>(room.manners);
  openings.add_all(reader.take<Opening>(room.openings));
  zones = reader.take<Zone>(room.zones);
  doors = reader.take<Doorway>(room.doors);
  stream = Stream(room.stream);
  pieces = reserved<Piece>(sent.size);
  for (i32 k = 0; k < sent.size; k++) {
    check(numbers[k] >= 0 && numbers[k] < manners.size);
    const Manner& manner = manners[numbers[k]];
    check(manner.rotation >= 0 && manner.rotation < 360 && manner.rotation % 90 == 0 && manner.kept >= 0 && manner.kept <= 4);
    const Thing& one = sent[k];
    const bool in_the_way = one.size.height > FLAT_MM && one.low < HEADROOM_MM;
    const Piece& piece = pieces[k] = {manner, one.rect, one.low, one.low + one.size.height, one.under, in_the_way};
    if (one.parent < 0) keep_beside(piece);
    if (manner.opens > 0) open_fronts(piece);
    blocks.add({piece.rect, piece.low, piece.high, k});
    carriers.add({piece.rect, piece.low, piece.high, manner.rotation, manner.word, known.surfaces_of(manner.surfaces), NOBODY});
  }
  kept.add_all(reader.take<Rect>(room.kept));
}

void DecoratedRoom::keep_beside(const Piece& piece) {
  for (const Beside& one : Span<const Beside>{piece.beside, piece.kept}) {
    check(static_cast<i32>(one.faced) >= 0 && static_cast<i32>(one.faced) < 4);
    const Interval side = piece.rect.along(one.faced), over = {side.low + one.low, side.high - one.high};
    if (over.low < over.high) kept.add(strip_at(opposite(one.faced), piece.rect.line(one.faced), over, one.deep));
  }
}

// Notes what a piece's fronts come into: nothing stands there, and nothing hangs where they come near to a wall.
void DecoratedRoom::open_fronts(const Piece& piece) {
  const Wall ahead = wall_ahead(piece.rotation);
  const Rect before = strip_at(opposite(ahead), piece.rect.line(ahead), piece.rect.along(ahead), piece.opens);
  const i64 bottom = piece.low + piece.opens_above;
  opened.add({before, bottom, piece.high, carriers.size()});
  if (bottom >= HEADROOM_MM) return;
  kept.add(before);
  for (const Wall wall : WALLS) {
    if (before.wall_distance(wall, room.clear) > AT_WALL_MM) continue;
    openings.add({static_cast<i32>(wall), 0, before.along(wall), bottom, piece.high});
  }
}

Turns DecoratedRoom::wanted(const Row& row) {
  const Span<Choice> choices = part_of(known.choices, row.choices);
  const Span<i32> rooms = part_of(known.words, row.rooms);
  const i32 word = static_cast<i32>(room.word);
  const bool drawn = row.always || stream.chance(row.chance);
  const bool in_room = !has(part_of(known.words, row.not_in), word) && (rooms.size == 0 || has(rooms, word));
  if (choices.size == 0 || !drawn || !row.in_style || !in_room) return {{nullptr, 0}, 0};
  return {choices, choices.size > 1 ? stream.below(choices.size) : 0};
}

i64 DecoratedRoom::jitter(const Kind& kind) { return kind.jitter ? stream.below(2 * JITTER + 1) - JITTER : 0; }

// The piece or the thing on the floor or the wall that all below a carrier stands on.
i64 DecoratedRoom::root_of(i64 carrier) const {
  while (carriers[carrier].parent != NOBODY) carrier = carriers[carrier].parent;
  return carrier;
}

// Tells whether a body is a carrier, or what that one stands on.
bool DecoratedRoom::stands_on(i64 carrier, i64 body) const {
  while (carrier != NOBODY && carrier != body) carrier = carriers[carrier].parent;
  return carrier == body;
}

void DecoratedRoom::near(const Rect& rect, Interval heights, i64 carrier, List<Rect>& found) const {
  const i64 root = carrier == NOBODY ? NOBODY : root_of(carrier);
  for (const Block& block : blocks) {
    if (block.low >= heights.high || heights.low >= block.high || !block.rect.overlaps(rect)) continue;
    if (carrier != NOBODY && (stands_on(carrier, block.body) || is_sat_under(block.body, root))) continue;
    found.add(block.rect);
  }
}

void DecoratedRoom::opened_over(Interval heights, List<Rect>& found) const {
  for (const Block& one : opened) {
    if (one.low < heights.high && heights.low < one.high) found.add(one.rect);
  }
}

// Draws a thing's colour: one for all of its kind on one parent, unless the kind is mixed.
i32 DecoratedRoom::colour(const Choice& choice, const Row& row, i64 parent) {
  if (row.accent && room.has_accent) return -1;
  const Kind& kind = known.kind_of(choice);
  if (!kind.mixed) {
    for (const Drawn& one : colours_) {
      if (one.parent == parent && one.kind == choice.kind) return one.colour;
    }
  }
  return colours_.add({parent, choice.kind, stream.below(kind.colours)}).colour;
}

void DecoratedRoom::add(
    const Choice& choice, const Row& row, const Rect& rect, i64 low, const Size& size, i64 rotation, i64 parent, Wall wall) {
  const Kind& kind = known.kind_of(choice);
  const i32 turned = static_cast<i32>(floor_mod(rotation, 360)), at = static_cast<i32>(wall);
  const i32 drawn = colour(choice, row, parent);
  i32 same = 1;
  for (const Carrier& one : carriers) same += one.word == kind.word;
  things.add({choice.kind, static_cast<i32>(parent), NOBODY, at, turned, drawn, same, 0, rect, low, size});
  const i64 number = carriers.size();
  if (parent != NOBODY || wall != Wall::none || size.height > FLAT_MM) blocks.add({rect, low, low + size.height, number});
  carriers.add({rect, low, low + size.height, turned, kind.word, known.surfaces_of(kind.surfaces), parent});
}

Extent DecoratedRoom::bounds_of(const Size& size, i64 rotation) const {
  const i64 degrees = floor_mod(rotation, DEGREES);
  if (degrees == 0) return {size.width, size.depth};
  if (degrees == 90) return {size.depth, size.width};
  const Turn& turn = known.turns[degrees];
  const f64 width = static_cast<f64>(size.width), depth = static_cast<f64>(size.depth);
  return {rounded_up(width * turn.cosine + depth * turn.sine - 1e-6), rounded_up(width * turn.sine + depth * turn.cosine - 1e-6)};
}

}  // namespace decorate
