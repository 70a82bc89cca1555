#include "placement/fill.hpp"

#include "placement/beside.hpp"
#include "placement/grow.hpp"
#include "placement/memo.hpp"
#include "placement/options.hpp"

namespace placement {

constexpr i64 MOVES = 48;  // other ways of other pieces that are looked at before the cheapest are tried
constexpr i64 EVALUATIONS_OF_A_MOVE = 6;  // for each piece of the group
constexpr i64 QPS_OF_A_MOVE = 18;  // of each evaluation: more find hardly a move that helps (measured)

static void copy(const Decisions& from, const Decisions& to) {
  for (i64 piece = 0; piece < to.size; piece++) to[piece] = from[piece];
}

// Adds a group to the decisions where it can stand for less than leaving it out costs; changes `start` and `costs`.
static bool join(const Engine& engine, const Decisions& start, Costs& costs, const Group& group, const SearchLimits& limits, bool walk) {
  const Tree& tree = engine.tree;
  if (!best_first(engine, start, costs, group, limits, walk)) return false;
  const i64 best = tree.counters->best;
  copy(tree.decisions.row(best), start);
  begin_with(tree, best);
  costs.all = tree.costs[best];
  costs.preferences = tree.preferences[best];
  return true;
}

// Tells whether the preferences of another piece that stands speak of this one.
static bool depended(const Room& room, const Decisions& decisions, i64 piece) {
  for (i64 other = 0; other < decisions.size; other++) {
    if (decisions[other] == ABSENT || other == piece) continue;
    if (room.candidates[candidate_of(decisions[other])].parent == piece) return true;
    const PieceRow& row = room.pieces[other];
    for (i64 link = row.links[0]; link < row.links[1]; link++) {
      if (room.links[link].of == piece) return true;
    }
  }
  return false;
}

// Inserts a move into the list of the cheapest, `count` long so far; returns its new length.
static i64 note_move(const Tree& tree, const Move& own, f64 cost, i64 count) {
  i64 at = count;
  while (at > 0 && tree.move_cost[at - 1] > cost) at--;
  const i64 grown = least(count + 1, MOVES);
  if (at == MOVES) return grown;
  for (i64 k = least(count, MOVES - 1); k > at; k--) {
    tree.moves[k] = tree.moves[k - 1];
    tree.move_cost[k] = tree.move_cost[k - 1];
  }
  tree.moves[at] = own;
  tree.move_cost[at] = cost;
  return grown;
}

// Notes the other ways of one piece that stands; returns how many moves there are then.
static i64 note_moves_of(const Engine& engine, const Decisions& decisions, const Costs& costs, i64 piece, i64 count) {
  const Room& room = engine.room;
  const PieceRow& row = room.pieces[piece];
  const i64 kept = decisions[piece], first = row.sides[0];
  const CandidateRow& now = room.candidates[candidate_of(kept)];
  const bool others = depended(room, decisions, piece);
  const f64 own = preference(room, decisions, piece, candidate_of(kept)) + room.side_costs[first + sides_of(kept)];
  for (i64 candidate = row.candidates[0]; candidate < row.candidates[1]; candidate++) {
    if (room.candidates[candidate].parent != now.parent) continue;
    for (i64 side = first; side < row.sides[1]; side++) {
      const i64 decision = 8 * candidate + side - first;
      if (room.candidates[candidate].kin == now.kin && sides_of(decision) == sides_of(kept)) continue;
      decisions[piece] = decision;
      f64 cost;
      if (others) {
        cost = total_preference(room, decisions);
      } else {
        cost = preference(room, decisions, piece, candidate);
        if (cost >= 0) cost += costs.preferences - own + room.side_costs[side];
      }
      if (cost >= 0) count = note_move(engine.tree, {piece, decision}, cost, count);
    }
  }
  decisions[piece] = kept;
  return count;
}

// Moves one other piece so that the group can join; the first success counts.
static bool join_by_move(const Engine& engine, const Decisions& decisions, Costs& costs, const Group& group, bool walk) {
  const Tree& tree = engine.tree;
  Counters& counters = *tree.counters.data;
  i64 count = 0;
  for (i64 piece = 0; piece < decisions.size; piece++) {
    if (decisions[piece] != ABSENT) count = note_moves_of(engine, decisions, costs, piece, count);
  }
  const f64 terms = costs.all - costs.preferences;
  const i64 size = group.last - group.first;
  for (i64 k = 0; k < count; k++) {
    if (counters.moves_left <= 0 || tree.budget[0] <= 0) return false;
    if (terms + tree.move_cost[k] >= costs.ceiling) return false;
    copy(decisions, tree.shifted);
    tree.shifted[tree.moves[k].piece] = tree.moves[k].decision;
    Costs shifted = {terms + tree.move_cost[k], tree.move_cost[k], costs.ceiling};
    const SearchLimits own = {size * least(counters.moves_left, EVALUATIONS_OF_A_MOVE), QPS_OF_A_MOVE, size, 0};
    const bool joined = join(engine, tree.shifted, shifted, group, own, walk);
    counters.moves_left -= most<i64>(floor_div(counters.evaluated, size), 1);
    if (joined) {
      copy(tree.shifted, decisions);
      costs.all = shifted.all;
      costs.preferences = shifted.preferences;
      return true;
    }
  }
  return false;
}

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

RoomReport fill_room(
    const Engine& engine, const Decisions& decisions, Filling& filling, const Span<i64>& fates, const RoomLimits& limits, bool walk) {
  const i64& solved = engine.tree.counters->solved_qps;
  Costs& costs = filling.costs;
  while (filling.next < decisions.size) {
    const i64 piece = filling.next;
    filling.next = engine.room.pieces[piece].group_end;
    if (engine.room.pieces[piece].required) continue;
    const Fate fate = add_group(engine, decisions, costs, {piece, filling.next}, limits, walk);
    for (i64 member = piece; member < filling.next; member++) fates[member] = fate;
    if (fate != PLACED && is_hopeless(engine.room, decisions, filling.next, filling.closed, engine.memo)) {
      engine.nodes.result->found = 0;
      return {1, filling.closed, 0, solved};
    }
  }
  evaluate_all(engine, decisions, limits.final_qps, costs.all - costs.preferences + NO_DEARER, walk);
  return {1, filling.closed, engine.nodes.result->exhausted, solved};
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
  Filling filling = {NOTHING_SPENT, 1, 0};
  const SearchLimits own = {limits.required, limits.required_qps, MANY, 1};
  if (required > 0) {
    if (!join(engine, decisions, filling.costs, {0, required}, own, walk)) return {0, counters.closed, 0, counters.solved_qps};
    filling.closed = counters.closed;
  }
  counters.moves_left = limits.moves;
  const RoomReport report = fill_room(engine, decisions, filling, fates, limits, walk);
  if (engine.memo != nullptr) engine.memo->filling = filling;
  return report;
}

}  // namespace placement
