#include "placement/moves.hpp"

#include "placement/beside.hpp"
#include "placement/grow.hpp"
#include "placement/options.hpp"

namespace placement {

constexpr i64 MOVES = 48;  // other ways of other pieces that are looked at before the cheapest are tried
constexpr i64 EVALUATIONS_OF_A_MOVE = 6;  // for each piece of the group
constexpr i64 QPS_OF_A_MOVE = 18;  // of each evaluation: more find hardly a move that helps (measured)

static void copy(const Decisions& from, const Decisions& to) {
  for (i64 piece = 0; piece < to.size; piece++) to[piece] = from[piece];
}

bool join(const Engine& engine, const Decisions& start, Costs& costs, const Group& group, const SearchLimits& limits, bool walk) {
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

bool join_by_move(const Engine& engine, const Decisions& decisions, Costs& costs, const Group& group, bool walk) {
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

}  // namespace placement
