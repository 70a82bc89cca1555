// The exact check of a frame: the rules of validate/, on the room with its bodies at their new spots.
#include "drag/drag.hpp"
#include "plain/least_floor.hpp"

namespace drag {

constexpr i64 LEAST_FLOOR = LEAST_FLOOR_MM2 * (validate::PER_METRE / 1000) * (validate::PER_METRE / 1000);  // in square lattice steps

// Tells whether enough use sides of every body can be come to.
static bool is_used(const validate::Storey& storey) {
  const validate::Walk walk = validate::walk_of(storey);
  const validate::Placed& placed = storey.rooms[0];
  const validate::Area entered = validate::walked_floor(storey, walk, placed).entered;
  if (entered.high == 0 && entered.low < static_cast<u64>(LEAST_FLOOR)) return false;
  for (const validate::Body& body : placed.room.bodies) {
    if (validate::missed_sides(storey, walk, placed, body) != 0) return false;
  }
  return true;
}

bool is_valid(const Drag& drag, const Frame& frame) {
  const arena::Scope scope;
  for (i64 k = 0; k < drag.rows.size; k++) {
    drag.rows[k].x = frame.spots[k].x;
    drag.rows[k].z = frame.spots[k].z;
  }
  Reader reader(drag.storey);
  const validate::Storey storey = validate::read_storey(reader);
  validate::Findings found{0, {}};
  validate::find_standing(storey.rooms[0].room, found);
  validate::find_floating(storey.rooms[0].room, found);
  return found.rows.size() == 0 && is_used(storey);
}

}  // namespace drag
