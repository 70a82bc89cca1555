#include "placement/room.hpp"

#include "plain/lists.hpp"

namespace placement {

Rows<Door> doors_of(const SpaceRow& space, const Span<Doorway>& doorways) {
  const Rect clear = {space.low[0], space.low[1], space.high[0], space.high[1]};
  const Rows<Door> found = reserved_rows<Door>(doorways.size);
  for (i32 k = 0; k < doorways.size; k++) {
    const auto& [wall, _, square] = doorways[k];
    const Interval own = square.along(wall), whole = clear.along(wall);
    const i64 start = 2 * most(own.low, whole.low), end = 2 * least(own.high, whole.high);
    i64 low = start + space.robot, high = end - space.robot;
    if (low > high) low = high = floor_div(start + end, 4) * 2 + space.robot % 2;
    const i64 across = 2 * inner_line(wall, clear, square) + inwards(wall) * space.robot;
    const bool along_x = runs_along_x(wall);
    found[k] = {{along_x ? low : across, along_x ? across : low}, {along_x ? high : across, along_x ? across : high}};
  }
  return found;
}

// Tells whether two ways to stand differ in nothing but where they are wished and what they cost.
static bool is_kin(const CandidateRow& a, const CandidateRow& b) {
  const i64 *one = reinterpret_cast<const i64*>(&a), *two = reinterpret_cast<const i64*>(&b);
  const auto are_same = [&](const i64* from, const i64* to) {
    for (i64 k = from - one; k < to - one; k++) {
      if (one[k] != two[k]) return false;
    }
    return true;
  };
  return are_same(a.low, &a.kin) && are_same(one, a.anchor);
}

static void number_kins(const Room& room, const PieceRow& piece) {
  List<const CandidateRow*> kins;
  for (i64 way = piece.candidates[0]; way < piece.candidates[1]; way++) {
    i32 kin = kins.size() - 1;  // the last first: quicker (measured)
    while (kin >= 0 && !is_kin(*kins[kin], room.candidates[way])) kin--;
    if (kin < 0) {
      kin = kins.size();
      kins.add(&room.candidates[way]);
    }
    room.candidates[way].kin = kin;
  }
}

// Tells whether a piece can only stand with those from number `first` to the one before it, or must relate to that one.
static bool needs_those_before(const Room& room, i64 piece, i64 first) {
  const PieceRow& own = room.pieces[piece];
  bool carried = true, bound = false;
  for (i64 way = own.candidates[0]; way < own.candidates[1]; way++) {
    carried = carried && room.candidates[way].parent >= first && room.candidates[way].parent < piece;
  }
  for (i64 link = own.links[0]; link < own.links[1]; link++) {
    bound = bound || (room.links[link].required && room.links[link].of == piece - 1);
  }
  return carried || bound;
}

void derive(const Room& room) {
  const Span<bool> with_next = reserved<bool>(room.pieces.size);
  for (i32 k = 0; k < with_next.size; k++) {
    const arena::Scope scope;
    PieceRow& own = room.pieces[k];
    const bool fits = own.candidates[0] >= 0 && own.candidates[1] <= room.candidates.size && own.links[0] >= 0;
    if (!fits || own.links[1] > room.links.size) fail(Failure::bad_request);
    number_kins(room, own);
    with_next[k] = own.group_end == 1;
    own.group_end = k + 1;
  }
  for (i32 k = with_next.size - 2; k >= 0; k--) {
    if (!with_next[k] || room.pieces[k].required) continue;
    i32 first = k;
    while (first > 0 && with_next[first - 1]) first--;
    if (needs_those_before(room, k + 1, first)) room.pieces[k].group_end = room.pieces[k + 1].group_end;
  }
}

}  // namespace placement
