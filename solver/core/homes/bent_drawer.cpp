#include "homes/drawer.hpp"

namespace homes {

namespace {

// Positions of wings are along z, mm: the public block begins at 0, a wing at its offset, negative where it juts out to the north. A wing's
// hallway ends at the public block, over its whole width.

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

// Where wings may begin so that a home has an outline, beside a public block of a depth. A U has two wings and a court between them; it
// may have one on either side, as an H.
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

// Depth of a garage at the end of a wing: a car with space to walk around it.
constexpr i64 GARAGE_MM = 5700;

OffsetList offsets_of(const Draft& draft, Outline outline, i64 hallway) {
  Wing wings[MOST_WINGS];
  i32 count = 0;
  for (i32 k = 2; k + 1 < draft.strips; k += 2) wings[count++] = {draft.depth[k], hallway, draft.depth[k + 1]};
  return offsets(outline, draft.depth[0] + draft.depth[1], {wings, count});
}

// A strip without columns has no depth.
void close_empty(Draft& draft) {
  for (i32 k = 0; k < draft.strips; k++) {
    if (draft.is_empty(k)) draft.depth[k] = 0;
  }
}

// The first strip of wings that is flush with the public rooms; every second one behind it is too.
i32 first_flush(const Draft& draft) { return draft.bend == Bend::north_out ? 3 : 2; }

// Moves rooms so that the least rectangle around them begins at nought.
void settle(Sheet& sheet) {
  Rect bounds = sheet.boxes[0];
  for (const Rect& box : sheet.all()) bounds = bounds.with(box);
  for (i32 i = 0; i < sheet.rooms + sheet.hallways; i++) sheet.boxes[i] = sheet.boxes[i].moved(-bounds.x0, -bounds.z0);
  sheet.width = bounds.width();
  sheet.depth = bounds.depth();
}

// How long a strip may be.
WidthRange length_of(Span<const WidthRange> row) {
  WidthRange all = {0, 0, 0, false};
  for (const WidthRange& span : row) {
    all.low += span.low;
    all.wished += span.wished;
    all.high += span.high;
  }
  all.wished = least(most(snapped(all.wished), all.low), all.high);
  return all;
}

// Makes the lengths of two strips differ by at least so much; false where they cannot.
bool set_apart(const WidthRange* rows, i64 by, i64* lengths) {
  const i32 longer = rows[1].wished > rows[0].wished ? 1 : 0, shorter = 1 - longer;
  for (i32 k = 0; k < 2; k++) lengths[k] = rows[k].wished;
  lengths[longer] += most<i64>(0, least(by - (lengths[longer] - lengths[shorter]), rows[longer].high - lengths[longer]));
  lengths[shorter] -= most<i64>(0, least(by - (lengths[longer] - lengths[shorter]), lengths[shorter] - rows[shorter].low));
  return lengths[longer] - lengths[shorter] >= by;
}

}  // namespace

void BentDrawer::choose_depths(Draft& draft, Stream& stream) const {
  for (i32 i = 0; i < CHOICES; i++) {
    for (i32 first = draft.strips > 2 ? 2 : 0; first < draft.strips; first += 2) choose_pair(draft, first, stream);
    if (draft.kind != Kind::rows) choose_public(draft, stream);
    close_empty(draft);
    if (draft.kind == Kind::rows || offsets_of(draft, outline_, columns_.walls().hallway).size) return;
  }
}

void BentDrawer::choose_pair(Draft& draft, i32 first, Stream& stream) const {
  for (i32 k = first; k < first + 2; k++) {
    if (!draft.is_empty(k ^ 1)) continue;
    draft.depth[k] = drawn_near(DepthList(possible(draft, k)), stream);
    return;
  }
  Drawer::choose_pair(draft, first, 0, stream);
}

// Chooses the public rooms' depths: free, or what is flush with the hallways and the strips beyond.
void BentDrawer::choose_public(Draft& draft, Stream& stream) const {
  if (draft.bend == Bend::free) return choose_pair(draft, 0, stream);
  const i32 first = first_flush(draft);
  const u64 suits = possible(draft, draft.is_empty(0) ? 1 : 0);
  u64 common = EVERY_DEPTH;
  for (i32 k = first; k < draft.strips; k += 2) common &= possible(draft, k);
  DepthList depths(0);
  for (const i64 depth : DepthList(common).all()) {
    if (suits >> place_of(depth + columns_.walls().hallway) & 1) depths.depths[depths.size++] = depth;
  }
  const i64 wished = depths.size ? stream.pick(depths.all()) : draft.depth[first];
  for (i32 k = first; k < draft.strips; k += 2) draft.depth[k] = nearest(possible(draft, k), wished);
  make_flush(draft);
}

// Makes flush strips as deep as the first of them, and the public rooms as deep as these and the hallway.
void BentDrawer::make_flush(Draft& draft) const {
  const i32 first = first_flush(draft);
  for (i32 k = first; k < draft.strips; k += 2) draft.depth[k] = draft.depth[first];
  const i64 together = draft.depth[first] + columns_.walls().hallway;
  if (!draft.is_empty(0) && !draft.is_empty(1)) {
    share(draft.depth, 0, together);
  } else {
    draft.depth[draft.is_empty(0) ? 1 : 0] = together;
  }
}

// Makes a changed draft's depths near ones that its columns can have.
void BentDrawer::fit_depths(Draft& draft) const {
  for (i32 k = 0; k < draft.strips; k++) {
    draft.depth[k] = nearest(possible(draft, k), draft.depth[k] ? draft.depth[k] : whole(wished_));
  }
  if (draft.kind != Kind::rows && draft.bend != Bend::free) make_flush(draft);
  close_empty(draft);
}

// Draws a draft; one whose strips do not come out is a misfit: nothing stretches a free outline.
Misfit BentDrawer::draw(const Draft& draft, Sheet& sheet) const {
  for (i32 k = 0; k < draft.strips; k++) {
    if (!draft.is_empty(k) && draft.depth[k] < 2 * LATTICE_MM) return Misfit::by(columns_.rooms(), 0);
  }
  if (draft.kind == Kind::rows) return rows(draft, sheet);
  const i64 hallway = columns_.walls().hallway;
  const OffsetList chosen = offsets_of(draft, outline_, hallway);
  const i64 beyond = draft.apart ? magnitude(draft.depth[2] + hallway + draft.depth[3] - GARAGE_MM) : 0;
  if (!chosen.size || (beyond > 0 && beyond < JOG_MM)) return Misfit::by(0, JOG_MM);
  StripPair pairs[1 + MOST_WINGS];
  const i32 count = draft.strips / 2;
  for (i32 k = 0; k < count; k++) {
    const Misfit misfit = pair(draft, 2 * k, false, pairs[k]);
    if (!misfit.fits) return misfit;
  }
  return winged(draft, {pairs, count}, chosen.all[draft.turn % chosen.size].of, sheet);
}

// Lays the western wing, the public rooms and the eastern wing side by side, and garages at the eastern end.
Misfit BentDrawer::winged(const Draft& draft, Span<const StripPair> pairs, const i64* chosen, Sheet& sheet) const {
  constexpr i32 ORDER[] = {2, 0, 1};
  const i64 hallway = columns_.walls().hallway;
  sheet.begin(columns_.rooms());
  i64 at = 0;
  for (i32 i = 3 - pairs.size; i < 3; i++) {
    const i32 k = ORDER[i];
    const i64 offset = k ? chosen[k - 1] : 0, length = pairs[k].wished;
    block(draft, k, pairs[k], {at, offset}, sheet);
    const i64 line = offset + draft.depth[2 * k];
    if (k) sheet.add_hallway({at, line, at + length, line + hallway});
    at += length;
  }
  const i64 south = chosen[0] + draft.depth[2] + hallway + draft.depth[3];
  for (i32 i = 0; draft.apart && i < garages_.size; i++) {
    const i64 width = columns_.width(Column::of(garages_[i]), GARAGE_MM).wished;
    sheet.boxes[garages_[i]] = {at, south - GARAGE_MM, at + width, south};
    at += width;
  }
  settle(sheet);
  return Misfit::none();
}

// Lays a pair of strips at a north-west corner; the second wing's columns begin at their eastern end.
void BentDrawer::block(const Draft& draft, i32 which, const StripPair& pair, Point corner, Sheet& sheet) const {
  const i64 first = draft.depth[2 * which], second = draft.depth[2 * which + 1];
  const StripPlace places[] = {
      {corner.x, corner.z + first, first}, {corner.x, corner.z + first + (which ? columns_.walls().hallway : 0), -second}};
  for (i32 row = 0; row < 2; row++) {
    const Span<const Column> strip = draft.in(2 * which + row);
    if (!strip.size) continue;
    Column columns[MOST_ROOMS];
    WidthRange spans[MOST_ROOMS];
    i64 widths[MOST_ROOMS];
    for (i32 i = 0; i < strip.size; i++) {
      const i32 from = which == 2 ? strip.size - 1 - i : i;
      columns[i] = strip[from];
      spans[i] = pair.spans[row][from];
    }
    shared_out(pair.wished, {spans, strip.size}, widths);
    lay({columns, strip.size}, widths, places[row], sheet);
  }
}

// Lays two strips of different lengths behind each other.
Misfit BentDrawer::rows(const Draft& draft, Sheet& sheet) const {
  StripPair pair;
  i64 bad = 0, lengths[2], widths[MOST_ROOMS];
  for (i32 k = 0; k < 2; k++) {
    spans_of(draft, k, pair);
    for (const WidthRange& span : pair.row(k)) bad += span.misses;
  }
  if (bad || !pair.count[0] || !pair.count[1]) return Misfit::by(bad, JOG_MM);
  const WidthRange whole[] = {length_of(pair.row(0)), length_of(pair.row(1))};
  if (!set_apart(whole, outline_ == Outline::l ? JOG_MM : 2 * JOG_MM, lengths)) return Misfit::by(0, JOG_MM);
  const i64 spare = magnitude(lengths[0] - lengths[1]);
  const i64 inset = outline_ == Outline::t ? floor_div(floor_div(spare, 2), LATTICE_MM) * LATTICE_MM : spare * (draft.turn % 2);
  sheet.begin(columns_.rooms());
  for (i32 k = 0; k < 2; k++) {
    const i64 at = lengths[k] < most(lengths[0], lengths[1]) ? inset : 0;
    shared_out(lengths[k], pair.row(k), widths);
    lay(draft.in(k), widths, {at, draft.depth[0], k ? -draft.depth[1] : draft.depth[0]}, sheet);
  }
  settle(sheet);
  return Misfit::none();
}

}  // namespace homes
