// Keeps walls whole for what stands along them: a bed between its nightstands, the run of a kitchen.
#include "openings/doorways.hpp"

namespace openings {

namespace {

constexpr i32 MOVES = 4;  // most openings that are moved for one room

// Stretches of a wall: what breaks it, or what is left of it.
using Pieces = List<Interval>;

struct Broken {
  Pieces of[4];

  void clear() {
    for (Pieces& wall : of) wall.cut(0);
  }
  void add(Wall wall, i64 low, i64 high) { of[static_cast<i32>(wall)].add({low, high}); }
  Span<Interval> at(Wall wall) { return of[static_cast<i32>(wall)].all(); }
  void sort() {
    for (Pieces& wall : of) stable_sort(wall.all(), begins_before);
  }
};

// A wall's longest stretch that nothing breaks, and those that reach its western or northern end and its other end, mm.
struct Whole {
  i64 longest, at_low, at_high;
};

Whole whole_of(Interval wall, Span<Interval> broken) {
  if (broken.size == 0) return {wall.high - wall.low, wall.high - wall.low, wall.high - wall.low};
  i64 longest = 0, at_low = 0, at = wall.low;
  for (const Interval& one : broken) {
    if (one.low > at) {
      longest = most(longest, one.low - at);
      if (at == wall.low) at_low = one.low - at;
    }
    at = most(at, one.high);
  }
  return {most(longest, wall.high - at), at_low, most<i64>(0, wall.high - at)};
}

// What is left of a wall, from its low end up.
void gaps_in(Interval wall, Span<Interval> broken, Pieces& gaps) {
  gaps.cut(0);
  i64 at = wall.low;
  const auto leave = [&](i64 low, i64 high) {
    if (low < high) gaps.add({low, high});
  };
  for (const Interval& one : broken) {
    if (one.low > at) leave(at, least(one.low, wall.high));
    at = most(at, one.high);
  }
  leave(at, wall.high);
}

class Walls {
 public:
  explicit Walls(Doorways& doorways) : doorways_(doorways), house_(doorways.house) {}

  // By how much a room's longest whole walls are too short for its type, mm, with one opening elsewhere, or without it.
  i64 shortfall(i64 room, const Cut* cut = nullptr, const Cut* placed = nullptr) {
    const HouseRoom& kind = house_.rooms[room];
    i64 sum = 0;
    for (const Wish& wish : part_of(house_.wishes, {kind.first_wish, kind.wishes})) {
      broken_.clear();
      for (const OpeningSide& side : doorways_.sides(room)) {
        if (cut == nullptr || side.cut != *cut) break_walls(kind.rect, side, wish);
      }
      if (placed != nullptr) break_walls(kind.rect, doorways_.side(*placed, room), wish);
      broken_.sort();
      sum += most<i64>(0, wish.length - longest(kind.rect, wish));
    }
    return sum;
  }

  // Moves the opening of a room by which most is won for the rooms it opens on, or the first that will do; windows come first.
  bool move_one(i64 room) {
    const i64 lacking = shortfall(room);
    Move best{0, {}, {}};
    for (i32 turn = 0; turn < 2; turn++) {
      const bool windows = turn == 0;
      for (i32 i = 0; i < doorways_.sides(room).size() && best.won < lacking; i++) {
        const Cut cut = doorways_.sides(room)[i].cut;
        if (cut.kind != CutKind::garage_door && (cut.kind == CutKind::window) == windows) look(room, lacking, cut, best);
      }
    }
    if (best.won > 0) doorways_.replace(best.cut, best.placed);
    return best.won > 0;
  }

 private:
  struct Move {
    i64 won;
    Cut cut, placed;
  };

  // What an opening elsewhere wins in its two rooms.
  struct Gains {
    i64 room, gain, beyond, gain_beyond;
  };

  // Tries an opening at both ends of its stretch of wall.
  void look(i64 room, i64 lacking, const Cut& cut, Move& best) {
    if (shortfall(room, &cut) == lacking) return;
    const i64 beyond = room == cut.room ? cut.other : cut.room, other = beyond == NONE ? 0 : shortfall(beyond);
    Cut places[2];
    for (i32 i = 0, count = ends_for(cut, places); i < count; i++) {
      const i64 there = beyond == NONE ? 0 : other - shortfall(beyond, &cut, &places[i]);
      const Gains gains{room, lacking - shortfall(room, &cut, &places[i]), beyond, there};
      const i64 won = gains.gain + gains.gain_beyond;
      if (won > best.won && is_in_nobodys_way(cut, places[i], gains)) best = {won, cut, places[i]};
    }
  }

