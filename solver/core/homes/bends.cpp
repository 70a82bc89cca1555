#include "homes/bends.hpp"

namespace homes {

namespace {

// The court of a U is at least so deep.
constexpr i64 COURT_MM = 1500;

// How far a wing juts out to the north and to the south; negative where the public block does.
struct Jogs {
  i64 north, south;
};

Jogs jogs_of(i64 public_depth, const Wing& wing, i64 offset) { return {-offset, offset + wing.depth() - public_depth}; }

bool is_line(i64 jog) { return jog == 0 || magnitude(jog) >= JOG_MM; }

struct OneWing {
  i64 all[5];
  i32 size = 0;
};

// A wing's offsets: flush with either side, in the middle, as far out as its hallway allows.
OneWing offsets_of(i64 public_depth, const Wing& wing) {
  const i64 first = -wing.north, last = public_depth - wing.hallway - wing.north, flush = public_depth - wing.depth();
  const i64 tried[] = {0, flush, floor_div(floor_div(flush, 2), LATTICE_MM) * LATTICE_MM, first, last};
  OneWing found;
  for (const i64 offset : tried) {
    const Jogs jogs = jogs_of(public_depth, wing, offset);
    bool fresh = first <= offset && offset <= last && is_line(jogs.north) && is_line(jogs.south);
    for (i32 i = 0; i < found.size; i++) fresh = fresh && found.all[i] != offset;
    if (fresh) found.all[found.size++] = offset;
  }
  return found;
}

bool is_outline(Outline outline, Span<const Jogs> jogs) {
  bool bent = false;
  for (const Jogs& one : jogs) bent = bent || one.north || one.south;
  if (!bent) return outline == Outline::rectangle;
  if (jogs.size == 1) {
    const Jogs& one = jogs[0];
    if (!one.north || !one.south) return outline == Outline::l;
    return outline == Outline::t && (one.north > 0) == (one.south > 0);
  }
  const i64 north = least(jogs[0].north, jogs[1].north), south = least(jogs[0].south, jogs[1].south);
  return outline == Outline::u && (north >= COURT_MM || south >= COURT_MM);
}

}  // namespace

OffsetList offsets(Outline outline, i64 public_depth, Span<const Wing> wings) {
  OffsetList found;
  OneWing each[MOST_WINGS];
  for (i32 k = 0; k < wings.size; k++) each[k] = offsets_of(public_depth, wings[k]);
  const bool two = wings.size == 2;
  for (i32 i = 0; i < each[0].size; i++) {
    for (i32 j = 0; j < (two ? each[1].size : 1); j++) {
      const Offsets chosen = {{each[0].all[i], two ? each[1].all[j] : 0}};
      Jogs jogs[MOST_WINGS];
      for (i32 k = 0; k < wings.size; k++) jogs[k] = jogs_of(public_depth, wings[k], chosen.of[k]);
      if (is_outline(outline, {jogs, wings.size})) found.all[found.size++] = chosen;
    }
  }
  return found;
}

}  // namespace homes
