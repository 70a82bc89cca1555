// A whole room with all its pieces: arranged, where walking alone stands against the required ones with floor kept empty, and where they
// cannot all stand with one required piece after the other left out. And with ways between its doors as wide as its furniture allows.
#pragma once

#include "placement/reshape.hpp"
#include "placement/space.hpp"
#include "plain/lists.hpp"

namespace placement {

// A required piece that was left out, by its number in the room asked for, and whether it is certain that it could not stand.
struct LeftOut {
  i64 piece, certain;
};

// A room whose candidates are chosen; the placement is on the desk.
struct WholeRoom {
  Desk* desk;
  NumberedRoom asked;  // what is on the desk
  List<LeftOut> left_out;
  bool walk;  // whether only walkable placements were looked for: where not even the empty room is walkable, nobody asks
  bool with_floor;
  bool complete;  // all required pieces but those left out stand
  bool proven;  // it is the optimum, and none left out could stand beside those before it
  bool best;  // no other candidates of the required pieces are cheaper
  i64 solves;
  i64 ways;  // how wide the ways between doors are, where they are wider than asked
};

// Chooses a candidate for every piece that fits.
//
//   room: required pieces first.
//   budget: work it may cost; what is left is written there.
//   walk: whether doors and use sides must be joined.
WholeRoom arrange_whole(const Room& room, const RoomLimits& limits, f64& budget, bool walk);

// The same, walked in, with the widest ways between its doors that are worth what they cost; each width may cost the budget.
// `spent`: the work of all widths is added there.
WholeRoom arrange_wide(const Room& room, const RoomLimits& limits, f64 budget, f64& spent);

// Asks for the same decisions in the same room for another person: `room` is the one first asked for. False where nothing was found.
bool arrange_again(const Room& room, const WholeRoom& before, i64 limit, WholeRoom& found);

}  // namespace placement
