#include "placement/memo.hpp"

#include "placement/grow.hpp"

namespace placement {

constexpr i32 MOST_NOTES = 1024;
constexpr i32 TABLE = 2 * MOST_NOTES;
constexpr i32 MOST_PLACES = 32 * MOST_NOTES;

Memo* new_memo(const Room& room) {
  Memo& memo = *zeroes<Memo>(1).data;
  memo.noted = reserved<Noted>(MOST_NOTES);
  memo.decisions = {reserved<i64>(MOST_NOTES * room.pieces.size).data, MOST_NOTES, room.pieces.size};
  memo.table = reserved<i32>(TABLE);
  memo.places = reserved<f64>(MOST_PLACES);
  for (i32& number : memo.table) number = -1;
  return &memo;
}

Standing best_standing(const Room& room, const Decisions& decisions, i64 decided) {
  Standing found = {0, 0.0, 0.0};
  for (i32 k = 0; k < room.pieces.size; k++) {
    const PieceRow& row = room.pieces[k];
    if (k < decided && decisions[k] == ABSENT) {
      found.cost += room.skip_costs[k];
      continue;
    }
    f64 way = INFINITE, side = INFINITE;
    for (i64 one = row.candidates[0]; one < row.candidates[1]; one++) way = least(way, room.candidate_costs[one].cost);
    for (i64 one = row.sides[0]; one < row.sides[1]; one++) side = least(side, room.side_costs[one]);
    if (!row.required) found.cost += least(way + side, room.skip_costs[k]);
    else if (way < INFINITE) found.cost += way + side;
    if (row.empty != 0) continue;
    if (row.required) found.required++;
    else found.worth += room.skip_costs[k];
  }
  return found;
}

Standing standing(const Room& room, const Decisions& decisions, i64 decided, f64 cost) {
  Standing found = {0, 0.0, cost};
  for (i32 k = 0; k < room.pieces.size; k++) {
    if (k < decided && decisions[k] == ABSENT) {
      found.cost += room.skip_costs[k];
    } else if (room.pieces[k].required) {
      found.required += room.pieces[k].empty == 0;
    } else if (room.pieces[k].empty == 0) {
      found.worth += room.skip_costs[k];
    }
  }
  return found;
}

bool is_worth(const WayMargin& margin, const Standing& wide, const Standing& usual) {
  if (wide.required < usual.required || wide.worth < margin.worth * usual.worth) return false;
  return wide.cost <= usual.cost + margin.most;
}

bool is_hopeless(const Room& room, const Decisions& decisions, i64 decided, i64 closed, Memo* memo) {
  if (memo == nullptr || memo->margin == nullptr) return false;
  if (!memo->complete && memo->closed == 0) {
    if (closed) memo->rival = best_standing(room, decisions, decided);
    return false;
  }
  memo->hoped = standing(room, decisions, decided, 0.0);
  memo->given_up = !is_worth(*memo->margin, memo->hoped, memo->rival);
  return memo->given_up;
}

// Where in the table what is asked may be; the ceiling is compared where the decisions are the same.
static i32 place_in_table(const Decisions& decisions) {
  u64 hash = 0;
  for (const i64 decision : decisions) hash = mixed(hash, decision);
  return static_cast<i32>(hash >> 32) & (TABLE - 1);
}

void note(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, const Effort& effort) {
  Memo& memo = *engine.memo;
  const SearchResult& result = *engine.nodes.result.data;
  const i64 wide = result.found ? engine.work.sizes[0] : 0, deep = result.found ? engine.work.sizes[1] : 0;
  if (memo.notes == MOST_NOTES || memo.placed + wide + deep > memo.places.size) return;
  const i32 number = memo.notes++;
  memo.noted[number] = {limit, memo.ways, ceiling, engine.nodes.best_cost[0], effort, memo.placed, {wide, deep}, result};
  for (i64 v = 0; v < wide; v++) memo.places[memo.placed++] = engine.nodes.best.at(0, v);
  for (i64 v = 0; v < deep; v++) memo.places[memo.placed++] = engine.nodes.best.at(1, v);
  for (i32 k = 0; k < decisions.size; k++) memo.decisions.at(number, k) = decisions[k];
  i32 at = place_in_table(decisions);
  while (memo.table[at] >= 0) at = (at + 1) & (TABLE - 1);
  memo.table[at] = number;
}

static bool is_noted(const Span<i64>& a, const Decisions& b) {
  for (i32 k = 0; k < b.size; k++) {
    if (a[k] != b[k]) return false;
  }
  return true;
}

// Tells whether a search that was made within one limit goes the same way within another.
static bool is_within(const Noted& noted, i64 limit) {
  return limit == noted.limit || (noted.result.exhausted && noted.result.solves < limit);
}

const Effort* recall(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling) {
  const Memo& memo = *engine.memo;
  for (i32 at = place_in_table(decisions); memo.table[at] >= 0; at = (at + 1) & (TABLE - 1)) {
    const i32 number = memo.table[at];
    const Noted& noted = memo.noted[number];
    if (noted.ceiling != ceiling || noted.ways < engine.room.space->ways || !is_noted(memo.decisions.row(number), decisions)) continue;
    if (!is_within(noted, least(limit, affordable_qps(engine, noted.effort)))) return nullptr;
    *engine.nodes.result.data = noted.result;
    engine.nodes.best_cost[0] = noted.cost;
    i64 at_place = noted.first;
    for (i64 axis = 0; axis < 2; axis++) {
      for (i64 v = 0; v < noted.sizes[axis]; v++) engine.nodes.best.at(axis, v) = memo.places[at_place++];
    }
    return &noted.effort;
  }
  return nullptr;
}

}  // namespace placement
