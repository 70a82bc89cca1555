// Outlines that are no rectangles: where a wing may lie beside the public rooms, and what outline that makes.
//
// Positions are along z, mm: the public block begins at 0, a wing at its offset, negative where it juts out to the north. A wing's hallway
// ends at the public block, over its whole width.
#pragma once

#include "homes/drafts.hpp"

namespace homes {

// A wing that is not flush is out of line by at least this: less looks like a mistake.
constexpr i64 JOG_MM = 900;
constexpr i32 MOST_WINGS = 2;

// Depths of a wing's strips north and south of its hallway, and of that.
struct Wing {
  i64 north, hallway, south;

  i64 depth() const { return north + hallway + south; }
};

// Where the wings of a home begin: one offset a wing.
struct Offsets {
  i64 of[MOST_WINGS];
};

struct OffsetList {
  Offsets all[25];
  i32 size = 0;
};

// Where wings may begin so that a home has an outline, beside a public block of a depth. A U has two wings and a court between them; it
// may have one on either side, as an H.
OffsetList offsets(Outline outline, i64 public_depth, Span<const Wing> wings);

}  // namespace homes
