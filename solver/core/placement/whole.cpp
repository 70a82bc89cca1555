#include "placement/whole.hpp"

#include "placement/grow.hpp"
#include "placement/memo.hpp"
#include "placement/options.hpp"

namespace placement {

constexpr i64 USUAL_ROBOT_MM = 600;
constexpr i64 FEW_QPS = 10;  // of an empty room
constexpr f64 ENOUGH = 400'000.0;  // work for one placement that is known to be there

// The widest ways first: 0.8, 0.7 and 0.65 m where the person is 0.6 m wide. Our choice.
constexpr WayMargin MARGINS[] = {{200, 0.9, 10.0}, {100, 0.8, 12.0}, {50, 0.6, 20.0}};
constexpr RoomLimits MARGIN_LIMITS = {600, 500, 16, 50, 2, 8, 24000};  // such a try is given up sooner

static Desk* desk_for(const NumberedRoom& asked) { return new_desk(asked.room, sizes_of(asked.room)); }

static void arrange(Desk* desk, const RoomLimits& limits, f64& budget, bool walk, RoomReport& report, Memo* memo = nullptr) {
  desk->engine.memo = memo;
  const Engine& engine = desk->engine;
  engine.tree.budget[0] = budget;
  report = arrange_room(engine, desk->decisions, desk->fates, limits, walk);
  desk->engine.memo = nullptr;
  budget = engine.tree.budget[0];
}

static bool is_walkable_empty(const Desk* desk) {
  for (i64& decision : desk->decisions) decision = ABSENT;
  desk->engine.tree.budget[0] = ENOUGH;
  return evaluate(desk->engine, desk->decisions, FEW_QPS, INFINITE, true);
}

// Takes the deepest prefix of the last search for decisions; returns how many pieces it holds.
static i64 take_deepest(const Tree& tree, const Decisions& decisions) {
  const i64 at = tree.counters->deepest;
  i64 count = 0;
  for (i64 k = 0; k < tree.decisions.columns && k < decisions.size; k++) {
    decisions[k] = at < 0 ? ABSENT : tree.decisions.at(at, k);
    count += decisions[k] != ABSENT;
  }
  return count;
}

// Finds a placement of decisions that were reached under other bounds; else of all but the last of them. They are known to go together:
// work alone limits the search, for a piece that is let go is missed.
static void find_again(Desk& desk, bool walk) {
  const Decisions& decisions = desk.decisions;
  const auto is_found = [&] {
    desk.engine.tree.budget[0] = ENOUGH;
    return evaluate(desk.engine, decisions, MANY, INFINITE, walk);
  };
  if (is_found()) return;
  for (i64 last = decisions.size; last > 0;) {
    if (decisions[--last] == ABSENT) continue;
    decisions[last] = ABSENT;
    desk.fates[last] = SPENT;
    if (is_found()) return;
  }
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

// Notes what came of a room that is arranged.
static void conclude(WholeRoom& found, const RoomReport& report, bool sure) {
  found.complete = report.complete;
  if (!found.complete || !found.desk->engine.nodes.result->found) find_again(*found.desk, found.walk);
  found.proven = found.complete && report.proven && sure;
  found.best = found.complete && report.closed && found.left_out.size() == 0;
}

// Goes on with a room that was given up beside another rival.
static void go_on(WholeRoom& found, const RoomLimits& limits, Memo* memo) {
  Desk& desk = *found.desk;
  memo->given_up = false;
  desk.engine.memo = memo;
  const RoomReport report = fill_room(desk.engine, desk.decisions, memo->filling, desk.fates, limits, true);
  desk.engine.memo = nullptr;
  found.solves = report.solves;
  if (!memo->given_up) conclude(found, report, true);
}

// The same as `arrange_whole`; what all pieces' ways come to is noted in the memo, or recalled from it.
static WholeRoom arrange_whole(const Room& room, const RoomLimits& limits, f64& budget, bool walk, Memo* memo) {
  NumberedRoom asked = numbered(room);
  WholeRoom found = {};
  const Span<i64> prefix = reserved<i64>(static_cast<i32>(room.pieces.size));
  bool sure = true;
  RoomReport report;
  arena::Mark mark = arena::mark();  // what was tried in vain is given back
  found.desk = desk_for(asked);
  found.walk = walk && is_walkable_empty(found.desk);
  if (!found.walk) {
    arena::release(mark);
    asked = without_walking(asked);
    mark = arena::mark();
    found.desk = desk_for(asked);
  }
  for (;;) {
    found.asked = asked;
    const bool is_first = found.left_out.size() == 0;
    arrange(found.desk, limits, budget, found.walk, report, is_first && found.walk ? memo : nullptr);
    found.solves += report.solves;
    if (report.complete) break;
    const RoomReport without = report;
    const i64 out = take_deepest(found.desk->engine.tree, prefix);
    arena::release(mark);
    if (!report.closed && found.walk && budget > 0) {
      found.asked = with_empty_floor(asked, room.space->robot - USUAL_ROBOT_MM);
      found.desk = desk_for(found.asked);
      arrange(found.desk, limits, budget, true, report);
      if (report.complete) {
        found.solves += report.solves - without.solves;
        found.with_floor = true;
        report.closed = report.proven = 0;
        break;
      }
      arena::release(mark);
    }
    report = without;
    if (budget <= 0) {
      found.asked = asked;
      found.desk = desk_for(asked);
      for (i64 k = 0; k < found.desk->decisions.size; k++) found.desk->decisions[k] = prefix[k];
      break;
    }
    sure = sure && report.closed;
    found.left_out.add({asked.pieces[out], report.closed});
    asked = without_required(asked, out);
    mark = arena::mark();
    found.desk = desk_for(asked);
  }
  if (memo == nullptr || !memo->given_up) conclude(found, report, sure);
  return found;
}

WholeRoom arrange_whole(const Room& room, const RoomLimits& limits, f64& budget, bool walk) {
  return arrange_whole(room, limits, budget, walk, nullptr);
}

static bool is_walked_in(const WholeRoom& whole) { return whole.walk && whole.desk->engine.nodes.result->found; }

static Standing standing_in(const WholeRoom& whole) {
  const Engine& engine = whole.desk->engine;
  const Decisions& decisions = whole.desk->decisions;
  return standing(engine.room, decisions, decisions.size, engine.nodes.best_cost[0] + total_preference(engine.room, decisions));
}

// The same room with ways between its doors that are wider than its person.
static Room with_ways(Room room, i64 wider) {
  const Span<SpaceRow> space = reserved<SpaceRow>(1);
  space[0] = *room.space.data;
  space[0].ways = room.space->robot + wider;
  room.space.data = space.data;
  return room;
}

WholeRoom arrange_wide(const Room& room, const RoomLimits& limits, f64 budget, f64& spent) {
  const auto arranged = [&](const Room& asked, const RoomLimits& own, Memo* memo, i64 wider) {
    f64 left = budget;
    if (memo != nullptr) {
      memo->given_up = false;
      memo->ways = room.space->robot + wider;
    }
    const WholeRoom found = arrange_whole(asked, own, left, true, memo);
    spent += budget - left;
    return found;
  };
  if (room.doors.size < 2) return arranged(room, limits, nullptr, 0);
  Memo* memo = new_memo(room);
  memo->margin = MARGINS;
  memo->rival = best_standing(room, {}, 0);
  // Nearly always the widest ways are taken, so that these are asked first; much of what was searched for them holds without them, too.
  WholeRoom wide = arranged(with_ways(room, MARGINS[0].wider), MARGIN_LIMITS, memo, MARGINS[0].wider);
  memo->complete = true;
  wide.ways = room.space->robot + MARGINS[0].wider;
  if (is_walked_in(wide)) {
    const bool is_usual = wide.best && memo->closed == 0;  // no wider way made a difference
    if (is_usual || (wide.proven && is_worth(MARGINS[0], standing_in(wide), memo->rival))) return wide;
  }
  const bool given_up = memo->given_up;
  const Filling filling = memo->filling;
  memo->margin = nullptr;
  const WholeRoom usual = arranged(room, limits, memo, MARGINS[1].wider);
  if (!is_walked_in(usual)) return usual;
  memo->rival = standing_in(usual);
  for (const WayMargin& margin : MARGINS) {
    const arena::Mark mark = arena::mark();
    memo->margin = &margin;
    if (margin.wider != MARGINS[0].wider) {
      wide = arranged(with_ways(room, margin.wider), MARGIN_LIMITS, memo, margin.wider);
    } else if (given_up && is_worth(margin, memo->hoped, memo->rival)) {
      const f64 left = wide.desk->engine.tree.budget[0];
      memo->filling = filling;
      memo->ways = wide.ways;
      go_on(wide, MARGIN_LIMITS, memo);
      spent += left - wide.desk->engine.tree.budget[0];
    }
    wide.ways = room.space->robot + margin.wider;
    const bool stands = is_walked_in(wide) && (wide.proven || !usual.proven);
    if (stands && is_worth(margin, standing_in(wide), memo->rival)) return wide;
    arena::release(mark);
  }
  return usual;
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
