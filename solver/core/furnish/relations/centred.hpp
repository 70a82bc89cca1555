// `centred`: in the middle of its wall, or of the room.
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

class Centred : public Relation {
 public:
  void effect(const Subject& subject, const Rule& rule, Effect& effect) const override;
  f64 cost(const Subject& subject, const Effect& effect, const Candidate& candidate) const override;
  void regions(const Footing& at, List<Rect>& found) const override;
};

// What being off a middle costs: by degree, and everything where the relation is hard.
f64 off_middle(const Rule& rule, f64 off_mm);

}  // namespace furnish
