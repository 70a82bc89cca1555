#include "drag/drag.hpp"

#include "placement/assembly.hpp"
#include "placement/pull.hpp"
#include "placement/search.hpp"
#include "placement/settle.hpp"
#include "plain/rounding.hpp"

namespace drag {

using placement::CandidateRow;
using placement::Engine;
using placement::Part;

constexpr i64 MOST_QPS = 400;    // of one frame's search
constexpr i64 MOST_WALKS = 120;  // of going back from the last frame
constexpr f64 ANY_COST = 1e12;
constexpr i64 ANYWHERE = 1'000'000'000;  // mm
constexpr f64 AS_SENT = 0.00051;  // a neighbour this near to where it was at the start is there, m

static i64 millimetres(f64 metres) { return whole(floor(metres * 1000 + 0.5)); }

// To a tenth of a millimetre, as spots of what is carried are written.
static f64 rounded_4(f64 x) { return rounded_decimal<10'000, 429'496'729'600>(x); }

static i64 extent_of(const CandidateRow& row, i64 axis) {
  const bool across = row.turn == 90 || row.turn == 270;
  return across == (axis == 0) ? row.depth : row.width;
}

// The lesser corner of a footprint whose middle is there, mm.
static i64 corner(const CandidateRow& row, i64 axis, const Spot& spot) {
  const f64 middle = axis == 0 ? spot.x : spot.z;
  return whole(floor(middle * 1000 - static_cast<f64>(extent_of(row, axis)) / 2 + 0.5));
}

// Leaves a way the places within reach of one, whose lesser corner is there; false where there are none.
static bool keep_near(CandidateRow& row, const CandidateRow& sent, const i64 (&at)[2], i64 reach) {
  row = sent;
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 extent = extent_of(sent, axis);
    if (sent.high[axis] - sent.low[axis] == extent) continue;  // it stays where it is
    row.low[axis] = most(sent.low[axis], at[axis] - reach);
    row.high[axis] = least(sent.high[axis], at[axis] + extent + reach);
    if (row.high[axis] - row.low[axis] < extent) return false;
  }
  return true;
}

// Wishes the piece in hand somewhere, and leaves it the places that are, by the farther axis, no more than `farther` farther from there
// than it is, or from the nearest place that it may have.
static bool keep_nearing(CandidateRow& row, const CandidateRow& sent, const Spot& spot, const Spot& wish, i64 farther) {
  i64 nearest[2], away = 0;
  for (i64 axis = 0; axis < 2; axis++) {
    nearest[axis] = least(most(corner(sent, axis, wish), sent.low[axis]), sent.high[axis] - extent_of(sent, axis));
    away = most(away, magnitude(corner(sent, axis, spot) - nearest[axis]));
  }
  const bool is_possible = keep_near(row, sent, nearest, away + farther);
  row.anchor[0] = millimetres(wish.x), row.anchor[1] = millimetres(wish.z);
  return is_possible;
}

// Chooses every piece's first way that is within reach of the last frame, and wishes the piece in hand where the frame says: it may go
// `farther` from there.
static bool aim(const Drag& drag, const Frame& frame, i64 farther) {
  const placement::Room& room = drag.desk->engine.room;
  for (i64 k = 0; k < drag.movers.size; k++) {
    i64 chosen = placement::ABSENT;
    for (i64 c = room.pieces[k].candidates[0]; c < room.pieces[k].candidates[1] && chosen == placement::ABSENT; c++) {
      CandidateRow& row = room.candidates[c];
      const CandidateRow& sent = drag.sent[c];
      const Spot& spot = frame.spots[drag.movers[k].body];
      const i64 at[] = {corner(sent, 0, spot), corner(sent, 1, spot)};
      row = sent;
      const bool is_held = k == drag.held;
      if (is_held ? keep_nearing(row, sent, spot, frame.wish, farther)
                  : sent.parent >= 0 || keep_near(row, sent, at, drag.movers[k].reach)) chosen = c;
    }
    if (chosen == placement::ABSENT) return false;
    drag.desk->decisions[k] = 8 * chosen;
  }
  drag.desk->engine.work.counts->assembled = 0;  // candidates have changed under the same numbers
  return placement::assemble(room, drag.desk->engine.work, drag.desk->decisions);
}

