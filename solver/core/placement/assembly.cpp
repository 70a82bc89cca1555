#include "placement/assembly.hpp"

#include "placement/frames.hpp"
#include "placement/narrow.hpp"

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
  const Point wish = rotated({own.anchor[0], own.anchor[1]}, static_cast<i32>(turn));
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
      const f64 apart = static_cast<f64>(2 * shift + (axis == 0 ? wish.x : wish.z)) / 2000;
      add_pull(work, {axis, u, v}, {apart, room.candidate_costs[candidate].weight[axis]});
    }
    body.variable[axis] = v;
    body.extent[axis] = extent;
  }
  work.rotation[piece] = rotation;
}

// Adds the person's square at a use side: touching it, its centre sliding along the side.
static void add_stand(const Room& room, const Work& work, i64 piece, i64 side) {
  const SpaceRow& space = *room.space.data;
  const i64 inset = room.sides[work.taken_side[piece]].inset;
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
  add_row(work, {along, v, own, start + inset - floor_div(size, 2)});
  add_row(work, {along, own, v, size - floor_div(size, 2) - extent - start + inset});
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

// Rigid companions share their parent's variables, so that nothing has to be searched between them.
//
// Adds a piece at its candidate: its body, the persons' squares of its choice of sides, and the terms of its relations.
static void add_piece(const Room& room, const Work& work, i64 piece, i64 candidate, i64 side) {
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

constexpr i64 DROP_ROUNDS = 4;  // passes over what a piece adds, at most; fewer only leave more to the search

static bool stands_already(const Room& room, const Part& part) { return part.stand == 0 && room.pieces[part.piece].required == STANDS; }

// Tells whether two parts must not share space.
static bool must_part(const Room& room, const Work& work, const Part& a, const Part& b) {
  if (a.piece == b.piece || (a.stand != 0 && b.stand != 0)) return false;
  if (a.high <= b.low || b.high <= a.low) return false;
  if (a.stand != 0 || b.stand != 0) return true;
  if (stands_already(room, a) && stands_already(room, b)) return false;
  const CandidateRow& one = room.candidates[work.taken_candidate[a.piece]];
  const CandidateRow& two = room.candidates[work.taken_candidate[b.piece]];
  return one.under != b.piece && one.on != b.piece && two.under != a.piece && two.on != a.piece;
}

// Tells whether a row may hold.
static bool is_within_reach(const Work& work, const DifferenceRow& row) {
  if (row.i == row.j) return row.s <= 0;
  return bound_of(work.most, row.axis, row.j) - bound_of(work.least, row.axis, row.i) >= row.s;
}

// Adds an option to the `size` ones that a choice has where it is within reach.
static inline void offer(const Work& work, i64 choice, i64& size, const DifferenceRow& row) {
  if (is_within_reach(work, row)) work.options[OPTIONS * choice + size++] = row;
}

// Writes the options that keep a part apart from another, or from what does not move: left of, right of, north of, south of it; false where
// the bounds do.
static bool keep_apart(const Work& work, i64 choice, const Part& a, const Part& b) {
  i64 a_first[2], b_first[2];
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 u = a.variable[axis], v = b.variable[axis], shift = a.offset[axis] - b.offset[axis];
    a_first[axis] = a.extent[axis] + shift, b_first[axis] = b.extent[axis] - shift;
    const i64 after = u == v ? 0 : bound_of(work.low, axis, v) - work.high.at(axis, u);
    const i64 before = u == v ? 0 : work.low.at(axis, u) - bound_of(work.high, axis, v);
    if (after >= a_first[axis] || before >= b_first[axis]) return false;
  }
  i64 size = 0;
  for (i64 axis = 0; axis < 2; axis++) {
    offer(work, choice, size, {axis, a.variable[axis], b.variable[axis], a_first[axis]});
    offer(work, choice, size, {axis, b.variable[axis], a.variable[axis], b_first[axis]});
  }
  work.choice_size[choice] = size;
  return true;
}

// Narrows what is within reach by a choice with one option; tells whether it did. A choice that cannot hold is left without any.
static bool narrow_by(const Work& work, i64 choice) {
  if (work.choice_size[choice] != 1) return false;
  const Step step = tighten(work.least, work.most, work.options[OPTIONS * choice]);
  if (step == Step::IMPOSSIBLE) work.choice_size[choice] = 0;
  return step == Step::CHANGED;
}

// Drops the options of the choices from number `first` on that are out of reach; tells whether that narrowed what is within it.
static bool drop_options(const Work& work, i64 first) {
  bool narrowed = false;
  for (i64 choice = first; choice < work.counts->choices; choice++) {
    const i64 begin = OPTIONS * choice, end = begin + work.choice_size[choice];
    i64& kept = work.choice_size[choice] = 0;
    for (i64 k = begin; k < end; k++) {
      if (is_within_reach(work, work.options[k])) work.options[begin + kept++] = work.options[k];
    }
    narrowed |= narrow_by(work, choice);
  }
  return narrowed;
}

// Appends the choices of the parts from number `first` on: against zones, against the parts before them; false where one cannot hold, with
// which it ends unless all are asked for.
static bool add_choices(const Room& room, const Work& work, i64 first, bool all) {
  const i64 known = work.counts->choices;
  i64& choice = work.counts->choices;
  bool narrowed = false, may_hold = true;
  const auto add = [&](const ChoiceParts& parts) {
    work.choice_parts[choice] = parts;
    narrowed |= narrow_by(work, choice);
    may_hold = all || work.choice_size[choice] > 0;
    choice++;
  };
  for (i64 b = first; b < work.counts->parts && may_hold; b++) {
    const Part& part = work.parts[b];
    for (i64 k = 0; k < room.zones.size && may_hold && !stands_already(room, part); k++) {
      const Zone& zone = room.zones[k];
      if (zone.is_wall == 0 && (part.stand != 0 || part.high <= zone.above)) continue;
      if (keep_apart(work, choice, part, unmoved(zone))) add({{b, -1 - k}});
    }
    for (i64 a = 0; a < b && may_hold; a++) {
      const Part& other = work.parts[a];
      if (must_part(room, work, other, part) && keep_apart(work, choice, other, part)) add({{a, b}});
    }
  }
  for (i64 round = 0; round < DROP_ROUNDS && narrowed && may_hold; round++) narrowed = drop_options(work, known);
  for (i64 k = known; k < choice; k++) may_hold &= all || work.choice_size[k] > 0;
  return may_hold;
}

bool bounds_hold(const Work& work) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      if (work.low.at(axis, v) > work.high.at(axis, v)) return false;
    }
  }
  return true;
}

