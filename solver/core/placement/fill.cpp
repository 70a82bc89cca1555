#include "placement/fill.hpp"

#include "placement/beside.hpp"
#include "placement/grow.hpp"
#include "placement/moves.hpp"

namespace placement {

// What leaving a group out costs where another piece is moved for it (measured: of moves for less one in eighteen helps).
constexpr f64 WORTH_A_MOVE = 5.0;

static bool stands_on_floor(const CandidateRow& own) { return own.bottom == 0 && own.under < 0; }

// The floor that the decided pieces cover, mm2.
static i64 covered(const Room& room, const Decisions& decisions) {
  i64 area = 0;
  for (i64 piece = 0; piece < decisions.size; piece++) {
    if (decisions[piece] == ABSENT || room.pieces[piece].empty != 0) continue;
    const CandidateRow& own = room.candidates[candidate_of(decisions[piece])];
    if (stands_on_floor(own)) area += own.width * own.depth;
  }
  return area;
}

// Tells whether a piece may cover floor of its own: a chair at its table, a screen on its stand and kept floor do not.
static bool may_cover(const Room& room, const PieceRow& row) {
  if (row.empty != 0) return false;
  for (i64 candidate = row.candidates[0]; candidate < row.candidates[1]; candidate++) {
    if (stands_on_floor(room.candidates[candidate])) return true;
  }
  return false;
}

// Adds an optional group to the decisions; says what became of it.
static Fate add_group(
    const Engine& engine, const Decisions& decisions, Costs& costs, const Group& group, const RoomLimits& limits, bool walk) {
  const Room& room = engine.room;
  const Tree& tree = engine.tree;
  const PieceRow& row = room.pieces[group.first];
  f64 skip = 0.0;
  for (i64 member = group.first; member < group.last; member++) skip += room.skip_costs[member];
  if (tree.budget[0] <= 0) return SPENT;
  const i64 cover = room.space->cover;
  if (cover > 0 && may_cover(room, row) && covered(room, decisions) >= cover) return COVERED;
  costs.ceiling = costs.all + skip;
  const i64 size = group.last - group.first;
  const SearchLimits own = {limits.optional * size, limits.optional_qps, limits.optional_lapses * size, 0};
  if (join(engine, decisions, costs, group, own, walk)) return PLACED;
  if (skip < WORTH_A_MOVE || tree.counters->moves_left <= 0) return NO_WAY;
  return join_by_move(engine, decisions, costs, group, walk) ? PLACED : NO_WAY;
}

// Adds the optional pieces to the decisions of the required ones.
static void fill(
    const Engine& engine, const Decisions& decisions, Costs& costs, const Span<i64>& fates, const RoomLimits& limits, bool walk) {
  engine.tree.counters->moves_left = limits.moves;
  for (i64 piece = 0, end; piece < decisions.size; piece = end) {
    end = engine.room.pieces[piece].group_end;
    if (engine.room.pieces[piece].required) continue;
    const Fate fate = add_group(engine, decisions, costs, {piece, end}, limits, walk);
    for (i64 member = piece; member < end; member++) fates[member] = fate;
  }
}

RoomReport arrange_room(
    const Engine& engine, const Decisions& decisions, const Span<i64>& fates, const RoomLimits& limits, bool walk) {
  Counters& counters = *engine.tree.counters.data;
  i64 required = 0;
  while (required < engine.room.pieces.size && engine.room.pieces[required].required) required++;
  for (i64& decision : decisions) decision = ABSENT;
  for (i64& fate : fates) fate = PLACED;
  counters.solved_qps = 0;
  begin_empty(engine.tree);
  Costs costs = NOTHING_SPENT;
  const SearchLimits own = {limits.required, limits.required_qps, MANY, 1};
  if (required > 0 && !join(engine, decisions, costs, {0, required}, own, walk)) {
    return {0, counters.closed, 0, counters.solved_qps};
  }
  const i64 closed = required > 0 ? counters.closed : 1;
  fill(engine, decisions, costs, fates, limits, walk);
  evaluate_all(engine, decisions, limits.final_qps, costs.all - costs.preferences + NO_DEARER, walk);
  return {1, closed, engine.nodes.result->exhausted, counters.solved_qps};
}

}  // namespace placement
