#include "placement/barriers.hpp"

#include "placement/frames.hpp"

namespace placement {

void add_row(const Work& work, const DifferenceRow& row) { work.rows[work.counts->rows++] = row; }

// The wall towards which a stand's body is used if nobody can pass the body's ends, else NO_WALL.
static Wall barred(const Room& room, const Work& work, i64 stand) {
  const i64 piece = work.parts[stand].piece;
  const Wall wall = facing(work.parts[stand].stand, work.rotation[piece]);
  const i64 along = wall == EAST || wall == WEST ? 1 : 0;
  i64 at = stand;
  while (work.parts[at].piece == piece && work.parts[at].stand != 0) at--;
  const Part& body = work.parts[at];
  const i64 left = room.space->high[along] - room.space->low[along] - body.extent[along];
  return left < room.space->robot && body.low < HEADROOM_MM ? wall : NO_WALL;
}

// Keeps another stand on the side of a body that its own stand is on.
static void keep_beside(const Work& work, const Part& stand, const Part& other, Wall wall) {
  const i64 axis = wall == EAST || wall == WEST ? 0 : 1;
  const i64 u = stand.variable[axis], v = other.variable[axis];
  const i64 near = stand.offset[axis], far = other.offset[axis];
  if (wall == NORTH || wall == WEST) {
    add_row(work, {axis, v, u, far + other.extent[axis] - near - stand.extent[axis]});
  } else {
    add_row(work, {axis, u, v, near - far});
  }
}

// Keeps a body with a stand on the far side of a door.
static void keep_door(const Work& work, const Part& stand, const Door& door, Wall wall) {
  const i64 axis = wall == EAST || wall == WEST ? 0 : 1;
  const i64 u = stand.variable[axis], near = stand.offset[axis], half = floor_div(stand.extent[axis], 2);
  if (wall == NORTH || wall == WEST) {
    add_row(work, {axis, ORIGIN, u, floor_div(door.low[axis], 2) - half - near - 1});
  } else {
    add_row(work, {axis, u, ORIGIN, half + near - floor_div(door.high[axis], 2) - 1});
  }
}

void add_barriers(const Room& room, const Work& work, i64 known) {
  if (room.space->outer > 1) return;  // one can come in on both sides
  const i64 count = work.counts->parts;
  for (i64 k = 0; k < count; k++) {
    const Part& stand = work.parts[k];
    if (stand.stand == 0 || stand.stand == EMPTY_FLOOR) continue;
    const Wall wall = barred(room, work, k);
    if (wall == NO_WALL) continue;
    for (i64 other = k >= known ? 0 : known; other < count; other++) {
      const bool same = work.parts[other].piece == stand.piece, overhead = work.parts[other].low >= HEADROOM_MM;
      if (work.parts[other].stand == 0 || overhead || other == k || (same && k < known)) continue;
      keep_beside(work, stand, work.parts[other], wall);
    }
    if (k >= known) {
      for (i64 door = 0; door < room.doors.size; door++) keep_door(work, stand, room.doors[door], wall);
    }
  }
}

}  // namespace placement
