// What a seed alone decides: the order of pieces that matter alike, how many there are, and small costs among good ways.
#pragma once

#include "furnish/subject.hpp"
#include "plain/streams.hpp"

namespace furnish {

// A piece that a room wants: its place in the type's table, the variants that suit the room, and how many copies.
struct CountedPiece {
  i32 spec;
  i32 copies;
  Span<Variant> variants;
};

// The pieces of a room of some area, m2, in order.
List<CountedPiece> counted_pieces(const RoomType& type, f64 area, Stream& stream);

// What one copy of a piece prefers of walls, quarters of the room, sides of other pieces and its variants, as costs.
class Preferences {
 public:
  // Draws them; always as many numbers.
  explicit Preferences(Stream& stream);
  f64 cost(const Subject& subject, const Candidate& candidate) const;

 private:
  static constexpr i32 KINDS = 3;
  f64 walls_[4], quarters_[4], sides_[4], kinds_[KINDS];
};

}  // namespace furnish
