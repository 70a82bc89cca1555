#include "placement/pull.hpp"

#include "placement/grid.hpp"

namespace placement {

// Places this far apart are tried from the wished one on; before the first that does, the last millimetres are bisected.
constexpr i64 STEP_MM = 50;
constexpr i64 DOUBT_MM = 2;  // each measure of a patch counts it narrower or wider by less than this

enum class Way { ALONG_X, ALONG_Z, STRAIGHT };

static bool holds_at(const Table<i64>& positions, const DifferenceRow& row) {
  return place_of(positions, row.axis, row.j) - place_of(positions, row.axis, row.i) >= row.s;
}

bool holds(const Work& work, const Table<i64>& positions) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      const i64 at = positions.at(axis, v);
      if (at < work.low.at(axis, v) || at > work.high.at(axis, v)) return false;
    }
  }
  for (i64 k = 0; k < work.counts->rows; k++) {
    if (!holds_at(positions, work.rows[k])) return false;
  }
  for (i64 c = 0; c < work.counts->choices; c++) {
    bool held = false;
    for (i64 k = OPTIONS * c; k < OPTIONS * c + work.choice_size[c] && !held; k++) held = holds_at(positions, work.options[k]);
    if (!held) return false;
  }
  return true;
}

// What the distances from the wished places cost at integer positions.
static f64 movement(const Work& work, const Table<i64>& positions) {
  f64 cost = 0.0;
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      const f64 away = static_cast<f64>(positions.at(axis, v)) / 1000 - work.anchor_at.at(axis, v);
      cost += work.anchor_weight.at(axis, v) * away * away;
    }
  }
  return cost;
}

// A variable's wished place within its bounds, mm; halves go down, as in the snap.
static i64 wished(const Work& work, i64 axis, i64 v) {
  const i64 at = whole(floor(work.anchor_at.at(axis, v) * 1000 + 0.49));
  return least(most(at, work.low.at(axis, v)), work.high.at(axis, v));
}

// Tells whether the patch that the walk entered would be entered, and be large enough, by any measure.
// How large a patch is depends on the millimetre by which the person is smaller; a room in which nobody comes in is entered at the largest.
static bool floor_is_sure(const Room& room, const WalkGrid& grid) {
  const SpaceRow& space = *room.space.data;
  const i64 entered = grid.state->entered;
  const i64 doubt = 2 * DOUBT_MM * (space.high[0] - space.low[0] + space.high[1] - space.low[1]);
  if (space.least_floor > 0 && grid.areas[entered] < 4 * space.least_floor + doubt) return false;
  if (!is_walked_in_largest(room)) return true;
  for (i64 c = 1; c <= grid.state->components; c++) {
    if (c != entered && grid.areas[c] + 2 * doubt > grid.areas[entered]) return false;
  }
  return true;
}

// One body that is brought back: its variables, where they were, and how far in all they are from where they are wished.
struct Pull {
  const Engine& engine;
  i64 u, v;
  i64 x, z, dx, dz;
  i64 far;
  i64& walks;  // how many are left

  // Puts the body `part` of `far` parts of the way.
  void put(i64 part) const {
    engine.grid.positions.at(0, u) = x + floor_div(dx * part, far);
    engine.grid.positions.at(1, v) = z + floor_div(dz * part, far);
  }

  // Puts it there and tells whether all holds.
  bool may(i64 part) const {
    if (walks <= 0) return false;
    put(part);
    const Table<i64>& p = engine.grid.positions;
    if (!holds(engine.work, p)) return false;
    walks--;
    return walkable(engine.room, engine.work, engine.grid, p) && floor_is_sure(engine.room, engine.grid);
  }
};

// How much of the way a body can go: the farthest step that does, then bisected up to the step beyond.
static i64 farthest(const Pull& own) {
  i64 good = 0, bad = own.far + 1;
  while (bad > 1) {
    const i64 at = bad > own.far ? own.far : (bad - 1) / STEP_MM * STEP_MM;
    if (at == 0) break;
    if (own.may(at)) {
      good = at;
      break;
    }
    bad = at;
  }
  while (bad - good > 1) {
    const i64 middle = (good + bad) / 2;
    if (own.may(middle)) {
      good = middle;
    } else {
      bad = middle;
    }
  }
  return good;
}

// Brings one body back as far as it goes; tells whether it moved.
static bool pull(const Engine& engine, i64 u, i64 v, Way way, i64& walks) {
  const i64 x = engine.grid.positions.at(0, u), z = engine.grid.positions.at(1, v);
  const i64 dx = way == Way::ALONG_Z ? 0 : wished(engine.work, 0, u) - x;
  const i64 dz = way == Way::ALONG_X ? 0 : wished(engine.work, 1, v) - z;
  const i64 far = most(magnitude(dx), magnitude(dz));
  if (far == 0 || (way == Way::STRAIGHT && (dx == 0 || dz == 0))) return false;
  const Pull own = {engine, u, v, x, z, dx, dz, far, walks};
  const i64 good = farthest(own);
  own.put(good);
  return good > 0;
}

// Brings every body back once; tells whether one moved. What is not wished anywhere stays.
static bool pull_all(const Engine& engine, i64& walks) {
  const Work& work = engine.work;
  bool moved = false;
  for (i64 k = 0; k < work.counts->parts; k++) {
    const Part& part = work.parts[k];
    const i64 u = part.variable[0], v = part.variable[1];
    if (part.stand == 1 || work.anchor_weight.at(0, u) == 0 || work.anchor_weight.at(1, v) == 0) continue;
    const Way ways[] = {Way::STRAIGHT, Way::ALONG_Z, Way::ALONG_X};
    for (const Way way : ways) moved |= pull(engine, u, v, way, walks);
  }
  return moved;
}

bool pull_back(const Engine& engine, i64& walks) {
  const Work& work = engine.work;
  const Table<i64>& p = engine.grid.positions;
  for (i64 axis = 0; axis < 2; axis++) p.at(axis, p.columns - 1) = 0;
  if (!holds(work, p) || !walkable(engine.room, work, engine.grid, p)) return false;
  while (pull_all(engine, walks)) continue;  // each brings bodies nearer, by millimetres; nearly always the second changes nothing
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) engine.nodes.best.at(axis, v) = static_cast<f64>(p.at(axis, v)) / 1000;
  }
  engine.nodes.best_cost[0] = movement(work, p);
  engine.nodes.result->found = 1;
  engine.nodes.result->exhausted = engine.nodes.result->picks = engine.nodes.result->forces = 0;
  return true;
}

}  // namespace placement
