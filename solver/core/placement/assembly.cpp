#include "placement/assembly.hpp"

#include "placement/narrow.hpp"
#include "placement/parts.hpp"

namespace placement {

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

// Appends the choices of the parts from number `first` on: against zones, against the parts before them.
static void add_choices(const Room& room, const Work& work, i64 first) {
  const i64 known = work.counts->choices;
  i64& choice = work.counts->choices;
  bool narrowed = false;
  const auto add = [&](const ChoiceParts& parts) {
    work.choice_parts[choice] = parts;
    narrowed |= narrow_by(work, choice++);
  };
  for (i64 b = first; b < work.counts->parts; b++) {
    const Part& part = work.parts[b];
    for (i64 k = 0; k < room.zones.size && !stands_already(room, part); k++) {
      const Zone& zone = room.zones[k];
      if (zone.is_wall == 0 && (part.stand != 0 || part.high <= zone.above)) continue;
      if (keep_apart(work, choice, part, unmoved(zone))) add({{b, -1 - k}});
    }
    for (i64 a = 0; a < b; a++) {
      const Part& other = work.parts[a];
      if (must_part(room, work, other, part) && keep_apart(work, choice, other, part)) add({{a, b}});
    }
  }
  for (i64 round = 0; round < DROP_ROUNDS && narrowed; round++) narrowed = drop_options(work, known);
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

bool assemble(const Room& room, const Work& work, const Decisions& decisions) {
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
      add_choices(room, work, known.parts);
    }
    note(work, piece, decisions[piece]);
  }
  return bounds_hold(work);
}

}  // namespace placement
