#include "placement/memo.hpp"

#include "placement/grid.hpp"
#include "placement/grow.hpp"

namespace placement {

constexpr i32 MOST_NOTES = 1024, MOST_PLACEMENTS = 4096, MOST_RECTS = 16384;
constexpr i32 TABLE = 2 * MOST_NOTES;

Memo* new_memo(const Room& room) {
  Memo& memo = *zeroes<Memo>(1).data;
  memo.noted = reserved<Noted>(MOST_NOTES);
  memo.decisions = {reserved<i64>(MOST_NOTES * room.pieces.size).data, MOST_NOTES, room.pieces.size};
  memo.table = reserved<i32>(TABLE);
  for (i32& number : memo.table) number = -1;
  memo.noted_placements = reserved<NotedPlacement>(MOST_PLACEMENTS);
  memo.covered = reserved_rows<NumberedRect>(MOST_RECTS);
  return &memo;
}

// Where in the table what is asked may be; the ceiling is compared where the decisions are the same.
static i32 place_in_table(const Decisions& decisions) {
  u64 hash = 0;
  for (const i64 decision : decisions) hash = (hash ^ static_cast<u64>(decision)) * 0x9E3779B97F4A7C15ULL;
  return static_cast<i32>(hash >> 32) & (TABLE - 1);
}

void begin_note(Memo& memo) {
  memo.open = memo.placements;
  memo.full = memo.notes == MOST_NOTES;
}

void note_placement(const Engine& engine) {
  Memo& memo = *engine.memo;
  memo.full = memo.full || memo.placements == MOST_PLACEMENTS || memo.rects + engine.work.counts->parts > MOST_RECTS;
  if (memo.full) return;
  const Rows<NumberedRect> left = {memo.covered.data + memo.rects, MOST_RECTS - memo.rects, memo.covered.columns};
  const i32 count = static_cast<i32>(find_covered(engine.work, engine.grid.positions, engine.grid.positions, left));
  memo.noted_placements[memo.placements++] = {memo.rects, memo.rects + count};
  memo.rects += count;
}

void end_note(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, const Effort& effort) {
  Memo& memo = *engine.memo;
  if (memo.full) return;
  const i32 number = memo.notes++;
  memo.noted[number] = {limit, ceiling, engine.nodes.best_cost[0], effort, *engine.nodes.result.data, memo.open, memo.placements};
  for (i32 k = 0; k < decisions.size; k++) memo.decisions.at(number, k) = decisions[k];
  i32 at = place_in_table(decisions);
  while (memo.table[at] >= 0) at = (at + 1) & (TABLE - 1);
  memo.table[at] = number;
}

static bool is_equal(const Span<i64>& a, const Decisions& b) {
  for (i32 k = 0; k < b.size; k++) {
    if (a[k] != b[k]) return false;
  }
  return true;
}

// Tells whether a search that was made within one limit goes the same way within another.
static bool is_within(const Noted& noted, i64 limit) {
  return limit == noted.limit || (noted.result.exhausted && noted.result.solves < limit);
}

// Tells whether all the placements of a note leave the ways free that are asked for now.
static bool leaves_ways(const Engine& engine, const Noted& noted) {
  const Memo& memo = *engine.memo;
  for (i32 k = noted.first; k < noted.last; k++) {
    const auto [first, last] = memo.noted_placements[k];
    const Rows<NumberedRect> bodies = {memo.covered.data + first, last - first, memo.covered.columns};
    if (!joins_doors(engine.room, engine.grid, bodies)) return false;
  }
  return true;
}

const Effort* recall(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling) {
  const Memo& memo = *engine.memo;
  for (i32 at = place_in_table(decisions); memo.table[at] >= 0; at = (at + 1) & (TABLE - 1)) {
    const i32 number = memo.table[at];
    const Noted& noted = memo.noted[number];
    if (noted.ceiling != ceiling || !is_equal(memo.decisions.row(number), decisions)) continue;
    const i64 affordable = affordable_qps(engine, noted.effort);
    if (!is_within(noted, least(limit, affordable)) || !leaves_ways(engine, noted)) return nullptr;
    *engine.nodes.result.data = noted.result;
    engine.nodes.best_cost[0] = noted.cost;
    return &noted.effort;
  }
  return nullptr;
}

}  // namespace placement
