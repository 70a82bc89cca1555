#include "placement/options.hpp"

#include "plain/rects.hpp"

namespace placement {

// The absolute rotation of a decided piece.
static i64 rotation_of(const Room& room, const Decisions& decisions, i64 piece) {
  i64 turn = 0;
  while (piece >= 0) {
    const CandidateRow& own = room.candidates[candidate_of(decisions[piece])];
    turn += own.turn;
    piece = own.parent;
  }
  return floor_mod(turn, 360);
}

// Tells whether the parent is there in the variant the slot is for, and the slot free.
static bool fits_parent(const Room& room, const Decisions& decisions, i64 piece, const CandidateRow& own) {
  if (own.parent < 0) return true;
  if (decisions[own.parent] == ABSENT || room.candidates[candidate_of(decisions[own.parent])].kind != own.parent_kind) return false;
  if (own.slot < 0) return true;
  for (i64 other = own.parent + 1; other < decisions.size; other++) {  // what stands at a slot comes behind its parent
    if (other == piece || decisions[other] == ABSENT) continue;
    const CandidateRow& taken = room.candidates[candidate_of(decisions[other])];
    if (taken.parent == own.parent && taken.slot == own.slot) return false;
  }
  return true;
}

static bool walls_hold(i64 relation, i64 own, i64 other) {
  if (relation == ANY_WALLS) return true;
  if (own == NO_WALL || other == NO_WALL) return false;
  const bool same = own == other;
  const bool opposite = own / 2 == other / 2 && !same;
  if (relation == SAME) return same;
  if (relation == OPPOSITE) return opposite;
  if (relation == ADJACENT) return !same && !opposite;
  return relation == OTHER && !same;
}

// Tells whether one piece, turned so, looks at another: that one's anchor lies before it, no farther aside than ahead.
static bool looks_at(i64 turn, const CandidateRow& own, const CandidateRow& other) {
  const i64 dx = other.anchor[0] - own.anchor[0], dz = other.anchor[1] - own.anchor[1];
  const i64 ahead[] = {dz, dx, -dz, -dx};
  const i64 quarter = floor_mod(floor_div(turn, 90), 4);
  return ahead[quarter] > 0 && magnitude(ahead[(quarter + 1) % 4]) <= ahead[quarter];
}

// Where a way to stand is wished: what stands at a slot is wished there beside where the other piece is.
struct Wished {
  i32 turn;
  Point centre;
  Rect footprint;
};

static Wished wished(const Room& room, const Decisions& decisions, const CandidateRow& own) {
  i32 turn = static_cast<i32>(own.turn);
  Point centre{own.anchor[0], own.anchor[1]};
  if (own.parent >= 0) {
    const Wished parent = wished(room, decisions, room.candidates[candidate_of(decisions[own.parent])]);
    const Point off = rotated({floor_div(own.anchor[0], 2), floor_div(own.anchor[1], 2)}, parent.turn);
    centre = {parent.centre.x + off.x, parent.centre.z + off.z};
    turn += parent.turn;
  }
  return {turn, centre, Rect::around(centre, turned({own.width, own.depth}, turn))};
}

// What is missing of a free distance that is wished between two ways to stand, m.
static f64 too_near(f64 apart, const Rect& own, const Rect& other) {
  const i64 x = most<i64>(most(own.x0 - other.x1, other.x0 - own.x1), 0);
  const i64 z = most<i64>(most(own.z0 - other.z1, other.z0 - own.z1), 0);
  return most(0.0, apart - length(x, z) / 1000);
}

// Tells whether two pieces at places of one piece, which do not slide there, are in line neither way: the terms know nothing of them.
static bool out_of_line(const CandidateRow& own, const CandidateRow& other) {
  if (own.parent < 0 || own.parent != other.parent) return false;
  const bool pinned = own.across[0] == own.across[1] && own.along[0] == own.along[1];
  if (!pinned || other.across[0] != other.across[1] || other.along[0] != other.along[1]) return false;
  return own.across[0] != other.across[0] && own.along[0] != other.along[0];
}

f64 preference(const Room& room, const Decisions& decisions, i64 piece, i64 candidate) {
  const CandidateRow& own = room.candidates[candidate];
  if (!fits_parent(room, decisions, piece, own)) return RULED_OUT;
  f64 total = room.candidate_costs[candidate].cost;
  i64 turn = own.turn;
  if (own.parent >= 0) turn += rotation_of(room, decisions, own.parent);
  const PieceRow& row = room.pieces[piece];
  for (i64 k = row.links[0]; k < row.links[1]; k++) {
    const LinkRow& link = room.links[k];
    const LinkCost& cost = room.link_costs[k];
    if (decisions[link.of] == ABSENT) continue;
    const CandidateRow& other = room.candidates[candidate_of(decisions[link.of])];
    const i64 asked = link.turn == LOOKS_AT ? 180 : link.turn;  // what stands at a slot has no anchor to look at
    const bool turned = link.turn == LOOKS_AT && own.parent < 0 && other.parent < 0
                            ? looks_at(turn, own, other)
                            : asked < 0 || floor_mod(turn - rotation_of(room, decisions, link.of) - asked, 360) == 0;
    if (!turned || !walls_hold(link.walls, own.wall, other.wall) || (cost.align > 0 && out_of_line(own, other))) {
      if (link.required) return RULED_OUT;
      total += cost.cost;
    }
    if (cost.apart_cost > 0) {
      total += cost.apart_cost * too_near(cost.apart, wished(room, decisions, own).footprint, wished(room, decisions, other).footprint);
    }
  }
  return total;
}

f64 total_preference(const Room& room, const Decisions& decisions) {
  f64 total = 0.0;
  for (i64 piece = 0; piece < decisions.size; piece++) {
    if (decisions[piece] == ABSENT) continue;
    const f64 cost = preference(room, decisions, piece, candidate_of(decisions[piece]));
    if (cost < 0) return RULED_OUT;
    total += cost + room.side_costs[room.pieces[piece].sides[0] + sides_of(decisions[piece])];
  }
  return total;
}

f64 least_preference(const Room& room, const Decisions& decisions, i64 piece) {
  const PieceRow& row = room.pieces[piece];
  f64 least_way = INFINITE, least_side = INFINITE;
  for (i64 candidate = row.candidates[0]; candidate < row.candidates[1]; candidate++) {
    const f64 own = room.candidate_costs[candidate].cost;
    const i64 parent = room.candidates[candidate].parent;
    if (own >= least_way) continue;
    const f64 cost = parent >= 0 && decisions[parent] == ABSENT ? own : preference(room, decisions, piece, candidate);
    if (cost >= 0) least_way = least(least_way, cost);
  }
  for (i64 side = row.sides[0]; side < row.sides[1]; side++) least_side = least(least_side, room.side_costs[side]);
  return least_way < INFINITE && least_side < INFINITE ? least_way + least_side : 0.0;
}

i64 open_decisions(const Room& room, const Decisions& decisions, i64 piece, const Span<i64>& found, const Span<f64>& costs) {
  i64 count = 0;
  const PieceRow& row = room.pieces[piece];
  for (i64 candidate = row.candidates[0]; candidate < row.candidates[1]; candidate++) {
    const f64 cost = preference(room, decisions, piece, candidate);
    if (cost < 0) continue;
    for (i64 side = row.sides[0]; side < row.sides[1]; side++) {
      found[count] = 8 * candidate + side - row.sides[0];
      costs[count] = cost + room.side_costs[side];
      count++;
    }
  }
  return count;
}

}  // namespace placement
