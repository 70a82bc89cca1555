#include "placement/reshape.hpp"

#include "placement/piece_tables.hpp"

namespace placement {

// In each of the first five a person of 0.6 m has the 0.25 m2 of free centres that a room must have; the others leave room for floor that
// goes round a corner, whose area the walk measures.
constexpr i64 FLOOR_SHAPES[][2] = {{1110, 1110}, {900, 1450}, {1450, 900}, {760, 2200}, {2200, 760}, {900, 900}, {750, 1200}, {1200, 750}};
constexpr f64 FLOOR_WEIGHT = 0.02;
constexpr i64 FLOOR_KIND = 1 << 30;  // no kind of a room's pieces

namespace {

struct Tables : PieceTables {
  List<i64> piece_numbers, candidate_numbers;

  NumberedRoom all(Room room) const {
    give_to(room);
    return {room, piece_numbers.all(), candidate_numbers.all()};
  }
};

}  // namespace

static Span<i64> counted(i64 size) {
  const Span<i64> found = reserved<i64>(static_cast<i32>(size));
  for (i32 k = 0; k < found.size; k++) found[k] = k;
  return found;
}

static i64 shifted(i64 piece, i64 first, i64 by) { return piece < first ? piece : piece + by; }

// Copies a piece's candidates but those that need a piece left out (-1: none); pieces from `first` on are renumbered.
static void copy_candidates(Tables& into, const NumberedRoom& from, const PieceRow& row, i64 out, i64 first, i64 by) {
  for (i64 k = row.candidates[0]; k < row.candidates[1]; k++) {
    CandidateRow own = from.room.candidates[k];
    if (out >= 0 && own.parent == out) continue;
    own.parent = shifted(own.parent, first, by);
    own.under = own.under == out && out >= 0 ? -1 : shifted(own.under, first, by);
    own.on = own.on == out && out >= 0 ? -1 : shifted(own.on, first, by);
    into.candidates.add(own);
    into.candidate_costs.add(from.room.candidate_costs[k]);
    into.candidate_numbers.add(from.candidates[k]);
  }
}

static void copy_links(Tables& into, const NumberedRoom& from, const PieceRow& row, i64 out, i64 first, i64 by) {
  for (i64 k = row.links[0]; k < row.links[1]; k++) {
    LinkRow own = from.room.links[k];
    if (own.of == out) continue;
    own.of = shifted(own.of, first, by);
    into.links.add(own);
    into.link_costs.add(from.room.link_costs[k]);
  }
}

static void copy_sides(Tables& into, const NumberedRoom& from, const PieceRow& row) {
  for (i64 k = row.sides[0]; k < row.sides[1]; k++) {
    into.sides.add(from.room.sides[k]);
    into.side_costs.add(from.room.side_costs[k]);
  }
}

// Copies all pieces but one (-1: none) as they are; their numbers move by `by` from number `first` on.
static void copy_pieces(Tables& into, const NumberedRoom& from, i64 out, i64 first, i64 by) {
  for (i64 piece = 0; piece < from.room.pieces.size; piece++) {
    if (piece == out) continue;
    const PieceRow& row = from.room.pieces[piece];
    PieceRow own = row;
    into.mark(own, 0);
    copy_candidates(into, from, row, out, first, by);
    copy_links(into, from, row, out, first, by);
    copy_sides(into, from, row);
    into.mark(own, 1);
    own.group_end = row.group_end - 1 < first ? row.group_end : row.group_end + by;
    into.pieces.add(own);
    into.skip_costs.add(from.room.skip_costs[piece]);
    into.piece_numbers.add(from.pieces[piece]);
  }
}

NumberedRoom without_piece(const NumberedRoom& from, i64 piece) {
  Tables tables;
  copy_pieces(tables, from, piece, piece, -1);
  return tables.all(from.room);
}

NumberedRoom numbered(const Room& room) {
  NumberedRoom found = {room, counted(room.pieces.size), counted(room.candidates.size)};
  for (i64 piece = room.pieces.size - 1; piece >= 0; piece--) {
    if (room.pieces[piece].required < 0) found = without_piece(found, piece);
  }
  return found;
}

NumberedRoom without_walking(const NumberedRoom& from) {
  NumberedRoom found = from;
  const i64 count = from.room.pieces.size;
  const Span<SpaceRow> space = reserved<SpaceRow>(1);
  space[0] = *from.room.space.data;
  space[0].least_floor = space[0].ways = 0;
  found.room.space.data = space.data;
  found.room.pieces = reserved_rows<PieceRow>(count);
  found.room.sides = reserved_rows<SidesRow>(count);
  found.room.side_costs = zeroes<f64>(static_cast<i32>(count));
  for (i64 piece = 0; piece < count; piece++) {
    found.room.pieces[piece] = from.room.pieces[piece];
    found.room.pieces[piece].sides[0] = piece;
    found.room.pieces[piece].sides[1] = piece + 1;
    found.room.sides[piece] = {0, 0, 0};
  }
  return found;
}

NumberedRoom with_empty_floor(const NumberedRoom& from, i64 wider) {
  const SpaceRow& space = *from.room.space.data;
  Tables tables;
  for (const i64* shape : FLOOR_SHAPES) {
    CandidateRow own = {};
    own.kind = FLOOR_KIND;
    own.width = shape[0] + wider;
    own.depth = shape[1] + wider;
    own.height = PERSON_MM;
    own.wall = NO_WALL;
    own.parent = own.parent_kind = own.slot = own.under = own.on = own.slack = -1;
    own.kin = tables.candidates.size();
    for (i64 axis = 0; axis < 2; axis++) {
      own.anchor[axis] = floor_div(space.low[axis] + space.high[axis], 2);
      own.low[axis] = space.low[axis];
      own.high[axis] = space.high[axis];
    }
    tables.candidates.add(own);
    tables.candidate_costs.add({{FLOOR_WEIGHT, FLOOR_WEIGHT}, 0.0});
    tables.candidate_numbers.add(-1);
  }
  tables.sides.add({0, 0, 0});
  tables.side_costs.add(0.0);
  tables.pieces.add({1, {0, tables.candidates.size()}, {0, 0}, {0, 1}, 1, EMPTY_FLOOR});
  tables.skip_costs.add(0.0);
  tables.piece_numbers.add(-1);
  copy_pieces(tables, from, -1, 0, 1);
  return tables.all(from.room);
}

}  // namespace placement
