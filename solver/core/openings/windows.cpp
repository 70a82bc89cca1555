// Windows in the outside walls, beside the doors placed so far.
#include "openings/doorways.hpp"

namespace openings {

namespace {

// Of a living space, and of a bathroom or laundry, below which a basin and a washer stand.
constexpr i64 PANE_MM = 1200, PANE_HIGH_MM = 1400, SMALL_PANE_MM = 600;
constexpr i64 WIDER_MM = 600, WIDEST_MM = 2400;  // by how much a pane is widened for daylight, and how far
constexpr i64 TWO_MM = 4200;                     // wall from which it may have two windows
// Most glass per floor with which a wall gets its second window; as much as daylight asks for (Musterbauordnung, 47).
constexpr f64 GLASS = 0.25, DAYLIGHT = 0.125;
constexpr i64 SHIFT_MM = 100;  // step in which a window gives way to a door

i64 length(const Stretch& stretch) { return stretch.over.high - stretch.over.low; }

// Whether a stretch is among those with two windows: long ones, the longest first, as far as the room's floor bears so much glass.
bool bears_two(const Rect& rect, Span<Stretch> stretches, i32 at) {
  i64 with_one = 0, before = 0;
  for (i32 i = 0; i < stretches.size; i++) {
    with_one += length(stretches[i]) >= PANE_MM + 2 * EDGE_MM;
    const i64 longer = length(stretches[i]) - length(stretches[at]);
    before += longer > 0 || (longer == 0 && i < at);
  }
  const f64 bearable = GLASS * static_cast<f64>(rect.width()) * static_cast<f64>(rect.depth()) / static_cast<f64>(PANE_MM * PANE_HIGH_MM);
  return length(stretches[at]) >= TWO_MM && before < whole(bearable) - with_one;
}

// The place nearest to the middle of a part of a stretch, NONE where there is none.
i64 place_in(const Doorways& doorways, i64 room, const Stretch& stretch, Interval part, i64 width) {
  const i64 first = most(part.low, stretch.over.low + EDGE_MM) + width / 2;
  const i64 last = least(part.high, stretch.over.high - EDGE_MM) - width / 2;
  const i64 middle = part.middle();
  const auto is_free = [&](i64 centre) {
    const bool inside = first <= centre && centre <= last;
    return inside && doorways.is_free(room, static_cast<Wall>(stretch.wall), centre - width / 2, centre + width / 2);
  };
  for (i64 shift = 0; shift <= most(last - middle, middle - first); shift += SHIFT_MM) {
    if (is_free(middle + shift)) return middle + shift;
    if (is_free(middle - shift)) return middle - shift;
  }
  return NONE;
}

i64 windows_in(const HouseRoom& kind, Span<Stretch> stretches, i32 at) {
  return kind.has(HABITABLE) && bears_two(kind.rect, stretches, at) ? 2 : 1;
}

// The least width with which the windows of a living space let daylight in.
i64 wished_width(const HouseRoom& kind, Span<Stretch> stretches) {
  if (!kind.has(HABITABLE)) return kind.has(SMALL_PANES) ? SMALL_PANE_MM : PANE_MM;
  i64 windows = 0;
  for (i32 i = 0; i < stretches.size; i++) {
    if (length(stretches[i]) >= PANE_MM + 2 * EDGE_MM) windows += windows_in(kind, stretches, i);
  }
  const i64 floor = kind.rect.width() * kind.rect.depth();
  i64 width = PANE_MM;
  while (width < WIDEST_MM && static_cast<f64>(windows * width * PANE_HIGH_MM) < DAYLIGHT * static_cast<f64>(floor)) width += WIDER_MM;
  return width;
}

void place_windows_in(Doorways& doorways, i64 room, i64& number) {
  const HouseRoom& kind = doorways.house.rooms[room];
  const Span<Stretch> stretches = doorways.house.outside(room);
  const i64 wished = wished_width(kind, stretches);
  for (i32 i = 0; i < stretches.size; i++) {
    const Stretch& stretch = stretches[i];
    const i64 parts = windows_in(kind, stretches, i);
    for (i64 k = 0; k < parts; k++) {
      const i64 low = stretch.over.low + floor_div(length(stretch) * k, parts);
      const i64 high = stretch.over.low + floor_div(length(stretch) * (k + 1), parts);
      for (i64 width = wished, centre = NONE; centre == NONE && width >= least(wished, PANE_MM); width -= WIDER_MM) {
        centre = place_in(doorways, room, stretch, {low, high}, width);
        if (centre != NONE) doorways.add({CutKind::window, ++number, room, stretch.wall, NONE, centre, width, NONE, 0});
      }
    }
  }
}

// Moves a door and places the room's windows; false, and nothing changed, where there is none.
bool makes_room(Doorways& doorways, const Cut& cut, const Cut& moved) {
  if (doorways.score(moved) > doorways.score(cut)) return false;
  const i32 before = doorways.cuts().size();
  doorways.replace(cut, moved);
  place_windows(doorways);
  if (doorways.cuts().size() > before) return true;
  doorways.replace(moved, cut);
  return false;
}

}  // namespace

void place_windows(Doorways& doorways) {
  i64 number = 0;
  for (const Cut& cut : doorways.cuts()) number += cut.kind == CutKind::window;
  for (i64 room = 0; room < doorways.house.rooms.size; room++) {
    const HouseRoom& kind = doorways.house.rooms[room];
    if (kind.has(WINDOWS) && !kind.has(OUTDOOR) && !doorways.has_window(room)) place_windows_in(doorways, room, number);
  }
}

void make_room_for_windows(Doorways& doorways) {
  for (i64 room = 0; room < doorways.house.rooms.size; room++) {
    const HouseRoom& kind = doorways.house.rooms[room];
    if (!kind.has(HABITABLE | WINDOWS) || kind.has(OUTDOOR)) continue;
    if (doorways.has_window(room)) continue;
    for (i32 i = 0; i < doorways.sides(room).size(); i++) {
      const Cut cut = doorways.sides(room)[i].cut;
      const Stretch* stretch = cut.other == NONE ? doorways.house.stretch_at(room, cut.wall, cut.centre) : nullptr;
      const auto try_at = [&](i64 centre) { return makes_room(doorways, cut, cut.at(centre)); };
      if (stretch != nullptr && any_place(doorways.house.header, cut.width, stretch->over, try_at)) break;
    }
  }
}

}  // namespace openings
