// Where a piece can reach under another one: nowhere does a part of the one stand in a part of the other.
//
// A place is that of the piece's centre, mm, from the other's centre in the other's frame.
#pragma once

#include "furnish/room.hpp"

namespace furnish {

// The open rectangles in which the centre must not be: there a part of a piece, so turned, stands in one of its parent.
List<Rect> blocked_places(Span<PartBox> parent, Span<PartBox> own, i32 turn);
// The largest of the rectangles that places leave without what is blocked; a line or a point may be one.
List<Rect> free_of(const Rect& places, const List<Rect>& blocked);

// What of the places wished for is free; where nothing is, the places nearest to them of those that will do. As little as possible is lost
// along the axis that leads away from the other piece, which is along x where it stands `sideways`, then along the other.
List<Rect> nearest_free(const Rect& wish, const Rect& reach, const List<Rect>& blocked, bool sideways);

}  // namespace furnish
