// Where a piece can reach under another one: nowhere does a part of the one stand in a part of the other.
//
// A place is that of the piece's centre, mm, from the other's centre in the other's frame.
#pragma once

#include "furnish/room.hpp"

namespace furnish {

// Two kinds, one turned so at the other, which is at its side in x or in z.
struct TurnedPair {
  i32 parent;
  i32 own;
  i32 turn;
  bool sideways;

  bool operator==(const TurnedPair&) const = default;
};

// The open rectangles in which the centre must not be: there a part of a piece, so turned, stands in one of its parent.
List<Rect> blocked_places(Span<PartBox> parent, Span<PartBox> own, i32 turn);
// The largest of the rectangles that places leave without what is blocked; a line or a point may be one.
List<Rect> free_of(const Rect& places, const List<Rect>& blocked);

// Answers for a room, each worked out once: every copy of a chair asks the same.
class KneeRoom {
 public:
  explicit KneeRoom(const RoomType& type) : type_(type) {}

  // What of the places wished for is free; where nothing is, the places nearest to them of those that will do. As little as possible is
  // lost along the axis that leads away from the other piece, then along the other.
  const List<Rect>& nearest_free(const TurnedPair& pair, const Rect& wish, const Rect& reach);

 private:
  struct Blocked {
    TurnedPair pair;
    List<Rect> places;
  };
  struct Answer {
    TurnedPair pair;
    Rect wish, reach;
    List<Rect> places;
  };

  const List<Rect>& blocked(const TurnedPair& pair);

  const RoomType& type_;
  List<Blocked> blocked_;
  List<Answer> answers_;
};

}  // namespace furnish
