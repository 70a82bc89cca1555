// What a piece more costs beside pieces whose optimum is known, where none of these has to move for it.
//
// Nothing that is added makes the others cheaper: they cost their optimum at least, and the new terms what they do by themselves. Where the
// new piece may stand at just that, it is the optimum, and where that is too dear already nothing else is any cheaper: no search is needed.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Begins with an empty room.
void begin_empty(const Tree& tree);

// Goes on from a state; what it began with is known then, where that is.
void begin_with(const Tree& tree, i64 state);

// Tells whether it begins with these decisions.
bool is_begun(const Tree& tree, const Decisions& decisions);

// Keeps what was found for a state; `closed`: whether a placement was turned down on the way that closes the wider ways.
void keep_optimum(const Engine& engine, i64 state, bool closed);

// What is known of a state, or null.
const Optimum* optimum_of(const Tree& tree, i64 state);

// Tells what a search in the problem laid out would come to, where that is plain; false where it is not.
//
//   engine: the outcome is left as a search leaves it, but for picks and forces.
//   state: whose pieces are all that is laid out but the last piece; its optimum is known.
//   ceiling: only placements cheaper than this count.
//   walk: whether doors and use sides must be joined.
bool is_plain_beside(const Engine& engine, i64 state, f64 ceiling, bool walk);

}  // namespace placement
