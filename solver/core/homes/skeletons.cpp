// How each skeleton's strips are dealt.
#include "homes/deal.hpp"

namespace homes {

namespace {

// An axial house's strip with the public rooms gives columns to the other while it is longer by so much.
constexpr i64 LONGER_MM = 3000;
// Of a ranch's public rooms at the street.
constexpr Interval STREET_DEPTHS = {3600, 5250};
// What a move adds to a strip's depth.
constexpr i64 STEPS[] = {-300, -150, 150, 300};

void begin(Draft& draft, Kind kind) {
  draft.kind = kind;
  draft.bend = Bend::none;
  draft.turn = 0;
  draft.entry = -1;
  draft.apart = false;
  draft.strips = draft.columns = 0;
  draft.blocks = {nullptr, 0};
}

struct Place {
  i32 strip, column;
};

Place picked_place(const Draft& draft, Stream& stream) {
  if (draft.columns < 1) fail(Failure::bad_request);
  i32 at = stream.below(draft.columns), strip = 0;
  while (at >= draft.count[strip]) at -= draft.count[strip++];
  return {strip, at};
}

Column& column_at(Draft& draft, Place place) { return draft.column[draft.first(place.strip) + place.column]; }

// Swaps the two strips of a draft.
void swap_strips(Draft& draft) {
  Column kept[MOST_ROOMS];
  const i32 first = draft.count[0], second = draft.count[1];
  for (i32 i = 0; i < first + second; i++) kept[i] = draft.column[i];
  for (i32 i = 0; i < second; i++) draft.column[i] = kept[first + i];
  for (i32 i = 0; i < first; i++) draft.column[second + i] = kept[i];
  swap(draft.count[0], draft.count[1]);
  swap(draft.depth[0], draft.depth[1]);
}

}  // namespace

void Dealer::full(Draft& draft) const {
  Deal deal;
  dealt(deal);
  const i64 north = depth(), south = deep(), depths[] = {north, south};
  Chunk strips[] = {{}, deal.front};
  if (garages_.size || stream_.chance(0.65)) {
    strips[1] = either(along_street(deal.front, deal.living));
  } else {
    strips[0] = either(deal.living);
  }
  fill(strips, depths, deal.apart);
  begin(draft, Kind::full);
  draft.add_strip(strips[0].all(), north);
  draft.add_strip(with_garages(strips[1]).all(), south);
}

void Dealer::axial(Draft& draft) const {
  Deal deal;
  chunks(true, {}, deal);
  const i64 west = depth(), east = depth(), depths[] = {west, east};
  Chunk strips[2];
  fill(strips, depths, deal.apart);
  const i32 side = stream_.below(2);
  Chunk &along = strips[side], &across = strips[1 - side];
  if (across.size && sleeps(across.columns[across.size - 1]) && !sleeps(across.columns[0])) across.reverse();
  along.add(stream_.chance(0.8) ? deal.living.reversed() : deal.living);
  for (i32 left = along.size; left > 0; left--) {
    if (length(along.all(), depths[side]) - length(across.all(), depths[1 - side]) < LONGER_MM) break;
    across.add(along.columns[0]);
    along = along.part(1, along.size);
  }
  begin(draft, Kind::axial);
  for (i32 k = 0; k < 2; k++) draft.add_strip(strips[k].all(), depths[k]);
  draft.entry = entries_.size ? entries_.rooms[0] : -1;
}

void Dealer::ranch(Draft& draft) const {
  Deal deal;
  chunks(true, {}, deal);
  const i64 north = depth(), south = depth(), street = garages_.size ? deep() : depth(STREET_DEPTHS);
  const i64 depths[] = {north + south + columns_.walls().hallway - street, street, north, south};
  Chunk strips[] = {{}, {}, {}, entry()};
  fill(strips + 2, depths + 2, deal.apart);
  if (entries_.size) {
    Chunk sorted;
    for (const Column& column : strips[3].all()) {
      if (entries_.has(column.rooms[0])) sorted.add(column);
    }
    for (const Column& column : strips[3].all()) {
      if (!entries_.has(column.rooms[0])) sorted.add(column);
    }
    strips[3] = sorted;
  }
  const Chunk behind = stream_.chance(0.8) ? deal.living.reversed() : deal.living;
  const i32 at = cut(behind, depths);
  strips[0] = behind.part(0, least(at, behind.size));
  strips[1] = with_garages(behind.part(least(at, behind.size), behind.size));
  begin(draft, Kind::ranch);
  for (i32 k = 0; k < 4; k++) draft.add_strip(strips[k].all(), depths[k]);
}

// Finds where to part the public rooms so that both rows are about as long.
i32 Dealer::cut(const Chunk& behind, const i64* depths) const {
  i32 best = 1;
  f64 least_uneven = INFINITE;
  for (i32 at = 1; at < most(2, behind.size); at++) {
    const Chunk street = with_garages(behind.part(least(at, behind.size), behind.size));
    const i64 apart = magnitude(length(behind.part(0, least(at, behind.size)).all(), depths[0]) - length(street.all(), depths[1]));
    const f64 uneven = static_cast<f64>(apart) * (0.8 + (1.2 - 0.8) * stream_.unit());
    if (uneven < least_uneven) {
      least_uneven = uneven;
      best = at;
    }
  }
  return best;
}

void Dealer::rows(Draft& draft) const {
  Deal deal;
  dealt(deal);
  const i64 north = depth(), south = deep(), depths[] = {north, south};
  const i32 at = stream_.below(deal.living.size + 1);
  Chunk street = deal.front;
  street.add(deal.living.part(0, at));
  Chunk strips[2];
  strips[1] = either(street);
  strips[0] = either(deal.living.part(at, deal.living.size));
  fill(strips, depths, deal.apart);
  begin(draft, Kind::rows);
  draft.add_strip(strips[0].all(), north);
  draft.add_strip(with_garages(strips[1]).all(), south);
}

void move(const Draft& draft, Stream& stream, Draft& moved) {
  draft.copy_to(moved);
  const i32 which = stream.below(draft.bend == Bend::none ? 10 : 12);
  if (which < 4) {
    const Place one = picked_place(moved, stream), other = picked_place(moved, stream);
    swap(column_at(moved, one), column_at(moved, other));
  } else if (which < 6) {
    const Place place = picked_place(moved, stream);
    if (moved.count[place.strip] < 2) return;
    const Column column = moved.take(place.strip, place.column);
    const i32 strip = stream.below(moved.strips);
    moved.insert(strip, stream.below(moved.count[strip] + 1), column);
  } else if (which == 6) {
    column_at(moved, picked_place(moved, stream)).turn();
  } else if (which == 7) {
    moved.turn_round(stream.below(moved.strips));
  } else if (which == 8 && moved.strips == 2) {
    swap_strips(moved);
  } else if (which >= 10) {
    moved.turn = stream.below(TURNS);
  } else {
    const i32 k = stream.below(moved.strips);
    moved.depth[k] += STEPS[stream.below(4)];
  }
}

}  // namespace homes
