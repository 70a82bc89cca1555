// The search for a home of one programme in one outline: some deals, some moves, always by counts.
#pragma once

#include "homes/judge.hpp"
#include "homes/programme.hpp"
#include "plain/tables.hpp"

namespace homes {

constexpr i32 TRIES = 3;

// What the host sends first; rooms, kinds, the numbers of rectangles of the ways to cut a given outline, and those rectangles follow.
struct SearchHeader {
  i32 outline;  // Outline
  i32 rooms, kinds, tilings;
  WallSizes walls;
  f64 wished;  // depth of a strip in a house of the rooms' typical areas, mm
};

// A skeleton to search in: the frame of its house, and the streams that its tries begin with.
struct SearchKind {
  i64 kind;
  Frame frame;
  u64 streams[TRIES];
};

// What the host is answered; the rectangles of the rooms and then of the hallways follow. Nothing else where nothing was found.
struct FoundHome {
  i64 found;
  i64 kind;
  i64 width, depth;
  HomeVerdict verdict;
};

// Searches in one kind after the other until a home of one has no room that is short or cannot be entered; of an outline that is not given
// and no rectangle there is one kind. A rectangle is always found.
Bytes search(Bytes request);

}  // namespace homes
