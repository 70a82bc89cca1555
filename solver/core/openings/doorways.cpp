#include "openings/doorways.hpp"

namespace openings {

namespace {

constexpr i64 SQUARE_MM = 900;  // greatest depth of the square that stays free at a door
constexpr i64 FACING_MM = 500;  // doors whose middles are closer along a hallway face each other

}  // namespace

Doorways::Doorways(const House& of) : house(of), by_room_(reserved<List<OpeningSide>>(of.rooms.size)) {
  for (List<OpeningSide>& sides : by_room_) sides = List<OpeningSide>();
  for (const Cut& cut : of.cuts) add(cut);
}

bool Doorways::has_window(i64 room) const {
  for (const OpeningSide& side : by_room_[room]) {
    if (side.cut.kind == CutKind::window) return true;
  }
  return false;
}

void Doorways::add(const Cut& cut) {
  cuts_.add(cut);
  each_room(cut, [&](i64 room) { by_room_[room].add(side(cut, room)); });
}

void Doorways::remove(const Cut& cut) {
  keep_where(cuts_, [&](const Cut& one) { return one != cut; });
  each_room(cut, [&](i64 room) { keep_where(by_room_[room], [&](const OpeningSide& side) { return side.cut != cut; }); });
}

void Doorways::replace(const Cut& cut, const Cut& by) {
  const Cut old = cut;
  for (Cut& one : cuts_) {
    if (one == old) one = by;
  }
  each_room(old, [&](i64 room) {
    for (OpeningSide& one : by_room_[room]) {
      if (one.cut == old) one = side(by, room);
    }
  });
}

void Doorways::restore(Span<Cut> before) {
  for (i32 i = 0; i < cuts_.size();) {
    if (has(before, cuts_[i])) {
      i++;
    } else {
      remove(Cut(cuts_[i]));
    }
  }
  for (const Cut& cut : before) {
    if (!has(cuts_.all(), cut)) add(cut);
  }
}

OpeningSide Doorways::side(const Cut& cut, i64 room) const {
  const Wall wall = cut.wall_of(room);
  const Interval ends = cut.ends();
  const Rect square = cut.has_square() ? strip(house.rooms[room].rect, wall, ends, least(ends.high - ends.low, SQUARE_MM)) : Rect{};
  return {cut, wall, ends.low, ends.high, square};
}

f64 Doorways::meeting(const OpeningSide& side, const OpeningSide& other, i64 room) const {
  if (side.wall == other.wall && most(side.low, other.low) < least(side.high, other.high) + JAMB_MM) return COLLISION;
  if (!side.cut.has_square() || !other.cut.has_square() || !side.square.overlaps(other.square)) return 0.0;
  if (room == side.cut.leaf || room == other.cut.leaf) return COLLISION;
  return house.rooms[room].has(HALLWAY) ? 0.0 : CROWDED;
}

// Whether a wall comes too near to the latch of a door, whichever end it hangs at.
bool Doorways::is_cornered(const Cut& cut) const {
  if (house.header.latch == 0 || cut.kind != CutKind::door) return false;
  const Interval ends = cut.ends();
  bool too_near[2] = {false, false};
  each_room(cut, [&](i64 room) {
    const Interval wall = house.rooms[room].rect.along(cut.wall_of(room));
    too_near[0] |= house.rooms[room].has(LATCHES) && ends.low - wall.low < house.header.latch;
    too_near[1] |= house.rooms[room].has(LATCHES) && wall.high - ends.high < house.header.latch;
  });
  return too_near[0] && too_near[1];
}

f64 Doorways::score(const Cut& cut) const {
  f64 sum = is_cornered(cut) ? CORNERED : 0.0;
  each_room(cut, [&](i64 room) {
    const OpeningSide own = side(cut, room);
    for (const OpeningSide& other : by_room_[room]) {
      if (!other.cut.is_same(cut)) sum += meeting(own, other, room);
    }
  });
  return sum;
}

i64 Doorways::faced(const Cut& cut) const {
  i64 count = 0;
  each_room(cut, [&](i64 room) {
    if (room == cut.leaf || !cut.has_square()) return;
    for (const OpeningSide& other : by_room_[room]) {
      const bool is_across = other.cut.has_square() && other.wall == opposite(cut.wall_of(room));
      count += is_across && magnitude(other.cut.centre - cut.centre) < FACING_MM;
    }
  });
  return count;
}

i32 Doorways::colliding(const Cut& cut, Cut* found, i32 most) const {
  i32 count = 0;
  each_room(cut, [&](i64 room) {
    const OpeningSide own = side(cut, room);
    for (const OpeningSide& other : by_room_[room]) {
      if (other.cut.is_same(cut) || meeting(own, other, room) < COLLISION) continue;
      bool known = false;
      for (i32 i = 0; i < least(count, most); i++) known = known || found[i] == other.cut;
      if (known) continue;
      if (count < most) found[count] = other.cut;
      count++;
    }
  });
  return count;
}

bool Doorways::is_free(i64 room, Wall wall, i64 low, i64 high) const {
  for (const OpeningSide& side : by_room_[room]) {
    if (side.wall == wall && most(low, side.low) < least(high, side.high) + JAMB_MM) return false;
  }
  return true;
}

Offer Doorways::best(const Cut& cut, Interval stretch) const {
  Offer best{INFINITE, cut};
  bool first = true;
  any_place(house.header, cut.width, stretch, [&](i64 centre) {
    const Cut placed = cut.at(centre);
    const f64 offered = score(placed) + (first ? 0.0 : SHIFTED);
    first = false;
    if (offered < best.score) best = {offered, placed};
    return offered <= SHIFTED;
  });
  return best;
}

Offer Doorways::best_outside(const Cut& cut) const {
  Offer found{INFINITE, cut};
  const arena::Scope scope;
  List<Interval> stretches;
  for (const Stretch& stretch : house.outside(cut.room)) {
    if (stretch.wall == cut.wall) stretches.add(stretch.over);
  }
  stable_sort(stretches.all(), [](const Interval& a, const Interval& b) { return a.high - a.low > b.high - b.low; });
  for (const Interval& stretch : stretches) {
    const Offer offer = best(cut, stretch);
    if (offer.score < found.score) found = offer;
  }
  return found;
}

}  // namespace openings
