// What a relation of a room type makes of a piece's candidates: one class a word, as in solver/relations/.
#pragma once

#include "furnish/subject.hpp"

namespace furnish {

class Relation;

// A further centre along a wall to try for a kind, mm.
struct Position {
  Wall wall;
  i32 kind;
  i64 along;
};

// A further free anchor to try for a kind.
struct Spot {
  i32 kind;
  i32 unused;
  Point at;
};

struct Effect {
  const Relation* relation = nullptr;
  const Rule* rule = nullptr;
  List<Candidate> slots;
  List<Link> links;
  List<Position> positions;
  List<Spot> spots;
  bool has_cost = false;
  bool corners = false;  // free pieces are tried in the room's corners
  bool backs = false;    // free pieces are tried with their back at each wall
  f64 weight = 0.0;      // pull towards the anchor, m^-2
  List<Point> points;    // of what a cost is measured from
  u64 walls = 0;         // that a front is to look to; bit by Wall
  bool gates = false;    // it looks to a garage door
};

// One word of the vocabulary; this one says nothing, the others override what they mean.
class Relation {
 public:
  constexpr Relation() = default;

  // It places a piece at another one; who is there has what it needs from it.
  bool gives_place = false;

  // What it does to the candidates of a piece.
  virtual void effect(const Subject&, const Rule&, Effect&) const {}
  // What a candidate that is no slot costs by it, where the effect has a cost; infinity forbids it.
  virtual f64 cost(const Subject&, const Effect&, const Candidate&) const { return 0.0; }
  // Where such a candidate must stay so that its cost stays what it is; without a word, anywhere.
  virtual void keep(const Subject&, const Effect&, Candidate&) const {}
};

const Relation& relation_of(Word word);

// From that cost on what stands clear of what a relation shuns stays so, wherever else its piece is moved.
constexpr f64 SHUNNED = 2.0;

// Has a candidate stay in an area, besides where it stays already.
inline void hold(Candidate& candidate, const Rect& area) {
  Rect& kept = candidate.within;
  if (kept == Rect{}) kept = area;
  kept = {most(kept.x0, area.x0), most(kept.z0, area.z0), least(kept.x1, area.x1), least(kept.z1, area.z1)};
}

// A link that says nothing yet.
inline Link link_to(const Rule& rule, i32 piece) {
  Link made{};
  made.word = rule.word;
  made.of = piece;
  made.turn = -1;
  return made;
}

}  // namespace furnish
