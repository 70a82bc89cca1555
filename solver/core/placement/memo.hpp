// What ways to stand came to in a room whose ways between doors are as wide as its person. Where wider ones are asked for, the search for
// the same decisions goes the same way as long as each placement that it took leaves these free, too: it need not be made again.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// An evaluation: what was asked, what came of it, and the placements that it took.
struct Noted {
  i64 limit;
  f64 ceiling, cost;
  Effort effort;
  SearchResult result;
  i32 first, last;  // placements
};

// A placement: the rectangles that its bodies cover.
struct NotedPlacement {
  i32 first, last;
};

// Evaluations of one room in the order they were made; those beyond its space are not noted.
struct Memo {
  bool complete;  // nothing is noted any more
  i32 notes, placements, rects;
  i32 open;  // placements of the evaluation that is being made begin there
  bool full;
  Span<Noted> noted;
  Table<i64> decisions;  // of each note
  Span<i32> table;       // numbers of notes, by their hashes
  Span<NotedPlacement> noted_placements;
  Rows<NumberedRect> covered;
};

Memo* new_memo(const Room& room);

// Begins the note of an evaluation; adds a placement that it takes, which is in grid.positions; ends it.
void begin_note(Memo& memo);
void note_placement(const Engine& engine);
void end_note(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, const Effort& effort);

// Puts the outcome of a noted evaluation in nodes.result and best_cost, where it is certainly that of these decisions in this room; returns
// what it costs, or null.
const Effort* recall(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling);

}  // namespace placement