// Copies the bounds of all variables to where they are marked for a piece, or back.
template <bool back> static void copy_bounds(const Work& work, i64 piece) {
  const Table<i64>* const all[] = {&work.low, &work.high, &work.least, &work.most};
  for (i64 k = 0; k < 8; k++) {
    const Span<i64> own = all[k / 2]->row(k % 2), marked = work.marked_bounds.row(piece, k), &to = back ? own : marked;
    for (i64 v = 0; v < work.sizes[k % 2]; v++) to[v] = (back ? marked : own)[v];
  }
}

// Notes what the problem is once a piece was added, so that the next problem can go on from there.
static void note(const Work& work, i64 piece, i64 decision) {
  const Counts& counts = *work.counts.data;
  const i64 wide = work.sizes[0], deep = work.sizes[1], last = piece > 0 ? work.marks[piece - 1].bounds : -1;
  const i64 bounds = decision == ABSENT ? last : piece;
  work.marks[piece] = {decision, {wide, deep}, counts.rows, counts.parts, counts.choices, counts.pulls, bounds};
  if (decision != ABSENT) copy_bounds<false>(work, piece);
}

// Brings back the problem of as many pieces as are decided as they were last; returns how many.
static i64 go_back(const Work& work, const Decisions& decisions) {
  Counts& counts = *work.counts.data;
  const i64 known = counts.assembled;
  i64 first = 0;
  while (first < known && work.marks[first].decision == decisions[first]) first++;
  const Mark mark = first > 0 ? work.marks[first - 1] : Mark{};
  counts.rows = mark.rows;
  counts.parts = mark.parts;
  counts.choices = mark.choices;
  counts.placed = least(counts.placed, mark.choices);
  counts.pulls = mark.pulls;
  for (i64 axis = 0; axis < 2; axis++) work.sizes[axis] = mark.sizes[axis];
  if (mark.bounds >= 0) copy_bounds<true>(work, mark.bounds);
  return first;
}

// Nothing but the bounds is known of variables that are new, and of others no less.
static void reach_bounds(const Work& work, const i64 (&known)[2]) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      const i64 low = work.low.at(axis, v), high = work.high.at(axis, v);
      work.least.at(axis, v) = v < known[axis] ? most(work.least.at(axis, v), low) : low;
      work.most.at(axis, v) = v < known[axis] ? least(work.most.at(axis, v), high) : high;
    }
  }
}

bool assemble(const Room& room, const Work& work, const Decisions& decisions, bool all) {
  i64& last = work.counts->assembled;
  i64 piece = go_back(work, decisions);
  for (i64 k = piece; k < last; k++) work.taken_candidate[k] = ABSENT;
  for (last = decisions.size; last > piece && decisions[last - 1] == ABSENT;) last--;  // what is left out behind all others adds nothing
  for (; piece < last; piece++) {
    if (decisions[piece] != ABSENT) {
      const Counts known = *work.counts.data;
      const i64 sizes[] = {work.sizes[0], work.sizes[1]};
      const i64 candidate = candidate_of(decisions[piece]);
      const i64 side = room.pieces[piece].sides[0] + sides_of(decisions[piece]);
      work.taken_candidate[piece] = candidate;
      work.taken_side[piece] = side;
      add_piece(room, work, piece, candidate, side);
      reach_bounds(work, sizes);
      for (i64 k = known.rows; k < work.counts->rows; k++) tighten(work.least, work.most, work.rows[k]);
      if (!add_choices(room, work, known.parts, all)) {
        work.taken_candidate[piece] = ABSENT;
        last = piece;
        return false;
      }
    }
    note(work, piece, decisions[piece]);
  }
  return bounds_hold(work);
}

}  // namespace placement
