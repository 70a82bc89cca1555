// Which ways a piece may stand beside what is decided already, and what they cost by preference.
//
// Preference costs are the candidate's, its sides', and those of the links that do not hold; a required link that does not hold rules
// the way out.
#pragma once

#include "placement/engine.hpp"

namespace placement {

constexpr f64 RULED_OUT = -1.0;

// The preference cost of a candidate beside the other decided pieces before it, or RULED_OUT.
f64 preference(const Room& room, const Decisions& decisions, i64 piece, i64 candidate);

// The preference cost of all decisions together, or RULED_OUT.
f64 total_preference(const Room& room, const Decisions& decisions);

// What a piece that is not decided will cost by preference at least, whatever the other undecided ones do; 0 where it cannot stand.
f64 least_preference(const Room& room, const Decisions& decisions, i64 piece);

// Writes the decisions possible for a piece and their preference costs, in the order given; returns how many.
i64 open_decisions(const Room& room, const Decisions& decisions, i64 piece, const Span<i64>& found, const Span<f64>& costs);

}  // namespace placement
