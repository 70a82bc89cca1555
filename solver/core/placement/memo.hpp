// What ways to stand came to in a room whose ways between doors are wider than its person, where none of the placements taken closed these.
// Where narrower ones are asked for, or none, the search for the same decisions goes the same way: it need not be made again.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// An evaluation: what was asked, what came of it.
struct Noted {
  i64 limit;
  f64 ceiling, cost;
  Effort effort;
  SearchResult result;
};

// Evaluations of one room in the order they were made; those beyond its space are not noted.
struct Memo {
  bool complete;  // nothing is noted any more
  i32 notes;
  i32 closed;  // placements turned down because they close the wider ways, of all evaluations so far
  Span<Noted> noted;
  Table<i64> decisions;  // of each note
  Span<i32> table;       // numbers of notes, by their hashes
};

Memo* new_memo(const Room& room);

// Notes an evaluation of which no placement closed the ways.
void note(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, const Effort& effort);

// Puts the outcome of a noted evaluation in nodes.result and best_cost, where it is certainly that of these decisions in this room; returns
// what it costs, or null.
const Effort* recall(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling);

}  // namespace placement
