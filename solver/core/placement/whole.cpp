#include "placement/whole.hpp"

#include "placement/grow.hpp"

namespace placement {

constexpr i64 USUAL_ROBOT_MM = 600;
constexpr i64 FEW_QPS = 10;  // of an empty room
constexpr f64 ENOUGH = 400'000.0;  // work for one placement that is known to be there

// A room on a desk, and what came of it.
struct Attempt {
  Desk* desk;
  NumberedRoom asked;
  RoomReport report;
};

static Desk* desk_for(const NumberedRoom& asked) { return new_desk(asked.room, sizes_of(asked.room)); }

static Attempt arranged(const NumberedRoom& asked, const RoomLimits& limits, f64& budget, bool walk) {
  Desk* desk = desk_for(asked);
  const Engine& engine = desk->engine;
  engine.tree.budget[0] = budget;
  const RoomReport report = arrange_room(engine, desk->decisions, desk->fates, limits, walk);
  budget = engine.tree.budget[0];
  return {desk, asked, report};
}

static bool is_walkable_empty(const NumberedRoom& asked) {
  const arena::Scope scope;
  NumberedRoom empty = asked;
  empty.room.pieces.size = 0;
  Desk* desk = desk_for(empty);
  desk->engine.tree.budget[0] = ENOUGH;
  return evaluate(desk->engine, desk->decisions, FEW_QPS, INFINITE, true);
}

// How many pieces the deepest prefix of the last search holds.
static i64 deepest(const Tree& tree) {
  const i64 at = tree.counters->deepest;
  i64 count = 0;
  for (i64 k = 0; at >= 0 && k < tree.decisions.columns; k++) count += tree.decisions.at(at, k) != ABSENT;
  return count;
}

// Takes the deepest prefix of the last search for decisions.
static void take_deepest(const Desk& desk) {
  const Tree& tree = desk.engine.tree;
  const i64 at = tree.counters->deepest;
  for (i64 k = 0; k < desk.decisions.size; k++) desk.decisions[k] = at < 0 ? ABSENT : tree.decisions.at(at, k);
}

// Leaves out a required piece, and with it the floor that was asked for at it alone.
static NumberedRoom without_required(const NumberedRoom& from, i64 piece) {
  NumberedRoom left = without_piece(from, piece);
  for (i64 k = left.room.pieces.size - 1; k >= 0; k--) {
    const PieceRow& row = left.room.pieces[k];
    if (row.empty != 0 && row.required && row.candidates[0] == row.candidates[1]) left = without_piece(left, k);
  }
  return left;
}

WholeRoom arrange_whole(const Room& room, const RoomLimits& limits, f64& budget, bool walk) {
  NumberedRoom asked = numbered(room);
  WholeRoom found = {};
  found.walk = walk && is_walkable_empty(asked);
  if (!found.walk) asked = without_walking(asked);
  bool sure = true;
  Attempt last;
  for (;;) {
    last = arranged(asked, limits, budget, found.walk);
    found.solves += last.report.solves;
    if (!last.report.complete && !last.report.closed && found.walk && budget > 0) {
      const Attempt again = arranged(with_empty_floor(asked, room.space->robot - USUAL_ROBOT_MM), limits, budget, true);
      if (again.report.complete) {
        found.solves += again.report.solves - last.report.solves;
        found.with_floor = true;
        last = again;
        last.report.closed = last.report.proven = 0;
      }
    }
    if (last.report.complete || budget <= 0) break;
    sure = sure && last.report.closed;
    const i64 out = deepest(last.desk->engine.tree);
    found.left_out.add({asked.pieces[out], last.report.closed});
    asked = without_required(asked, out);
  }
  const Engine& engine = last.desk->engine;
  found.desk = last.desk;
  found.asked = last.asked;
  found.complete = last.report.complete;
  if (!found.complete) take_deepest(*found.desk);
  if (!found.complete || !engine.nodes.result->found) {  // the budget ended before: once more, for this placement alone
    engine.tree.budget[0] = ENOUGH;
    evaluate(engine, found.desk->decisions, limits.required_qps, INFINITE, found.walk);
  }
  found.proven = found.complete && last.report.proven && sure;
  found.best = found.complete && last.report.closed && found.left_out.size() == 0;
  return found;
}

bool arrange_again(const Room& room, const WholeRoom& before, i64 limit, WholeRoom& found) {
  NumberedRoom asked = before.walk ? numbered(room) : without_walking(numbered(room));
  for (const LeftOut& out : before.left_out) {
    i64 at = 0;
    while (asked.pieces[at] != out.piece) at++;
    asked = without_required(asked, at);
  }
  if (before.with_floor) asked = with_empty_floor(asked, before.asked.room.space->robot - USUAL_ROBOT_MM);
  found = before;
  found.asked = asked;
  found.desk = desk_for(asked);
  found.proven = found.best = false;
  for (i64 k = 0; k < before.desk->decisions.size; k++) found.desk->decisions[k] = before.desk->decisions[k];
  for (i64 k = 0; k < before.desk->fates.size; k++) found.desk->fates[k] = before.desk->fates[k];
  found.desk->engine.tree.budget[0] = ENOUGH;
  return evaluate(found.desk->engine, found.desk->decisions, limit, INFINITE, true);
}

}  // namespace placement
