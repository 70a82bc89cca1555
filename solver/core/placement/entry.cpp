// What the host calls of placement. `desk` is where `new_desk` put a room; what is handed over beside numbers lies on it.
#include "placement/assembly.hpp"
#include "placement/beside.hpp"
#include "placement/confirm.hpp"
#include "placement/grid.hpp"
#include "placement/grow.hpp"
#include "placement/house.hpp"
#include "placement/making.hpp"
#include "placement/options.hpp"
#include "placement/prove.hpp"
#include "placement/pull.hpp"
#include "placement/search.hpp"
#include "placement/settle.hpp"
#include "placement/space.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

using namespace placement;

template <class T> static T& as(const Span<i64>& numbers) { return *reinterpret_cast<T*>(numbers.data); }

extern "C" {

EXPORT(new_desk) Desk* entry_new_desk(RoomRequest* request) {
  const Room room = room_of(request).room;
  return new_desk(room, sizes_of(room));
}

EXPORT(assemble) i32 entry_assemble(const Desk* desk) { return assemble(desk->engine.room, desk->engine.work, desk->decisions); }

// What lies behind the answer of `make_room`, for who reads the problem: its desk, whether that was walked in, the width of wider ways
// between doors or 0, and how many numbers follow: what the pieces and candidates on the desk were numbered in the request (-1: floor that
// was added).
struct MadeProblem {
  i64 desk, walk, ways, pieces, candidates;
};

EXPORT(make_room) u8* entry_make_room(RoomRequest* request, const MakingAsked* asked) {
  const SentRoom sent = room_of(request);
  Making making(sent.room, sent.doorways, *asked);
  making.make();
  const WholeRoom& whole = making.whole();
  const Span<i64> pieces = whole.asked.pieces, candidates = whole.asked.candidates;
  MadeProblem problem = {static_cast<i64>(reinterpret_cast<u64>(whole.desk)), whole.walk, whole.ways, pieces.size, candidates.size};
  Writer writer(making.size() + static_cast<i64>(sizeof(MadeProblem)) + bytes_of(pieces) + bytes_of(candidates));
  making.put(writer);
  writer.put(Span<MadeProblem>{&problem, 1});
  writer.put(pieces);
  writer.put(candidates);
  return writer.written().data;
}

// Tells of what a search just found, as of a room that is made; `walk`: only walkable placements were looked for.
EXPORT(tell_room) u8* entry_tell_room(Desk* desk, i32 walk) {
  Making making(desk->engine.room, {nullptr, 0}, {});
  making.tell(*desk, walk != 0);
  Writer writer(making.size());
  making.put(writer);
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

EXPORT(holding) Holding* entry_holding(const Desk* desk, const f64* y) { return holding(*desk, y); }

// `problems`: addresses of final problems, one a room.
EXPORT(join) HouseProblem* entry_join(const i64* problems, i32 count) { return join({problems, count}); }

EXPORT(judge) Judgement* entry_judge(const i64* problems, i32 count, const f64* x, const f64* y) { return judge({problems, count}, x, y); }

EXPORT(find_taken) i32 entry_find_taken(const Desk* desk) { return find_taken(*desk).size; }

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

EXPORT(total_preference) f64 entry_total_preference(const Desk* desk) {
  return total_preference(desk->engine.room, desk->decisions);
}

EXPORT(walkable) i32 entry_walkable(const Desk* desk) {
  const Engine& engine = desk->engine;
  return walkable(engine.room, engine.work, engine.grid, engine.grid.positions);
}
}