  // Whether an opening there meets and faces no more than it did, and leads no farther round in a room whose walls win nothing.
  bool is_in_nobodys_way(const Cut& cut, const Cut& placed, const Gains& gains) const {
    if (doorways_.score(placed) > doorways_.score(cut) || doorways_.faced(placed) > doorways_.faced(cut)) return false;
    const auto is_farther = [&](i64 room, i64 gain) { return gain <= 0 && way(room, placed) > way(room, cut); };
    return !is_farther(gains.room, gains.gain) && (gains.beyond == NONE || !is_farther(gains.beyond, gains.gain_beyond));
  }

  // How far an opening is from the others that one walks through, along x and z, mm in all.
  i64 way(i64 room, const Cut& cut) const {
    if (!cut.has_square()) return 0;
    const Point own = doorways_.side(cut, room).square.centre();
    i64 sum = 0;
    for (const OpeningSide& side : doorways_.sides(room)) {
      if (!side.cut.has_square() || side.cut.is_same(cut)) continue;
      const Point at = side.square.centre();
      sum += magnitude(own.x - at.x) + magnitude(own.z - at.z);
    }
    return sum;
  }

  // An opening at the ends of its stretch of wall; returns how many there are.
  i32 ends_for(const Cut& cut, Cut* places) const {
    const Joint* joint = cut.other != NONE ? house_.joint_of(cut) : nullptr;
    const Stretch* stretch = cut.other == NONE ? house_.stretch_at(cut.room, cut.wall, cut.centre) : nullptr;
    if (joint == nullptr && stretch == nullptr) return 0;
    const Interval over = joint != nullptr ? joint->over : stretch->over;
    const i64 room = floor_div(over.high - over.low - cut.width, 2), half = cut.width / 2;
    const i64 jamb = cut.kind == CutKind::window ? EDGE_MM : least(house_.header.jamb, room);
    i32 count = 0;
    const i64 ends[] = {over.low + jamb + half, over.high - jamb - half};
    for (const i64 centre : ends) {
      const bool fits = over.low + jamb <= centre - half && centre + half <= over.high - jamb;
      if (centre != cut.centre && fits) places[count++] = cut.at(centre);
    }
    return count;
  }

  // Notes what an opening breaks: a window its wall, where it does; a door each wall that its square on the floor comes near to.
  void break_walls(const Rect& rect, const OpeningSide& side, const Wish& wish) {
    if (!side.cut.has_square()) {
      if (!wish.under_windows || side.cut.kind != CutKind::window) broken_.add(side.wall, side.low, side.high);
      return;
    }
    const Rect inner = rect.shrunk(wish.depth), &square = side.square;
    if (square.z0 < inner.z0) broken_.add(Wall::north, square.x0, square.x1);
    if (square.z1 > inner.z1) broken_.add(Wall::south, square.x0, square.x1);
    if (square.x0 < inner.x0) broken_.add(Wall::west, square.z0, square.z1);
    if (square.x1 > inner.x1) broken_.add(Wall::east, square.z0, square.z1);
  }

  // The longest stretch of a room's walls as is wished for, mm.
  i64 longest(const Rect& rect, const Wish& wish) {
    const i64 narrow = least(rect.width(), rect.depth());
    if (0 < narrow && narrow <= wish.across) return longest_facing(rect, wish);
    const auto of = [&](Wall wall) { return whole_of(rect.along(wall), broken_.at(wall)); };
    const Whole north = of(Wall::north), south = of(Wall::south), east = of(Wall::east), west = of(Wall::west);
    const i64 straight = most(most(north.longest, south.longest), most(east.longest, west.longest));
    if (!wish.round_corners) return straight;
    const i64 northern = most(north.at_low + west.at_low, north.at_high + east.at_low);
    return most(straight, most(northern, most(south.at_low + west.at_high, south.at_high + east.at_high)));
  }

  i64 longest_facing(const Rect& rect, const Wish& wish) {
    constexpr Wall PAIRS[2][2] = {{Wall::north, Wall::south}, {Wall::west, Wall::east}};
    bool any = false;
    i64 longest = 0;
    for (const auto& pair : PAIRS) {
      if ((runs_along_x(pair[0]) ? rect.depth() : rect.width()) > wish.across) continue;
      gaps_in(rect.along(pair[0]), broken_.at(pair[0]), one_);
      gaps_in(rect.along(pair[1]), broken_.at(pair[1]), other_);
      for (const Interval& a : one_) {
        for (const Interval& b : other_) {
          const i64 common = least(a.high, b.high) - most(a.low, b.low);
          longest = any ? most(longest, common) : common;
          any = true;
        }
      }
    }
    return longest;
  }

  Doorways& doorways_;
  const House& house_;
  Broken broken_;
  Pieces one_, other_;
};

}  // namespace

void keep_walls(Doorways& doorways) {
  Walls walls(doorways);
  for (i64 room = 0; room < doorways.house.rooms.size; room++) {
    for (i32 i = 0; i < MOVES && walls.shortfall(room) > 0 && walls.move_one(room); i++) continue;
  }
}

}  // namespace openings
