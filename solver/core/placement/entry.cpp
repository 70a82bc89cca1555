// What the host calls of placement. `desk` is where `new_desk` put a room; what is handed over beside numbers lies on it.
#include "placement/assembly.hpp"
#include "placement/beside.hpp"
#include "placement/confirm.hpp"
#include "placement/grid.hpp"
#include "placement/grow.hpp"
#include "placement/house.hpp"
#include "placement/options.hpp"
#include "placement/prove.hpp"
#include "placement/pull.hpp"
#include "placement/search.hpp"
#include "placement/settle.hpp"
#include "placement/space.hpp"
#include "placement/whole.hpp"
#include "plain/tables.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

using namespace placement;

template <class T> static T& as(const Span<i64>& numbers) { return *reinterpret_cast<T*>(numbers.data); }

extern "C" {

EXPORT(new_desk) Desk* entry_new_desk(RoomRequest* request) {
  const Room room = room_of(request);
  return new_desk(room, sizes_of(room));
}

EXPORT(assemble) i32 entry_assemble(const Desk* desk) { return assemble(desk->engine.room, desk->engine.work, desk->decisions); }

// A whole room arranged: its desk, whether that was walked in, is complete, proven and best, QPs, the width of wider ways between doors or
// 0, the work that was spent, and how many numbers follow: what the pieces and candidates on the desk were numbered in the request (-1:
// floor that was added), and of every required piece left out its number and whether it certainly could not stand.
struct WholeAnswer {
  i64 desk, walk, complete, proven, best, solves, ways;
  f64 spent;
  i64 pieces, candidates, left_out;
};

EXPORT(arrange_whole)
u8* entry_arrange_whole(RoomRequest* request, const RoomLimits* limits, f64 budget, i32 walk, i32 wide) {
  const Room room = room_of(request);
  f64 left = budget, spent = 0;
  const WholeRoom found = wide != 0 ? arrange_wide(room, *limits, budget, spent) : arrange_whole(room, *limits, left, walk != 0);
  spent += budget - left;
  const Span<i64> pieces = found.asked.pieces, candidates = found.asked.candidates;
  const Span<LeftOut> left_out = found.left_out.all();
  WholeAnswer answer = {
      static_cast<i64>(reinterpret_cast<u64>(found.desk)), found.walk, found.complete, found.proven, found.best, found.solves, found.ways,
      spent, pieces.size, candidates.size, left_out.size};
  Writer writer(sizeof(WholeAnswer) + bytes_of(pieces) + bytes_of(candidates) + bytes_of(left_out));
  writer.put(Span<WholeAnswer>{&answer, 1});
  writer.put(pieces);
  writer.put(candidates);
  writer.put(left_out);
  return writer.written().data;
}

EXPORT(best_first) i32 entry_best_first(const Desk* desk, i32 walk) {
  const SearchLimits limits = as<SearchLimits>(desk->limits);
  begin_empty(desk->engine.tree);
  return best_first(desk->engine, desk->decisions, NOTHING_SPENT, as<Group>(desk->group), limits, walk != 0);
}

EXPORT(evaluate) i32 entry_evaluate(const Desk* desk, i64 limit, f64 ceiling, i32 walk) {
  return evaluate(desk->engine, desk->decisions, limit, ceiling, walk != 0);
}

EXPORT(final_problem) FinalProblem* entry_final_problem(const Desk* desk) { return final_problem(*desk); }

EXPORT(confirm) Holding* entry_confirm(const Desk* desk, const f64* x, const f64* y) { return confirm(*desk, x, y); }

// `problems`: addresses of final problems, one a room.
EXPORT(join) HouseProblem* entry_join(const i64* problems, i32 count) { return join({problems, count}); }

EXPORT(judge) Judgement* entry_judge(const i64* problems, i32 count, const f64* x, const f64* y) { return judge({problems, count}, x, y); }

EXPORT(find_taken) i32 entry_find_taken(const Desk* desk) { return static_cast<i32>(find_taken(*desk)); }

EXPORT(open_decisions) i32 entry_open_decisions(const Desk* desk, i32 piece) {
  const Engine& engine = desk->engine;
  return static_cast<i32>(open_decisions(engine.room, desk->decisions, piece, engine.tree.found, engine.tree.found_cost));
}

// Takes space for the open nodes of a proof; `most` are open at a time.
EXPORT(new_proof) ProofNodes* entry_new_proof(const Desk* desk, i64 most) {
  const Sizes sizes = sizes_of(desk->engine.room);
  const i32 variables = static_cast<i32>(sizes.variables), choices = static_cast<i32>(sizes.choices);
  const i32 depth = static_cast<i32>(least(3 * sizes.choices + 32 * sizes.variables + 8, most));
  ProofNodes& nodes = *zeroes<ProofNodes>(1).data;
  nodes.low = {reserved<i64>(depth * 2 * variables).data, depth, 2, variables};
  nodes.high = {reserved<i64>(depth * 2 * variables).data, depth, 2, variables};
  nodes.picks = {reserved<i64>(depth * choices).data, depth, choices};
  nodes.refused = {reserved<i64>(depth * choices).data, depth, choices};
  return &nodes;
}

// Leaves in report[0] how many nodes were looked at.
EXPORT(prove) i32 entry_prove(const Desk* desk, const ProofNodes* nodes, i64 most) {
  i64 allowed = most;
  const Verdict verdict = prove(desk->engine, *nodes, allowed);
  desk->report[0] = most - allowed;
  return static_cast<i32>(verdict);
}

EXPORT(pull_back) i32 entry_pull_back(const Desk* desk) {
  i64 walks = MANY;
  return pull_back(desk->engine, walks);
}

EXPORT(search) void entry_search(const Desk* desk, i64 limit, f64 ceiling, i32 walk) {
  desk->engine.work.counts->placed = 0;  // the host may have written the options
  search(desk->engine, limit, ceiling, walk != 0);
}

EXPORT(settle) i32 entry_settle(const Desk* desk, i32 walk, i32 slide) {
  return static_cast<i32>(settle(*desk, walk != 0, slide != 0));
}

EXPORT(total_preference) f64 entry_total_preference(const Desk* desk) {
  return total_preference(desk->engine.room, desk->decisions);
}

EXPORT(walkable) i32 entry_walkable(const Desk* desk) {
  const Engine& engine = desk->engine;
  return walkable(engine.room, engine.work, engine.grid, engine.grid.positions);
}
}
