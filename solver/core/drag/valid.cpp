// The exact check of a frame: the rules of validate/, on the room with its bodies at their new spots.
#include "drag/drag.hpp"
#include "plain/least_floor.hpp"

namespace drag {

constexpr i64 LEAST_FLOOR = LEAST_FLOOR_MM2 * (validate::PER_METRE / 1000) * (validate::PER_METRE / 1000);  // in square lattice steps

// Tells whether a use side of every body can be come to, or all of them where all are needed.
static bool is_used(const Drag& drag, const validate::Storey& storey) {
  const validate::Walk walk = validate::walk_of(storey);
  const validate::Placed& placed = storey.rooms[0];
  const validate::Area entered = validate::walked_floor(storey, walk, placed).entered;
  if (entered.high == 0 && entered.low < static_cast<u64>(LEAST_FLOOR)) return false;
  for (i64 k = 0; k < drag.riders.size; k++) {
    const Rider& rider = drag.riders[k];
    i64 reached = 0;
    for (i64 side = 0; side < 4; side++) {
      if (((rider.any_of | rider.all_of) >> side & 1) == 0) continue;
      const Rect box = validate::moved(placed.room.bodies[k].box, placed.x, placed.z);
      if (validate::touches(walk, box, WALLS[side], storey.reach)) reached |= 1LL << side;
    }
    if ((rider.all_of & ~reached) != 0 || (rider.any_of != 0 && (rider.any_of & reached) == 0)) return false;
  }
  return true;
}

bool is_valid(const Drag& drag, const Frame& frame) {
  const arena::Scope scope;
  for (i64 k = 0; k < drag.rows.size; k++) {
    drag.rows[k].x = frame.spots[k].x;
    drag.rows[k].z = frame.spots[k].z;
  }
  validate::Reader reader(drag.storey);
  const validate::Storey storey = validate::read_storey(reader);
  validate::Findings found{0, {}};
  validate::find_standing(storey.rooms[0].room, found);
  validate::find_floating(storey.rooms[0].room, found);
  return found.rows.size() == 0 && is_used(drag, storey);
}

}  // namespace drag