// Searches for what costs less; leaves the places on whole millimetres. False where none is found within the count.
static bool find_best(const Drag& drag) {
  const placement::Desk& desk = *drag.desk;
  placement::search(desk.engine, MOST_QPS, ANY_COST, true);
  return desk.engine.nodes.result->found == 1 && placement::settle(desk, true, false) == placement::Settled::walkable;
}

// Puts every piece where it was in the last frame.
static void put_back(const Drag& drag, const Frame& last) {
  const Engine& engine = drag.desk->engine;
  for (i64 k = 0; k < drag.movers.size; k++) {
    const CandidateRow& row = engine.room.candidates[placement::candidate_of(drag.desk->decisions[k])];
    if (row.parent >= 0) continue;
    const Part& part = engine.work.parts[engine.work.body_part[k]];
    for (i64 axis = 0; axis < 2; axis++) {
      engine.grid.positions.at(axis, part.variable[axis]) = corner(row, axis, last.spots[drag.movers[k].body]);
    }
  }
}

// Where a piece's middle is; exactly where it was at the start if it is no farther away than the rounding.
static Spot spot_of(const Drag& drag, i64 piece) {
  const Engine& engine = drag.desk->engine;
  const Part& part = engine.work.parts[engine.work.body_part[piece]];
  f64 middle[2];
  for (i64 axis = 0; axis < 2; axis++) {
    const i64 low = engine.grid.positions.at(axis, part.variable[axis]) + part.offset[axis];
    middle[axis] = static_cast<f64>(2 * low + part.extent[axis]) / 2000;
  }
  const Spot& start = drag.start[drag.movers[piece].body];
  const bool at_start = absolute(middle[0] - start.x) < AS_SENT && absolute(middle[1] - start.z) < AS_SENT;
  return at_start && piece != drag.held ? start : Spot{middle[0], middle[1]};
}

// Writes where all bodies are with the pieces at their whole millimetres: those that are carried, or stand at another, go along.
static void write_spots(const Drag& drag, Frame& frame) {
  for (i64 k = 0; k < drag.riders.size; k++) {
    const Spot& start = drag.start[k];
    const i64 piece = drag.riders[k].piece;
    frame.spots[k] = start;
    if (piece < 0) continue;
    const Spot now = spot_of(drag, piece), &before = drag.start[drag.movers[piece].body];
    if (drag.movers[piece].body == k) {
      frame.spots[k] = now;
    } else if (now.x != before.x || now.z != before.z) {
      frame.spots[k] = {rounded_4(now.x + (start.x - before.x)), rounded_4(now.z + (start.z - before.z))};
    }
  }
}

static bool write_valid(const Drag& drag, Frame& frame) {
  write_spots(drag, frame);
  return is_valid(drag, frame);
}

// Answers the frame; `walks` comes in as how many are allowed and goes out as how many are left.
static Outcome outcome_of(const Drag& drag, const Frame& last, Frame& frame, i64& walks) {
  if (!aim(drag, last, drag.movers[drag.held].reach)) return Outcome::none;
  const auto is_found = [&] { return find_best(drag) && write_valid(drag, frame); };
  if (is_found()) return Outcome::placed;
  put_back(drag, last);
  if (placement::pull_back(drag.desk->engine, walks) && write_valid(drag, frame)) return Outcome::drawn;
  put_back(drag, last);
  if (write_valid(drag, frame)) return Outcome::stayed;
  return aim(drag, last, ANYWHERE) && is_found() ? Outcome::placed : Outcome::none;  // all stood wrongly when the drag began
}

void answer(const Drag& drag, Frame& frame) {
  const arena::Scope scope;
  const i64 size = static_cast<i64>(sizeof(Spot)) * (1 + drag.riders.size);
  Frame& last = *static_cast<Frame*>(arena::reserve(size));
  __builtin_memcpy(&last, &frame, static_cast<unsigned long>(size));
  for (i64 k = 0; k < drag.riders.size; k++) {
    if (!(absolute(last.spots[k].x) < 1e6 && absolute(last.spots[k].z) < 1e6)) last.spots[k] = drag.start[k];
  }
  *drag.desk->engine.nodes.result.data = {};
  i64 walks = MOST_WALKS;
  const Outcome outcome = outcome_of(drag, last, frame, walks);
  frame.outcome = static_cast<f64>(outcome);
  frame.work = static_cast<f64>(drag.desk->engine.nodes.result->solves + MOST_WALKS - walks);
}

}  // namespace drag
