#include "homes/drawer.hpp"

namespace homes {

namespace {

// A strip is never made slimmer than this for the other's sake.
constexpr i64 SLIM_MM = 1600;
constexpr i64 UNBOUNDED_MM = 1 << 30;

}  // namespace

void Drawer::choose_depths(Draft& draft, Stream& stream) const {
  const i32 last = draft.strips - 2;
  const i64 together = across(draft.kind);
  for (i32 i = 0; i < CHOICES; i++) {
    const bool fits = choose_pair(draft, last, together, stream);
    if (!last || (choose_pair(draft, 0, draft.depth[2] + draft.depth[3] + hallway_of(draft.kind), stream) && fits)) break;
  }
  close(draft, together);
}

// Chooses the depths of two strips; tells whether both suit their columns.
bool Drawer::choose_pair(Draft& draft, i32 first, i64 together, Stream& stream) const {
  i64* depths = draft.depth;
  DepthList north(possible(draft, first));
  const u64 south = possible(draft, first + 1);
  if (together) {
    DepthList both(0);
    for (const i64 depth : north.all()) {
      if (south >> place_of(together - depth) & 1) both.depths[both.size++] = depth;
    }
    depths[first] = stream.pick((both.size ? both : north).all());
    share(depths, first, together);
    return both.size > 0;
  }
  i64 areas[2] = {0, 0};
  for (i32 k = 0; k < 2; k++) {
    for (const Column& column : draft.in(first + k)) areas[k] += columns_.area(column);
  }
  const i64 depth = drawn_near(north, stream);
  depths[first] = depth;
  depths[first + 1] = nearest(south, floor_div(floor_div(areas[1] * depth, most<i64>(areas[0], 1)), DEPTH_STEP_MM) * DEPTH_STEP_MM);
  return true;
}

// Draws two depths and returns the one nearer to what is wished.
i64 Drawer::drawn_near(const DepthList& depths, Stream& stream) const {
  const i64 one = depths.depths[stream.below(depths.size)], other = depths.depths[stream.below(depths.size)];
  return absolute(static_cast<f64>(other) - wished_) < absolute(static_cast<f64>(one) - wished_) ? other : one;
}

// The depths at which a strip's columns have a width, as bits; columns that leave none are passed over.
u64 Drawer::possible(const Draft& draft, i32 strip) const {
  u64 common = EVERY_DEPTH;
  for (const Column& column : draft.in(strip)) {
    const u64 left = common & columns_.depths(column);
    if (left) common = left;
  }
  return common;
}

i64 Drawer::hallway_of(Kind kind) const {
  return kind == Kind::rows ? 0 : kind == Kind::axial ? columns_.walls().centre : columns_.walls().hallway;
}

// What the last two strips' depths add up to, 0 where it is free.
i64 Drawer::across(Kind kind) const {
  const i64 extent = kind == Kind::axial ? frame_.width : frame_.depth;
  return extent ? extent - hallway_of(kind) : 0;
}

void Drawer::fit_depths(Draft& draft) const {
  const i32 last = draft.strips - 2;
  const i64 together = across(draft.kind);
  for (i32 k = 0; k < draft.strips; k++) draft.depth[k] = nearest(possible(draft, k), draft.depth[k]);
  if (together) share(draft.depth, last, together);
  if (last) share(draft.depth, 0, draft.depth[2] + hallway_of(draft.kind) + draft.depth[3]);
  close(draft, together);
}

// Gives the depth of a strip without columns to the other one of its pair, where both make up a whole.
void Drawer::close(Draft& draft, i64 across) {
  for (i32 k = 0; k < draft.strips; k++) {
    if (!draft.is_empty(k)) continue;
    if (across || k < draft.strips - 2) draft.depth[k ^ 1] += draft.depth[k];
    draft.depth[k] = 0;
  }
}

// Makes two depths add up; the first is kept unless that leaves the second next to nothing.
void Drawer::share(i64* depths, i32 first, i64 together) {
  if (together - depths[first] < SLIM_MM) depths[first] = floor_div(floor_div(together, 2), LATTICE_MM) * LATTICE_MM;
  depths[first + 1] = together - depths[first];
}

Misfit Drawer::draw(const Draft& draft, bool stretch, Sheet& sheet) const {
  for (i32 k = 0; k < draft.strips; k++) {
    if (!draft.is_empty(k) && draft.depth[k] < 2 * LATTICE_MM) return Misfit::by(columns_.rooms(), 0);
  }
  StripPair pairs[2];
  const i32 count = draft.strips / 2;
  for (i32 k = 0; k < count; k++) {
    const Misfit misfit = pair(draft, 2 * k, stretch, pairs[k]);
    if (!misfit.fits) return misfit;
  }
  return drawn(draft, {pairs, count}, stretch, sheet);
}

void Drawer::spans_of(const Draft& draft, i32 strip, StripPair& pair) const {
  i32& count = pair.count[strip % 2];
  count = 0;
  for (const Column& column : draft.in(strip)) pair.spans[strip % 2][count++] = columns_.width(column, draft.depth[strip]);
}

// Finds the lengths that two strips may both have.
Misfit Drawer::pair(const Draft& draft, i32 first, bool stretch, StripPair& pair) const {
  i64 bad = 0, wished = 0;
  pair.low = 0;
  pair.high = UNBOUNDED_MM;
  for (i32 k = 0; k < 2; k++) spans_of(draft, first + k, pair);
  const bool none = !pair.count[0] && !pair.count[1];
  for (i32 k = 0; k < 2; k++) {
    if (!pair.count[k] && !(none && k == 0)) continue;
    i64 fewest = 0, greatest = 0;
    for (const WidthRange& span : pair.row(k)) {
      fewest += span.low;
      greatest += span.high;
      wished += span.wished;
      bad += span.misses;
    }
    pair.low = most(pair.low, fewest);
    pair.high = least(pair.high, greatest);
  }
  wished = snapped(floor_div(wished, pair.count[0] && pair.count[1] ? 2 : 1));
  if (stretch) {
    pair.low = pair.wished = pair.high = wished;
    return Misfit::none();
  }
  if (bad || pair.low > pair.high) return Misfit::by(bad, most<i64>(pair.low - pair.high, 0));
  pair.wished = least(most(wished, pair.low), pair.high);
  return Misfit::none();
}

// Lays pairs of strips side by side.
Misfit Drawer::drawn(const Draft& draft, Span<const StripPair> pairs, bool stretch, Sheet& sheet) const {
  i64 lengths[2], widths[MOST_ROOMS], misses = 0, at = 0, deep = 0;
  const i64 along = draft.kind == Kind::axial ? frame_.depth : frame_.width;
  WidthRange spans[2];
  for (i32 k = 0; k < pairs.size; k++) spans[k] = {pairs[k].low, lengths[k] = pairs[k].wished, pairs[k].high, false};
  if (along) shared_out(along, {spans, pairs.size}, lengths);
  for (i32 k = 0; k < pairs.size; k++) misses += most(most(spans[k].low - lengths[k], lengths[k] - spans[k].high), 0LL);
  if (misses && !stretch) return Misfit::by(0, misses);
  sheet.begin(columns_.rooms());
  for (i32 k = 0; k < pairs.size; k++) {
    const i64 gap = draft.kind == Kind::ranch && k == 0 ? 0 : hallway_of(draft.kind);
    const i64 first = draft.depth[2 * k], second = draft.depth[2 * k + 1];
    for (i32 row = 0; row < 2; row++) {
      if (draft.is_empty(2 * k + row)) continue;
      shared_out(lengths[k], pairs[k].row(row), widths);
      lay(draft.in(2 * k + row), widths, row ? StripPlace{at, first + gap, -second} : StripPlace{at, first, first}, sheet);
    }
    if (gap) sheet.add_hallway({at, first, at + lengths[k], first + gap});
    at += lengths[k];
    deep = first + gap + second;
  }
  sheet.width = at;
  sheet.depth = deep;
  if (draft.kind == Kind::axial) turn(draft, sheet);
  return Misfit::none();
}

// Lays the columns of a strip side by side.
void Drawer::lay(Span<const Column> strip, const i64* widths, StripPlace place, Sheet& sheet) const {
  i64 at = place.at, parts[MOST_STACKED];
  for (i32 k = 0; k < strip.size; k++) {
    const Column& column = strip[k];
    columns_.share_depth(column, widths[k], magnitude(place.depth), parts);
    i64 inner = place.line;
    for (i32 i = 0; i < column.size; i++) {
      const bool before = place.depth > 0;
      const i64 outer = before ? inner - parts[i] : inner + parts[i];
      sheet.boxes[column.rooms[i]] = {at, before ? outer : inner, at + widths[k], before ? inner : outer};
      inner = outer;
    }
    at += widths[k];
  }
}

// Turns an axial house so that its hallway runs back from the street, and puts the entry at its end: in half of it at most.
void Drawer::turn(const Draft& draft, Sheet& sheet) const {
  for (i32 i = 0; i < sheet.rooms; i++) {
    const Rect box = sheet.boxes[i];
    sheet.boxes[i] = {box.z0, box.x0, box.z1, box.x1};
  }
  Rect& hallway = sheet.boxes[sheet.rooms];
  const i64 west = hallway.z0, east = hallway.z1, along = sheet.width;
  i64 end = along;
  if (draft.entry >= 0) {
    end = most(along - columns_.width(Column::of(draft.entry), east - west).wished, floor_div(along, 2));
    sheet.boxes[draft.entry] = {west, end, east, along};
  }
  hallway = {west, 0, east, end};
  sheet.width = sheet.depth;
  sheet.depth = along;
}

}  // namespace homes
