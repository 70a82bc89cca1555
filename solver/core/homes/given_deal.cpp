#include "homes/deal.hpp"

namespace homes {

namespace {

// Least extent across of a rectangle with a hallway along one side, and with rooms on both sides of the hallway.
constexpr i64 SIDED_MM = 3700;
constexpr i64 LINED_MM = 6500;
// Least length of a rectangle with public rooms at one end and a hallway at the other.
constexpr i64 SPLIT_MM = 9000;
// How often strips run along the longer side of a rectangle.
constexpr f64 ALONG = 0.8;

bool covers(const Rect& other, const Rect& rect) { return other.x0 <= rect.x0 && rect.x1 <= other.x1; }

bool is_at_street(const Block& block, Span<const Block> blocks) {
  for (const Block& other : blocks) {
    if (other.rect.z0 == block.rect.z1 && covers(other.rect, block.rect)) return false;
  }
  return true;
}

i32 rooms_in(const Draft& draft, i32 strip) {
  i32 rooms = 0;
  for (const Column& column : draft.in(strip)) rooms += column.size;
  return rooms;
}

// Gives every pair of strips without rooms a column of those that have most, one room of it where it has but one.
void fill_up(Draft& draft) {
  bool empty[MOST_STRIPS];
  for (i32 k = 0; k < draft.strips; k += 2) empty[k] = draft.is_empty(k) && draft.is_empty(k + 1);
  for (i32 k = 0; k < draft.strips; k += 2) {
    if (!empty[k]) continue;
    i32 full = 0, most_rooms = -1;
    for (i32 strip = 0; strip < draft.strips; strip++) {
      i32 rooms = 0;
      if (!draft.is_empty(strip)) rooms = rooms_in(draft, strip) + rooms_in(draft, strip ^ 1);
      if (rooms > most_rooms) {
        most_rooms = rooms;
        full = strip;
      }
    }
    Column column = draft.take(full, draft.count[full] - 1);
    if (column.size > 1 && draft.is_empty(full) && draft.is_empty(full ^ 1)) {
      Column rest = column;
      for (i32 i = 1; i < column.size; i++) rest.rooms[i - 1] = column.rooms[i];
      rest.size--;
      draft.insert(full, 0, rest);
      column = Column::of(column.rooms[0]);
    }
    draft.insert(k, draft.count[k], column);
  }
}

}  // namespace

// The strips while rooms are dealt to them: floor left, mm2; which lie at no hallway, and whether any does; those at the street.
struct GivenDealer::Strips {
  // The end of a strip at the street.
  struct End {
    i32 strip;
    bool at_end;
  };
  Draft* draft;
  f64 left[MOST_STRIPS];
  bool open[MOST_STRIPS];
  bool any_open = false;
  End street[2 * MOST_STRIPS];
  i32 ends = 0;
  i32 front[MOST_STRIPS];  // of a strip with a room at the street, whether that is its last (1) or first (0); -1 for the others
};

Block GivenDealer::block(const Rect& rect) const {
  const bool turned = (rect.depth() > rect.width()) == stream_.chance(ALONG);
  const i64 along = turned ? rect.depth() : rect.width(), across = turned ? rect.width() : rect.depth();
  Kind kinds[] = {Kind::rows, Kind::full, Kind::full, Kind::ranch, Kind::ranch};
  i32 count = 1;
  if (hallways_ && across >= SIDED_MM) count = across < LINED_MM ? 2 : along < SPLIT_MM ? 3 : 5;
  const Kind kind = kinds[stream_.below(count)];
  return {rect, kind, turned, stream_.chance(0.5)};
}

// Deals public rooms where there is no hallway, the others along hallways, the entry at the street.
void GivenDealer::deal(Draft& draft) const {
  const Span<const Rect> rects = stream_.pick(tilings_);
  const Span<Block> blocks = reserved<Block>(rects.size);
  for (i32 i = 0; i < rects.size; i++) blocks[i] = block(rects.data[i]);
  draft = {};
  draft.kind = Kind::given;
  draft.blocks = {blocks.data, blocks.size};
  for (const Block& block : blocks) {
    for (i32 k = 0; k < block.strips(); k++) draft.add_strip({nullptr, 0}, floor_div(block.across(), 2));
  }
  Strips strips;
  strips.draft = &draft;
  measure(draft.blocks, strips);
  find_street(draft.blocks, strips);
  for (const i32 room : garages_.all()) put_at_street(room, strips);
  for (const i32 room : entries_.all()) put_at_street(room, strips);
  for (i32 k = 0; k < draft.strips; k++) strips.front[k] = -1;
  for (i32 i = 0; i < strips.ends; i++) {
    const auto [strip, at_end] = strips.street[i];
    if (!draft.is_empty(strip)) strips.front[strip] = at_end;
  }
  Deal deal;
  chunks(true, {}, deal);
  lay(deal.living, strips.any_open, strips);
  sort(deal.apart.chunks());
  for (const Chunk& chunk : deal.apart.chunks()) lay(chunk, false, strips);
  fill_up(draft);
}

void GivenDealer::put_at_street(i32 room, Strips& strips) const {
  const auto [strip, at_end] = strips.street[stream_.below(strips.ends)];
  strips.draft->insert(strip, at_end ? strips.draft->count[strip] : 0, Column::of(room));
  strips.left[strip] -= static_cast<f64>(rooms_[room].size.typical);
}

// Finds the floor of every strip, and which lie at no hallway.
void GivenDealer::measure(Span<const Block> blocks, Strips& strips) const {
  i32 strip = 0;
  for (const Block& block : blocks) {
    const f64 length = static_cast<f64>(block.along() * 2) / block.strips();
    for (i32 pair = 0; pair < block.strips() / 2; pair++) {
      const bool is_public = block.kind == Kind::rows || (block.kind == Kind::ranch && pair == 0);
      const i64 deep = block.across() - (is_public ? 0 : columns_.walls().hallway);
      strips.open[strip] = strips.open[strip + 1] = is_public;
      strips.any_open = strips.any_open || is_public;
      const bool is_sided = deep < LINED_MM - columns_.walls().hallway;
      const f64 share = is_sided ? static_cast<f64>(stream_.below(2)) : 0.4 + (0.6 - 0.4) * stream_.unit();
      strips.left[strip++] = share * static_cast<f64>(deep) * length;
      strips.left[strip++] = (1 - share) * static_cast<f64>(deep) * length;
    }
  }
}

// Finds where a room lies at the street: in the southern strips, and at the southern ends of strips along z, of blocks that do.
void GivenDealer::find_street(Span<const Block> blocks, Strips& strips) const {
  i32 first = 0;
  for (const Block& block : blocks) {
    if (is_at_street(block, blocks)) {
      if (block.turned) {
        const i32 begin = block.mirrored ? first : first + block.strips() - 2;
        for (i32 k = begin; k < begin + 2; k++) strips.street[strips.ends++] = {k, !block.mirrored};
      } else {
        for (i32 k = first + 1; k < first + block.strips(); k += 2) {
          strips.street[strips.ends++] = {k, false};
          strips.street[strips.ends++] = {k, true};
        }
      }
    }
    first += block.strips();
  }
  if (!strips.ends) strips.street[strips.ends++] = {0, false};
}

// Lays columns in the strip with the most floor left (of those at no hallway, if asked for), and what does not go there in the next; never
// before who is at the street.
void GivenDealer::lay(const Chunk& chunk, bool in_open, Strips& strips) const {
  i32 at = 0;
  while (at < chunk.size) {
    const i32 strip = emptiest(in_open, strips);
    f64 floor = strips.left[strip];
    const i32 from = at;
    while (at < chunk.size) {
      const f64 area = static_cast<f64>(columns_.area(chunk.columns[at]));
      if (at > from && !(floor > 0.5 * area)) break;
      floor -= area;
      at++;
    }
    strips.left[strip] = floor;
    const bool at_end = strips.front[strip] >= 0 ? !strips.front[strip] : stream_.chance(0.5);
    i32 place = at_end ? strips.draft->count[strip] : 0;
    for (i32 i = from; i < at; i++) strips.draft->insert(strip, place++, chunk.columns[i]);
  }
}

// The strip with the most floor left, mostly; any where none that may be taken has some.
i32 GivenDealer::emptiest(bool in_open, const Strips& strips) const {
  const auto has_floor = [&](i32 k) { return strips.left[k] > 0 && (!in_open || strips.open[k]); };
  bool any = false;
  for (i32 k = 0; k < strips.draft->strips; k++) any = any || has_floor(k);
  i32 best = -1;
  f64 most_left = 0.0;
  for (i32 k = 0; k < strips.draft->strips; k++) {
    if (any && !has_floor(k)) continue;
    const f64 left = strips.left[k] * (0.7 + (1.3 - 0.7) * stream_.unit());
    if (best >= 0 && !(left > most_left)) continue;
    best = k;
    most_left = left;
  }
  return best;
}

}  // namespace homes
