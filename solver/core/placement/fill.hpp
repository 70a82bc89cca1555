// A whole room: the required pieces, then the optional ones by importance, with everything movable: each joins as cheaply as it can,
// else one other piece makes room.
//
// A group (a desk and its chair) joins as a whole or not at all. Pieces are added while the floor covered is below the target.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// What became of a piece: it stands, no way to stand it was found, the floor is covered enough, the budget is spent; of a required one,
// that it certainly cannot stand beside those before it, or that no place was found for it beside them.
enum Fate : i64 { PLACED, NO_WAY, COVERED, SPENT, CANNOT_STAND, NOT_FOUND };

// How much each step of a room may try: evaluations and QPs of each.
struct RoomLimits {
  i64 required, required_qps;
  i64 optional, optional_qps, optional_lapses;
  i64 moves;  // evaluations on moving one other piece so that an optional one fits
  i64 final_qps;
};

// Whether all required pieces stand, whether their arrangement is exact, whether the final placement is proven; QPs.
struct RoomReport {
  i64 complete, closed, proven, solves;
};

// How far a room is filled: what stands costs so much, the required pieces' arrangement is exact or not, the first piece to decide.
struct Filling {
  Costs costs;
  i64 closed, next;
};

// Arranges a whole room: required pieces, optional pieces, and a final search over all choices.
//
//   engine: the final placement is left in `work` and `nodes`.
//   decisions: written.
//   fates: written; of required pieces PLACED.
//   walk: whether doors and use sides must be joined.
RoomReport arrange_room(
    const Engine& engine, const Decisions& decisions, const Span<i64>& fates, const RoomLimits& limits, bool walk);

// Goes on with a room whose required pieces stand. Where the engine's memo gives it up, nothing is found, and `filling` says how far it is.
RoomReport fill_room(
    const Engine& engine, const Decisions& decisions, Filling& filling, const Span<i64>& fates, const RoomLimits& limits, bool walk);

}  // namespace placement
