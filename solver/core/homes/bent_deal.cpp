#include "homes/deal.hpp"

namespace homes {

namespace {

// How wings lie in an outline, drawn from these. A strip that juts out as a whole makes a deep court, so it is drawn often.
constexpr Bend IN_L[] = {Bend::north_out, Bend::north_out, Bend::south_out, Bend::free};
constexpr Bend IN_T[] = {Bend::free};
constexpr Bend IN_U[] = {Bend::north_out, Bend::north_out, Bend::south_out, Bend::south_out, Bend::free};
// How often public rooms lie in one row where they could lie in two.
constexpr f64 SINGLE = 0.5;
// How often private rooms are shared out among wings; the most even is taken. More makes homes alike.
constexpr i32 SHARINGS = 16;
// A wing with rooms on one side alone counts as so much floor uneven: its hallway serves half as many.
constexpr i64 BARE_MM2 = 10'000'000;
// How often the kitchen of a home with two wings begins one of them, beside the dining room: between two wings all would walk through it.
constexpr f64 IN_WING = 0.75;
constexpr i32 MOST_SHARED = 4;

}  // namespace

void BentDealer::deal(Kind kind, Draft& draft) const {
  if (kind == Kind::rows) {
    rows(draft);
    draft.bend = Bend::free;
  } else {
    wings(kind == Kind::winged ? 2 : 1, draft);
  }
  draft.turn = stream_.below(TURNS);
}

void BentDealer::wings(i32 wings, Draft& draft) const {
  const Span<const Bend> bends = outline_ == Outline::l   ? Span<const Bend>{IN_L, 4}
                                 : outline_ == Outline::t ? Span<const Bend>{IN_T, 1}
                                                          : Span<const Bend>{IN_U, 5};
  const Bend bend = stream_.pick(bends);
  const bool in_wing = wings > 1 && stream_.chance(IN_WING), single = bend != Bend::free || stream_.chance(SINGLE);
  Deal deal;
  if (single && !in_wing) {
    in_deep_row(deal);
  } else {
    chunks(true, {}, deal);
  }
  i64 depths[2 + MOST_SHARED];
  for (i32 k = 0; k < 2 + 2 * wings; k++) depths[k] = k == 1 ? deep() : depth();
  Chunk strips[2 + MOST_SHARED];
  strips[3] = entry();
  const i32 with_kitchen = in_wing ? kitchen_to_wing(deal.living, bend, strips) : -1;
  share(deal.apart, 2 * wings, strips + 2);
  const bool from_west = with_kitchen < 0 ? !stream_.chance(0.8) : with_kitchen < 4;
  const Chunk behind = from_west ? deal.living : deal.living.reversed();
  const i32 at = single || behind.size < 2 ? 0 : cut(behind, depths);
  strips[0] = behind.part(0, at);
  if (wings == 1) {
    for (const i32 room : garages_.all()) strips[1].add(Column::of(room));
  }
  strips[1].add(behind.part(at, behind.size));
  draft.kind = wings == 1 ? Kind::ranch : Kind::winged;
  draft.bend = bend;
  draft.entry = -1;
  draft.apart = wings > 1 && garages_.size;
  draft.strips = draft.columns = 0;
  for (i32 k = 0; k < 2 + 2 * wings; k++) draft.add_strip(strips[k].all(), depths[k]);
}

// Moves the kitchen, and what is small beside it, to the near end of a strip that lies at the public rooms; says which, -1 where there is
// no kitchen or nothing else to live in.
i32 BentDealer::kitchen_to_wing(Chunk& living, Bend bend, Chunk* strips) const {
  Chunk kitchen, beside, rest;
  for (const Column& column : living.all()) {
    const PlannedRoom& room = rooms_[column.rooms[0]];
    (room.small() ? beside : room.has(WET) ? kitchen : rest).add(column);
  }
  if (!kitchen.size || !rest.size) return -1;
  const i32 side = bend == Bend::free ? stream_.below(2) : bend == Bend::north_out ? 1 : 0;
  const i32 strip = 2 + 2 * stream_.below(2) + side;
  kitchen.add(beside);
  kitchen.add(strips[strip]);
  strips[strip] = kitchen;
  living = rest;
  return strip;
}

// Deals public and private rooms where the public ones lie in one deep row: what is small lies behind the kitchen.
void BentDealer::in_deep_row(Deal& deal) const {
  if (!small_.size || !stream_.chance(AT_KITCHEN)) return chunks(false, {}, deal);
  RoomList dry;
  for (const i32 room : small_.all()) {
    if (!is_bath(room)) dry.add(room);
  }
  const i32 behind = stream_.pick((dry.size ? dry : small_).all());
  RoomList without;
  without.add(behind);
  chunks(false, without, deal);
  i32 kitchen = -1;
  for (i32 k = 0; k < deal.living.size; k++) {
    if (is_wet(deal.living.columns[k])) kitchen = k;
  }
  if (kitchen < 0) {
    deal.apart.add().add(Column::of(behind));
    return;
  }
  Column& column = deal.living.columns[kitchen];
  const i32 room = column.rooms[0];
  column = stream_.chance(0.5) ? Column::of(behind, room) : Column::of(room, behind);
}

// Shares private rooms out among the strips of wings, so that the two strips of each are about as long; what they begin with stays first.
void BentDealer::share(ChunkList& chunks, i32 count, Chunk* strips) const {
  i32 best[MOST_ROOMS], dealt[MOST_ROOMS];
  i64 least_uneven = -1;
  for (i32 i = 0; i < SHARINGS; i++) {
    i64 floors[MOST_SHARED] = {}, uneven = 0;
    for (i32 k = 0; k < count; k++) floors[k] = floor_of(strips[k].all());
    for (i32 c = 0; c < chunks.size; c++) {
      dealt[c] = stream_.below(count);
      floors[dealt[c]] += floor_of(chunks.all[c].all());
    }
    for (i32 k = 0; k < count; k += 2) {
      uneven += magnitude(floors[k] - floors[k + 1]) + (floors[k] && floors[k + 1] ? 0 : BARE_MM2);
    }
    if (least_uneven >= 0 && uneven >= least_uneven) continue;
    least_uneven = uneven;
    for (i32 c = 0; c < chunks.size; c++) best[c] = dealt[c];
  }
  Chunk behind[MOST_SHARED];
  for (i32 c = 0; c < chunks.size; c++) {
    Chunk& strip = behind[best[c]];
    if (stream_.chance(0.5)) {
      strip.add(chunks.all[c]);
    } else {
      Chunk whole = chunks.all[c];
      whole.add(strip);
      strip = whole;
    }
  }
  for (i32 k = 0; k < count; k++) strips[k].add(behind[k]);
}

}  // namespace homes
