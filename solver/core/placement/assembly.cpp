#include "placement/assembly.hpp"

#include "placement/barriers.hpp"
#include "placement/parts.hpp"

namespace placement {

// Tells whether two parts must not share space.
static bool must_part(const Room& room, const Work& work, const Part& a, const Part& b) {
  if (a.piece == b.piece || (a.stand != 0 && b.stand != 0)) return false;
  if (a.high <= b.low || b.high <= a.low) return false;
  if (a.stand != 0 || b.stand != 0) return true;
  const CandidateRow& one = room.candidates[work.taken_candidate[a.piece]];
  const CandidateRow& two = room.candidates[work.taken_candidate[b.piece]];
  return one.under != b.piece && one.on != b.piece && two.under != a.piece && two.on != a.piece;
}

// Adds an option to a choice where the least and the most that the bounds allow it allow it; true where they hold it anyway.
static bool offer(const Work& work, i64 choice, i64 lowest, i64 highest, const DifferenceRow& row) {
  if (lowest >= row.s) return true;
  if (highest >= row.s) work.options[OPTIONS * choice + work.choice_size[choice]++] = row;
  return false;
}

// Writes the options that keep two parts apart, a left of, right of, north of, south of b; false where the bounds do.
static bool keep_apart(const Work& work, i64 choice, const Part& a, const Part& b) {
  work.choice_size[choice] = 0;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 u = a.variable[axis], v = b.variable[axis];
    const i64 shift = a.offset[axis] - b.offset[axis];
    const i64 lowest = u == v ? 0 : work.low.at(axis, v) - work.high.at(axis, u);
    const i64 highest = u == v ? 0 : work.high.at(axis, v) - work.low.at(axis, u);
    if (offer(work, choice, lowest, highest, {axis, u, v, a.extent[axis] + shift})) return false;
    if (offer(work, choice, -highest, -lowest, {axis, v, u, b.extent[axis] - shift})) return false;
  }
  return true;
}

// Writes the options that keep a part out of a zone; false where the bounds do.
static bool keep_clear(const Work& work, i64 choice, const Part& part, const Zone& zone) {
  work.choice_size[choice] = 0;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 v = part.variable[axis], offset = part.offset[axis];
    const i64 lowest = work.low.at(axis, v), highest = work.high.at(axis, v);
    if (offer(work, choice, -highest, -lowest, {axis, v, ORIGIN, part.extent[axis] + offset - zone.low[axis]})) return false;
    if (offer(work, choice, lowest, highest, {axis, ORIGIN, v, zone.high[axis] - offset})) return false;
  }
  return true;
}

// Appends the choices of the parts from number `first` on: against zones, against the parts before them.
static void add_choices(const Room& room, const Work& work, i64 first) {
  i64 choice = work.counts->choices;
  for (i64 b = first; b < work.counts->parts; b++) {
    const Part& part = work.parts[b];
    for (i64 k = 0; k < room.zones.size; k++) {
      const Zone& zone = room.zones[k];
      if (zone.is_wall == 0 && (part.stand != 0 || part.high <= zone.above)) continue;
      if (keep_clear(work, choice, part, zone)) work.choice_parts[choice++] = {{b, -1 - k}};
    }
    for (i64 a = 0; a < b; a++) {
      const Part& other = work.parts[a];
      if (must_part(room, work, other, part) && keep_apart(work, choice, other, part)) work.choice_parts[choice++] = {{a, b}};
    }
  }
  work.counts->choices = choice;
}

static bool bounds_hold(const Work& work) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      if (work.low.at(axis, v) > work.high.at(axis, v)) return false;
    }
  }
  return true;
}

// Notes what the problem is once a piece was added, so that the next problem can go on from there.
static void note(const Work& work, i64 piece, i64 decision) {
  const Counts& counts = *work.counts.data;
  const i64 wide = work.sizes[0], deep = work.sizes[1], last = piece > 0 ? work.marks[piece - 1].bounds : -1;
  const i64 bounds = decision == ABSENT ? last : piece;
  work.marks[piece] = {decision, {wide, deep}, counts.rows, counts.parts, counts.choices, counts.pulls, bounds};
  for (i64 axis = 0; axis < 2 && decision != ABSENT; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      work.marked_bounds.at(piece, axis, v) = work.low.at(axis, v);
      work.marked_bounds.at(piece, 2 + axis, v) = work.high.at(axis, v);
    }
  }
}

// Brings back the problem of as many pieces as are decided as they were last; returns how many.
static i64 go_back(const Work& work, const Decisions& decisions) {
  Counts& counts = *work.counts.data;
  const i64 known = least<i64>(counts.assembled, decisions.size);
  i64 first = 0;
  while (first < known && work.marks[first].decision == decisions[first]) first++;
  const Mark mark = first > 0 ? work.marks[first - 1] : Mark{};
  counts.rows = mark.rows;
  counts.parts = mark.parts;
  counts.choices = mark.choices;
  counts.placed = least(counts.placed, mark.choices);
  counts.pulls = mark.pulls;
  for (i64 axis = 0; axis < 2; axis++) {
    work.sizes[axis] = mark.sizes[axis];
    for (i64 v = 0; v < mark.sizes[axis]; v++) {
      work.low.at(axis, v) = work.marked_bounds.at(mark.bounds, axis, v);
      work.high.at(axis, v) = work.marked_bounds.at(mark.bounds, 2 + axis, v);
    }
  }
  return first;
}

bool assemble(const Room& room, const Work& work, const Decisions& decisions) {
  for (i64 piece = go_back(work, decisions); piece < decisions.size; piece++) {
    work.taken_candidate[piece] = ABSENT;
    if (decisions[piece] != ABSENT) {
      const i64 candidate = candidate_of(decisions[piece]), known = work.counts->parts;
      const i64 side = room.pieces[piece].sides[0] + sides_of(decisions[piece]);
      work.taken_candidate[piece] = candidate;
      work.taken_side[piece] = side;
      add_piece(room, work, piece, candidate, side);
      add_barriers(room, work, known);
      add_choices(room, work, known);
    }
    note(work, piece, decisions[piece]);
  }
  work.counts->assembled = decisions.size;
  return bounds_hold(work);
}

}  // namespace placement
