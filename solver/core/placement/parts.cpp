#include "placement/parts.hpp"

#include "placement/frames.hpp"

namespace placement {

// Pull of a person's square to the middle of its side, m^-2: least weight that keeps the Hessian positive definite.
constexpr f64 STAND_WEIGHT = 0.02;

static void add_row(const Work& work, const DifferenceRow& row) { work.rows[work.counts->rows++] = row; }

static void add_pull(const Work& work, const PullRow& between, const PullCost& cost) {
  const i64 k = work.counts->pulls++;
  work.pulls[k] = between;
  work.pull_costs[k] = cost;
}

static i64 add_variable(const Work& work, i64 axis, i64 low, i64 high) {
  const i64 v = work.sizes[axis]++;
  work.low.at(axis, v) = low;
  work.high.at(axis, v) = high;
  work.anchor_weight.at(axis, v) = 0.0;
  work.anchor_at.at(axis, v) = 0.0;
  return v;
}

static void narrow(const Work& work, i64 axis, i64 v, i64 low, i64 high) {
  i64& own_low = work.low.at(axis, v);
  i64& own_high = work.high.at(axis, v);
  own_low = most(own_low, low);
  own_high = least(own_high, high);
}

// Adds the part of a piece's body, without its place.
static Part& add_body(const Room& room, const Work& work, i64 piece, const CandidateRow& own) {
  const i64 number = work.counts->parts++;
  Part& body = work.parts[number];
  body.piece = piece;
  body.stand = room.pieces[piece].empty;
  body.low = own.bottom;
  body.high = own.bottom + own.height;
  work.body_part[piece] = number;
  return body;
}

static i64 extent_along(const CandidateRow& own, i64 axis, i64 rotation) {
  const bool across = rotation == 90 || rotation == 270;
  return across == (axis == 0) ? own.depth : own.width;
}

// Adds a body with its own variables: in the room, or flush at a wall.
static void add_rooted(const Room& room, const Work& work, i64 piece, i64 candidate) {
  const CandidateRow& own = room.candidates[candidate];
  const SpaceRow& space = *room.space.data;
  Part& body = add_body(room, work, piece, own);
  const i64 near = own.slack < 0 ? space.gap : 0;
  const i64 far = own.slack < 0 ? space.gap : own.slack;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 extent = extent_along(own, axis, own.turn);
    i64 low = own.low[axis], high = own.high[axis] - extent;
    if ((axis == 1 && own.wall == NORTH) || (axis == 0 && own.wall == WEST)) {
      low = most(low, space.low[axis] + near);
      high = least(high, space.low[axis] + far);
    } else if ((axis == 1 && own.wall == SOUTH) || (axis == 0 && own.wall == EAST)) {
      const i64 end = space.high[axis] - extent;
      low = most(low, end - far);
      high = least(high, end - near);
    }
    const i64 v = add_variable(work, axis, low, high);
    work.anchor_at.at(axis, v) = static_cast<f64>(2 * own.anchor[axis] - extent) / 2000;
    work.anchor_weight.at(axis, v) = room.candidate_costs[candidate].weight[axis];
    body.variable[axis] = v;
    body.offset[axis] = 0;
    body.extent[axis] = extent;
  }
  work.rotation[piece] = own.turn;
}

