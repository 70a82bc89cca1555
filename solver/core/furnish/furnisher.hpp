// The pieces of one room, each made when those before it are known.
#pragma once

#include "furnish/preferences.hpp"
#include "furnish/relations/relation.hpp"

namespace furnish {

// A piece of the answer; its candidates and links are the next rows of theirs. Floor that is better kept free is one, too.
struct PieceRow {
  i32 spec;    // of the piece at whose side floor is
  i32 number;  // of the copy; of floor: that piece, by its place in the answer
  i32 kind;    // the wanted one
  i32 candidates;
  i32 links;
  i32 floor_side;  // -1 for a piece
  i32 required;
  i32 with_next;  // it stands only together with the next one
  f64 skip_cost;  // infinite for a piece that the room type requires, its own for one that must stand for what is insisted on
};

class Furnisher {
 public:
  Furnisher(const Scope& scope, const RoomType& type, WallOccupancy& walls);

  // Adds a copy of a piece, which a run may have planned (else null); false where a relation it must keep has nothing to hold on to.
  bool add(const CountedPiece& counted, i32 number, const Preferences& preferences, const Candidate* planned);

  List<PieceRow> pieces;
  List<Candidate> candidates;
  List<Link> links;

 private:
  // Where a piece is meant to stand; `kind` is -1 where nowhere.
  struct Meant {
    i32 kind;
    i32 rotation;
    Point centre;
  };

  List<Candidate*> found_for(const Subject& subject, Span<Effect> effects, const Preferences& preferences) const;
  List<Candidate*> alone(const Subject& subject, Span<Effect> effects, const Preferences& preferences) const;
  f64 cost_in_the_way(const Subject& subject, const Candidate& candidate) const;
  void keep(const CountedPiece& counted, i32 number, Span<Candidate*> ways, Span<Effect> effects);
  Meant meant(const Candidate& candidate) const;
  void intend(Span<Candidate*> ways);

  const Scope& scope_;
  const RoomType& type_;
  WallOccupancy& walls_;
  Earlier earlier_;
  KneeRoom knee_room_;
  List<Meant> meant_;  // by piece
};

}  // namespace furnish
