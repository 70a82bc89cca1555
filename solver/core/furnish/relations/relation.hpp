// What a relation means: one class a word.
//
// Of a room type it costs by degree: `effect`, `cost` and `keep` say what it makes of a piece's candidates. Asked for by a user it holds or
// does not: `regions` and `boxes` say where, `holds_in_room` and `holds_with` whether it does in a finished room.
#pragma once

#include "furnish/relations/asked.hpp"

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
  // It may well hold for a piece that is placed without thinking of it.
  bool by_degree = false;
  // Which way round the piece stands decides whether it holds.
  bool turns = false;
  // To several, it holds only with all of them.
  bool with_all = false;
  // It may hold between the copies of one piece.
  bool among_copies = false;
  // It makes a piece stand with its back at a wall that would not do so by itself.
  bool at_walls = false;
  // It draws the middle of the piece into line with that of the other, not near it.
  bool into_line = false;
  // How far from a piece is meant where it names no distance, mm.
  i64 usual = 0;

  // What it does to the candidates of a piece.
  virtual void effect(const Subject&, const Rule&, Effect&) const {}
  // What a candidate that is no slot costs by it, where the effect has a cost; infinity forbids it.
  virtual f64 cost(const Subject&, const Effect&, const Candidate&) const { return 0.0; }
  // Where such a candidate must stay so that its cost stays what it is; without a word, anywhere.
  virtual void keep(const Subject&, const Effect&, Candidate&) const {}

  // Adds the rectangles in any of which a footprint holds it to the room; none where it cannot hold so.
  virtual void regions(const Footing&, List<Rect>&) const {}
  // Adds the boxes in any of which a centre holds it to another piece, best first.
  virtual void boxes(const Fit&, List<DoubleBox>&) const {}
  // Tells whether the walls at the backs of two pieces lie as it wants them.
  virtual bool suits(Walls asked, Wall mine, Wall theirs) const;
  // Tells whether it holds to the room, or to any opening of those it names, with the footprint where it is.
  virtual bool holds_in_room(const Footing& at) const;
  // Tells whether it holds to another piece, its `wall` left aside.
  virtual bool holds_with(const Fit& fit, const Standing& own, const Standing& other) const;
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

// Adds a link that asks for its rule to be met: for the walls behind the two, or for what else is set of it.
inline Link& add_asking(Effect& effect, const Rule& rule, i32 piece, Walls walls) {
  Link& link = effect.links.add(link_to(rule, piece));
  link.walls = walls;
  link.cost = rule.cost;
  link.required = rule.required;
  return link;
}

}  // namespace furnish
