// The tables of a room's pieces while they are written.
#pragma once

#include "placement/room.hpp"
#include "plain/lists.hpp"

namespace placement {

struct PieceTables {
  List<PieceRow> pieces;
  List<f64> skip_costs;
  List<SidesRow> sides;
  List<f64> side_costs;
  List<CandidateRow> candidates;
  List<CandidateCost> candidate_costs;
  List<LinkRow> links;
  List<LinkCost> link_costs;

  // Notes that the rows of a piece begin here (0), or end (1).
  void mark(PieceRow& own, i32 end) const {
    own.candidates[end] = candidates.size();
    own.links[end] = links.size();
    own.sides[end] = sides.size();
  }

  void give_to(Room& room) const {
    const auto rows = [](const auto& own) { return Rows{own.begin(), own.size(), sizeof(*own.begin()) / 8}; };
    room.pieces = rows(pieces);
    room.skip_costs = skip_costs.all();
    room.sides = rows(sides);
    room.side_costs = side_costs.all();
    room.candidates = rows(candidates);
    room.candidate_costs = rows(candidate_costs);
    room.links = rows(links);
    room.link_costs = rows(link_costs);
  }
};

}  // namespace placement