// Adds a body that stands at a slot of its parent: with the parent's variable where the slot is rigid.
static void add_attached(const Room& room, const Work& work, i64 piece, i64 candidate) {
  const CandidateRow& own = room.candidates[candidate];
  const Part& parent = work.parts[work.body_part[own.parent]];
  const i64 turn = work.rotation[own.parent];
  const i64 rotation = floor_mod(turn + own.turn, 360);
  const Point first = rotated({own.across[0], own.along[0]}, static_cast<i32>(turn));
  const Point last = rotated({own.across[1], own.along[1]}, static_cast<i32>(turn));
  Part& body = add_body(room, work, piece, own);
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 extent = extent_along(own, axis, rotation);
    const i64 one = axis == 0 ? first.x : first.z, two = axis == 0 ? last.x : last.z;
    const i64 nearest = least(one, two), farthest = most(one, two);
    const i64 low = own.low[axis], high = own.high[axis] - extent;
    const i64 u = parent.variable[axis];
    const i64 shift = floor_div(parent.extent[axis] - extent, 2) + parent.offset[axis];
    i64 v = u;
    if (nearest == farthest) {
      body.offset[axis] = shift + nearest;
      narrow(work, axis, v, low - shift - nearest, high - shift - nearest);
    } else {
      v = add_variable(work, axis, low, high);
      body.offset[axis] = 0;
      add_row(work, {axis, u, v, shift + nearest});
      add_row(work, {axis, v, u, -shift - farthest});
      const f64 middle = static_cast<f64>(2 * shift + nearest + farthest) / 2000;
      add_pull(work, {axis, u, v}, {middle, room.candidate_costs[candidate].weight[axis]});
    }
    body.variable[axis] = v;
    body.extent[axis] = extent;
  }
  work.rotation[piece] = rotation;
}

// Adds the person's square at a use side: touching it, its centre sliding along the side.
static void add_stand(const Room& room, const Work& work, i64 piece, i64 side) {
  const SpaceRow& space = *room.space.data;
  const i64 size = space.robot;
  const Part& body = work.parts[work.body_part[piece]];
  const Wall wall = facing(side, work.rotation[piece]);
  const i64 normal = wall == EAST || wall == WEST ? 0 : 1;
  const i64 along = 1 - normal;
  Part& part = work.parts[work.counts->parts++];
  part.piece = piece;
  part.stand = side;
  const i64 offset = body.offset[normal] + (wall == EAST || wall == SOUTH ? body.extent[normal] : -size);
  part.variable[normal] = body.variable[normal];
  part.offset[normal] = offset;
  part.extent[normal] = size;
  narrow(work, normal, body.variable[normal], space.low[normal] - offset, space.high[normal] - size - offset);
  const i64 start = body.offset[along], extent = body.extent[along], v = body.variable[along];
  const i64 own = add_variable(work, along, space.low[along], space.high[along] - size);
  add_row(work, {along, v, own, start - floor_div(size, 2)});
  add_row(work, {along, own, v, size - floor_div(size, 2) - extent - start});
  add_pull(work, {along, v, own}, {static_cast<f64>(2 * start + extent - size) / 2000, STAND_WEIGHT});
  part.variable[along] = own;
  part.offset[along] = 0;
  part.extent[along] = size;
  part.low = 0;
  part.high = PERSON_MM;
}

// Adds the quadratic terms of a piece's relations to the pieces before it.
static void add_links(const Room& room, const Work& work, i64 piece) {
  const Part& own = work.parts[work.body_part[piece]];
  const PieceRow& row = room.pieces[piece];
  for (i64 link = row.links[0]; link < row.links[1]; link++) {
    const i64 of = room.links[link].of;
    if (work.taken_candidate[of] == ABSENT) continue;
    const Part& other = work.parts[work.body_part[of]];
    const i64 across = floor_mod(work.rotation[of], 180) == 0 ? 0 : 1;
    for (i64 axis = 0; axis < 2; axis++) {
      f64 weight = room.link_costs[link].near;
      if (axis == across) weight += room.link_costs[link].align;
      const i64 i = other.variable[axis], j = own.variable[axis];
      if (weight > 0 && i != j) {
        const i64 middle = 2 * (other.offset[axis] - own.offset[axis]) + (other.extent[axis] - own.extent[axis]);
        add_pull(work, {axis, i, j}, {static_cast<f64>(middle) / 2000, weight});
      }
    }
  }
}

void add_piece(const Room& room, const Work& work, i64 piece, i64 candidate, i64 side) {
  if (room.candidates[candidate].parent == ABSENT) {
    add_rooted(room, work, piece, candidate);
  } else {
    add_attached(room, work, piece, candidate);
  }
  for (i64 bit = FRONT; bit <= RIGHT; bit *= 2) {
    if (room.sides[side].stands & bit) add_stand(room, work, piece, bit);
  }
  add_links(room, work, piece);
}

}  // namespace placement
