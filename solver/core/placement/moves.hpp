// Groups that join a room, if need be by moving one piece that stands there.
#pragma once

#include "placement/engine.hpp"

namespace placement {

// Adds a group to the decisions where it can stand for less than leaving it out costs; changes `start` and `costs`.
bool join(const Engine& engine, const Decisions& start, Costs& costs, const Group& group, const SearchLimits& limits, bool walk);

// Moves one other piece so that the group can join; the first success counts.
bool join_by_move(const Engine& engine, const Decisions& decisions, Costs& costs, const Group& group, bool walk);

}  // namespace placement
