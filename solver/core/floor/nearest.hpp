// The free place of a box that is nearest to where it is wished: exact on whole millimetres.
#pragma once

#include "plain/rects.hpp"
#include "plain/spans.hpp"

// No limit on how far away.
constexpr i64 ANYWHERE = -1;

struct NearestPlace {
  bool found;
  Rect place;
};

// Of the places within `area` that overlap none of the blocks, the nearest to `own`, at most `reach` mm away. Ties go to the lesser step
// along x, then west, then along z, then north.
//
// The free places of a box are what is left of a rectangle after the obstacles, grown by the box; the nearest of them has both coordinates
// among the wish's own and the edges of those.
NearestPlace nearest_place(const Rect& own, const Rect& area, Span<Rect> blocks, i64 reach);
