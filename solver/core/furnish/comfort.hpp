// Floor that people like to have free about a piece: beside a toilet, behind a chair, before a kitchen run.
#pragma once

#include "furnish/furnisher.hpp"

namespace furnish {

// Added to the side of floor that fronts open over; of floor that a standard asks for; in place of a side: of a square to turn in, of floor
// before a door.
constexpr i32 OPENED = 4, ASKED = 8, TURNING = 12, APPROACH = 13;

// Pieces with their candidates and links.
struct WantedRows {
  Span<PieceRow> pieces;
  Span<Candidate> candidates;
  Span<Link> links;
};

// Adds floor to keep free at sides of pieces, as pieces without a body, rigid at theirs: what required pieces, which come first, wish for
// before the optional pieces, what is worth much right behind its piece, the rest last. Doing without it is always a way, but for floor
// that the fronts of an optional piece open over: where that is not free for half of their way, the piece is left out.
// So is floor that a standard asks for: strips about pieces, and a square to turn in, which comes behind those of the required pieces.
WantedRows with_comfort(const Scope& scope, const RoomType& type, const WantedRows& wanted);
// Adds the floor that the fronts of pieces open over, right behind each, for that share of what it costs elsewhere. All stand without, too.
WantedRows with_fronts(const Scope& scope, const RoomType& type, const WantedRows& wanted, f64 share);

}  // namespace furnish
