// What ways to stand came to in a room whose ways between doors are wider than its person, where none of the placements taken closed these,
// or in one without such ways, where none closed those that are asked for next.
// Where narrower ones are asked for, or none, the search for the same decisions goes the same way: it need not be made again.
#pragma once

#include "placement/fill.hpp"

namespace placement {

// An evaluation: what was asked, what came of it.
struct Noted {
  i64 limit, ways;  // the widest ways for which it holds
  f64 ceiling, cost;
  Effort effort;
  i64 first, sizes[2];  // of its places: where they begin, and how many along each axis
  SearchResult result;
};

// Required pieces that stand, what the optional ones that do are worth, and what the room costs with all that it leaves out.
struct Standing {
  i64 required;
  f64 worth, cost;
};

// Wider ways between doors: by how much wider than who walks, the share that must stand with them of what optional pieces are worth
// without, and the most that the room may cost more for them.
struct WayMargin {
  i64 wider;
  f64 worth, most;
};

// Evaluations of one room in the order they were made; those beyond its space are not noted.
struct Memo {
  bool complete;  // the widest ways were asked for
  i64 ways;  // what is noted holds for ways so wide, or less
  i32 notes;
  i32 closed;  // placements that close these ways, of all evaluations so far
  Span<Noted> noted;
  Table<i64> decisions;  // of each note
  Span<i32> table;       // numbers of notes, by their hashes
  Span<f64> places;      // where the variables are, one note behind the other, m
  i64 placed;
  const WayMargin* margin;  // of wider ways that are looked for beside a rival, or null
  Standing rival;
  bool given_up;  // whether the room was left, as it cannot be worth these ways whatever its pieces to come do
  Standing hoped;  // what it comes to at best
  Filling filling;  // and how far the last room is
};

Memo* new_memo(const Room& room);

// What no placement surpasses that leaves out what is left out of the first `decided` pieces: all others stand, each for its least cost.
Standing best_standing(const Room& room, const Decisions& decisions, i64 decided);

// What a room comes to that costs so much beside what its first `decided` pieces leave out, with all the others.
Standing standing(const Room& room, const Decisions& decisions, i64 decided, f64 cost);

// Tells whether a room with wider ways is worth what it costs more than without.
bool is_worth(const WayMargin& margin, const Standing& wide, const Standing& usual);

// Tells whether a room whose first pieces are decided is to be left: what stands beside it is surely needed, and surely better. `closed`:
// whether its required pieces' arrangement is exact. Where no wider way made a difference so far, the rival leaves out as much.
bool is_hopeless(const Room& room, const Decisions& decisions, i64 decided, i64 closed, Memo* memo);

// Notes an evaluation of which no placement closed the ways.
void note(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling, const Effort& effort);

// Puts the outcome of a noted evaluation in nodes.result, best and best_cost, where it is certainly that of these decisions in this room;
// returns what it costs, or null.
const Effort* recall(const Engine& engine, const Decisions& decisions, i64 limit, f64 ceiling);

}  // namespace placement
