#include "homes/widths.hpp"

namespace homes {

namespace {

// No stack is wider: twice the widest that any stack of a home needs.
constexpr i64 WIDEST_MM = 12'000;
constexpr u64 KNOWN = 1ULL << 63;

// The number of lattice steps in a length, rounded down: exactly, as the remainder of a quotient that was rounded is looked at.
i64 steps_below(f64 length) {
  f64 steps = floor(length / LATTICE_MM);
  const f64 rest = length - steps * LATTICE_MM;
  if (rest < 0) steps -= 1;
  if (rest >= LATTICE_MM) steps += 1;
  return whole(steps);
}

i64 lattice_down(f64 length) { return steps_below(length) * LATTICE_MM; }
i64 lattice_up(f64 length) { return -steps_below(-length) * LATTICE_MM; }

// The least and greatest extent of a room along one axis, given the other; on the lattice.
Interval within(const RoomSize& size, i64 extent) {
  const f64 other = static_cast<f64>(extent);
  const f64 low = most(most(static_cast<f64>(size.least) / other, static_cast<f64>(size.width)), other / size.aspect);
  return {lattice_up(low), lattice_down(least(static_cast<f64>(size.most) / other, other * size.aspect))};
}

}  // namespace

DepthList::DepthList(u64 bits) : size(0) {
  for (i32 k = 0; k < DEPTHS; k++) {
    if (bits >> k & 1) depths[size++] = FIRST_DEPTH_MM + k * DEPTH_STEP_MM;
  }
}

i64 nearest(u64 bits, i64 wished) {
  if (bits >> place_of(wished) & 1) return wished;
  i64 best = -1;
  for (const i64 depth : DepthList(bits).all()) {
    if (best < 0 || magnitude(depth - wished) < magnitude(best - wished)) best = depth;
  }
  return best;
}

void shared_out(i64 length, Span<const WidthRange> spans, i64* parts) {
  i64 over = length, slack = 0, wished = 0;
  for (const WidthRange& span : spans) over -= span.wished;
  const auto spare = [&](const WidthRange& span) { return over > 0 ? span.high - span.wished : span.wished - span.low; };
  for (const WidthRange& span : spans) {
    slack += spare(span);
    wished += most<i64>(span.wished, 1);
  }
  const bool beyond = magnitude(over) > slack;
  const i64 all = beyond ? wished : slack;
  f64 exact = 0.0;
  i64 at = 0;
  for (i32 k = 0; k + 1 < spans.size; k++) {
    const i64 share = beyond ? most<i64>(spans[k].wished, 1) : spare(spans[k]);
    const f64 more = all ? static_cast<f64>(over * share) / static_cast<f64>(all) : 0.0;
    exact += static_cast<f64>(spans[k].wished) + more;
    const i64 line = whole(exact / LATTICE_MM + 0.5) * LATTICE_MM;
    parts[k] = line - at;
    at = line;
  }
  parts[spans.size - 1] = length - at;
}

Columns::Columns(Span<const RoomSize> sizes, WallSizes walls) : sizes_(sizes), walls_(walls) {
  const i32 all = sizes.size * (sizes.size + 1);
  known_ = {static_cast<u64*>(arena::zeroed(static_cast<i64>(all) * 8)), all};
}

i64 Columns::area(const Column& column) const {
  i64 area = 0;
  for (i32 k = 0; k < column.size; k++) area += sizes_[column.rooms[k]].typical;
  return area;
}

WidthRange Columns::width(const Column& column, i64 depth) const {
  const f64 wished = static_cast<f64>(area(column)) / static_cast<f64>(depth);
  if (column.size > 1) return stacked(column, depth, wished);
  const RoomSize& size = sizes_[column.rooms[0]];
  Interval found = within(size, depth);
  const bool misses = found.low > found.high || depth < most(size.width, size.length);
  if (misses) found.low = found.high = most(lattice_up(wished), size.width);
  return {found.low, least(most(lattice_down(wished + LATTICE_MM / 2.0), found.low), found.high), found.high, misses};
}

WidthRange Columns::stacked(const Column& column, i64 depth, f64 wished) const {
  i64 first = 0, least_area = 0, most_area = 0;
  for (i32 k = 0; k < column.size; k++) {
    const RoomSize& size = sizes_[column.rooms[k]];
    first = most(first, size.width);
    least_area += size.least;
    most_area += size.most;
  }
  // Widths are tried on the lattice from the first on; the areas alone rule out all below and beyond these.
  const i64 tried = floor_div(WIDEST_MM - first + LATTICE_MM - 1, LATTICE_MM);
  i64 low = most<i64>(floor_div(floor_div(least_area, depth) - first, LATTICE_MM) - 1, 0);
  i64 high = least(floor_div(floor_div(most_area, depth) - first, LATTICE_MM) + 2, tried - 1);
  while (low <= high && !stands(column, first + low * LATTICE_MM, depth)) low++;
  while (high > low && !stands(column, first + high * LATTICE_MM, depth)) high--;
  const bool misses = low > high;
  const i64 from = misses ? most(lattice_up(wished), first) : first + low * LATTICE_MM;
  const i64 to = misses ? from : first + high * LATTICE_MM;
  return {from, least(most(lattice_down(wished + LATTICE_MM / 2.0), from), to), to, misses};
}

bool Columns::stands(const Column& column, i64 width, i64 depth) const {
  i64 fewest = 0, greatest = 0;
  for (i32 k = 0; k < column.size; k++) {
    const RoomSize& size = sizes_[column.rooms[k]];
    const Interval found = within(size, width);
    const i64 low = most(found.low, size.length);
    if (low > found.high) return false;
    fewest += low;
    greatest += found.high;
  }
  return fewest <= depth && depth <= greatest;
}

u64 Columns::depths(const Column& column) {
  const i32 second = column.size > 1 ? column.rooms[1] : sizes_.size;
  u64 unkept = 0;
  u64& known = column.size > 2 ? unkept : known_[column.rooms[0] * (sizes_.size + 1) + second];
  if (!known) {
    for (i32 k = 0; k < DEPTHS; k++) {
      if (!width(column, FIRST_DEPTH_MM + k * DEPTH_STEP_MM).misses) known |= 1ULL << k;
    }
    known |= KNOWN;
  }
  return known & ~KNOWN;
}

void Columns::share_depth(const Column& column, i64 width, i64 depth, i64* parts) const {
  if (column.size == 1) {
    parts[0] = depth;
    return;
  }
  WidthRange spans[MOST_STACKED];
  for (i32 k = 0; k < column.size; k++) {
    const RoomSize& size = sizes_[column.rooms[k]];
    const Interval found = within(size, width);
    const i64 low = most(found.low, size.length), high = found.high;
    const i64 typical = lattice_down(static_cast<f64>(size.typical) / static_cast<f64>(width));
    spans[k] = {low, least(most(typical, low), most(high, low)), high, false};
  }
  shared_out(depth, {spans, column.size}, parts);
}

}  // namespace homes
