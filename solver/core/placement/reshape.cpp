#include "placement/reshape.hpp"

#include "placement/piece_tables.hpp"

namespace placement {

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

NumberedRoom numbered(const Room& room) { return {room, counted(room.pieces.size), counted(room.candidates.size)}; }

// A piece's number once another one is left out.
static i64 shifted(i64 piece, i64 out) { return piece < out ? piece : piece - 1; }

// Copies a piece's candidates but those that need the piece left out.
static void copy_candidates(Tables& into, const NumberedRoom& from, const PieceRow& row, i64 out) {
  for (i64 k = row.candidates[0]; k < row.candidates[1]; k++) {
    CandidateRow own = from.room.candidates[k];
    if (own.parent == out) continue;
    own.parent = shifted(own.parent, out);
    own.under = own.under == out ? -1 : shifted(own.under, out);
    own.on = own.on == out ? -1 : shifted(own.on, out);
    into.candidates.add(own);
    into.candidate_costs.add(from.room.candidate_costs[k]);
    into.candidate_numbers.add(from.candidates[k]);
  }
}

static void copy_links(Tables& into, const NumberedRoom& from, const PieceRow& row, i64 out) {
  for (i64 k = row.links[0]; k < row.links[1]; k++) {
    LinkRow own = from.room.links[k];
    if (own.of == out) continue;
    own.of = shifted(own.of, out);
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

NumberedRoom without_piece(const NumberedRoom& from, i64 out) {
  Tables tables;
  for (i64 piece = 0; piece < from.room.pieces.size; piece++) {
    if (piece == out) continue;
    const PieceRow& row = from.room.pieces[piece];
    PieceRow own = row;
    tables.mark(own, 0);
    copy_candidates(tables, from, row, out);
    copy_links(tables, from, row, out);
    copy_sides(tables, from, row);
    tables.mark(own, 1);
    own.group_end = shifted(row.group_end - 1, out) + 1;
    tables.pieces.add(own);
    tables.skip_costs.add(from.room.skip_costs[piece]);
    tables.piece_numbers.add(from.pieces[piece]);
  }
  return tables.all(from.room);
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

}  // namespace placement
