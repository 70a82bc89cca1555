#include "homes/search.hpp"

#include "homes/deal.hpp"
#include "homes/drawer.hpp"

namespace homes {

namespace {

// Deals of each try, and how often the best of them is changed; more often where an outline is given: nothing of it gives way, so rooms
// must be tried in more places.
constexpr i32 DEALS = 12;
constexpr i32 MOVES = 48;
constexpr i32 GIVEN_MOVES = 96;
// A home that costs no more than this, and this for every room, is taken at once: searching on makes all homes alike.
constexpr f64 GOOD = 1.2;
constexpr f64 GOOD_EACH = 0.2;
// Cost of a draft that cannot be drawn, and of each column without a width; 1 for every MISFIT_MM.
constexpr f64 MISFIT = 1000.0;
constexpr f64 MISFIT_COLUMN = 100.0;
constexpr f64 MISFIT_MM = 50.0;
// In a given outline a habitable room without an outside wall is as bad as one that cannot be entered.
constexpr Taste TASTE = {0.75, 1.9, 8.0};
constexpr Taste BENT_TASTE = {0.6, 2.4, 8.0};
constexpr Taste GIVEN_TASTE = {0.0, INFINITE, 30.0};

struct Seen {
  f64 cost = INFINITE;
  bool drawn = false;
  Draft draft;
  Sheet sheet;
  HomeVerdict verdict;
};

struct Request {
  Outline outline;
  WallSizes walls;
  f64 wished;
  Span<const PlannedRoom> rooms;
  Span<const RoomSize> sizes;
  Span<const SearchKind> kinds;
  Span<const Span<const Rect>> tilings;
};

bool is_size(const RoomSize& size) {
  constexpr i64 MOST_MM2 = 1'000'000'000'000, MOST_MM = 1'000'000;
  const bool has_area = size.least >= 0 && size.typical > 0 && size.most > 0 && most(size.least, most(size.typical, size.most)) <= MOST_MM2;
  return has_area && size.width >= 0 && size.length >= 0 && most(size.width, size.length) <= MOST_MM && size.aspect > 0;
}

Request read(Bytes sent) {
  Reader reader(sent.data, sent.size);
  const SearchHeader& header = reader.take<SearchHeader>(1)[0];
  const Span<PlannedRoom> rooms = reader.take<PlannedRoom>(header.rooms);
  const Span<SearchKind> kinds = reader.take<SearchKind>(header.kinds);
  if (rooms.size < 1 || rooms.size > MOST_ROOMS || kinds.size < 1 || header.outline < 0 || header.outline > 4) fail(Failure::bad_request);
  const Span<RoomSize> sizes = reserved<RoomSize>(rooms.size);
  for (i32 i = 0; i < rooms.size; i++) {
    sizes[i] = rooms[i].size;
    if (!is_size(sizes[i]) || rooms[i].owner >= rooms.size) fail(Failure::bad_request);
  }
  const Span<i32> counts = reader.take<i32>(header.tilings);
  const Span<Span<const Rect>> tilings = reserved<Span<const Rect>>(counts.size);
  for (i32 i = 0; i < counts.size; i++) {
    const Span<Rect> rects = reader.take<Rect>(counts[i]);
    if (rects.size < 1 || rects.size > rooms.size) fail(Failure::bad_request);
    tilings[i] = {rects.data, rects.size};
  }
  return {static_cast<Outline>(header.outline), header.walls, header.wished, {rooms.data, rooms.size}, {sizes.data, sizes.size},
          {kinds.data, kinds.size}, {tilings.data, tilings.size}};
}

class Search {
 public:
  explicit Search(const Request& request)
      : request_(request),
        columns_(request.sizes, request.walls),
        judge_(request.rooms, taste(request.outline), request.walls.door_wall),
        good_(GOOD + GOOD_EACH * request.rooms.size) {}

  // The cheapest home; of a rectangle drawn even where its strips do not come out, but where its extents are less than a hallway's width.
  const Seen& run() {
    Seen& best = best_of_all_;
    const SearchKind* kind_of_best = nullptr;
    for (const SearchKind& kind : request_.kinds) {
      search(kind);
      if (best_of_kind_.cost < best.cost) {
        best = best_of_kind_;
        kind_of_best = &kind;
      }
      if (best_of_kind_.drawn && !best_of_kind_.verdict.short_rooms && !best_of_kind_.verdict.unreached) break;
    }
    if (!best.drawn && kind_of_best != nullptr && request_.outline == Outline::rectangle) {
      best.drawn = Drawer(columns_, kind_of_best->frame, request_.wished).draw(best.draft, true, best.sheet).fits;
      if (best.drawn) best.verdict = judge_.verdict(best.sheet);
    }
    return best;
  }

 private:
  static Taste taste(Outline outline) {
    return outline == Outline::given ? GIVEN_TASTE : outline == Outline::rectangle ? TASTE : BENT_TASTE;
  }

  void search(const SearchKind& kind) {
    best_of_kind_.cost = INFINITE;
    for (const u64 state : kind.streams) {
      const arena::Scope scope;
      Stream stream(state);
      try_once(kind, stream);
      if (best_of_try_.cost < best_of_kind_.cost) best_of_kind_ = best_of_try_;
      if (best_of_kind_.cost <= good_) return;
    }
  }

  void try_once(const SearchKind& kind, Stream& stream) {
    if (request_.outline == Outline::rectangle) {
      const Dealer dealer(request_.rooms, columns_, stream);
      climb(Drawer(columns_, kind.frame, request_.wished), stream, [&](Draft& draft) { dealer.deal(static_cast<Kind>(kind.kind), draft); });
    } else if (request_.outline == Outline::given) {
      const GivenDealer dealer(request_.rooms, columns_, stream, request_.tilings);
      climb(GivenDrawer(columns_, request_.wished), stream, [&](Draft& draft) { dealer.deal(draft); });
    } else {
      const BentDealer dealer(request_.rooms, columns_, stream, request_.outline);
      const BentDrawer drawer(columns_, request_.wished, request_.outline, dealer.garages());
      climb(drawer, stream, [&](Draft& draft) { dealer.deal(static_cast<Kind>(kind.kind), draft); });
    }
  }

  // Takes the best of some deals, and changes it as long as that makes it no worse.
  template <class Draws, class Deals> void climb(const Draws& drawer, Stream& stream, Deals deal) {
    Seen &best = best_of_try_, &seen = seen_;
    best.cost = INFINITE;
    for (i32 i = 0; i < DEALS && !(best.cost <= good_); i++) {
      deal(seen.draft);
      drawer.choose_depths(seen.draft, stream);
      look(drawer, seen);
      if (seen.cost < best.cost) best = seen;
    }
    const i32 moves = request_.outline == Outline::given ? GIVEN_MOVES : MOVES;
    for (i32 i = 0; i < moves && !(best.cost <= good_); i++) {
      move(best.draft, stream, seen.draft);
      drawer.fit_depths(seen.draft);
      look(drawer, seen);
      if (seen.cost <= best.cost) best = seen;
    }
  }

  template <class Draws> void look(const Draws& drawer, Seen& seen) {
    const Misfit misfit = drawn(drawer, seen.draft, seen.sheet);
    seen.drawn = misfit.fits;
    if (misfit.fits) {
      seen.verdict = judge_.verdict(seen.sheet);
      seen.cost = seen.verdict.cost;
    } else {
      seen.cost = MISFIT + MISFIT_COLUMN * static_cast<f64>(misfit.columns) + static_cast<f64>(misfit.gap) / MISFIT_MM;
    }
  }

  static Misfit drawn(const Drawer& drawer, const Draft& draft, Sheet& sheet) { return drawer.draw(draft, false, sheet); }
  static Misfit drawn(const BentDrawer& drawer, const Draft& draft, Sheet& sheet) { return drawer.draw(draft, sheet); }
  static Misfit drawn(const GivenDrawer& drawer, const Draft& draft, Sheet& sheet) { return drawer.draw(draft, sheet); }

  const Request& request_;
  Columns columns_;
  Judge judge_;
  f64 good_;
  Seen best_of_all_, best_of_kind_, best_of_try_, seen_;
};

}  // namespace

Bytes search(Bytes sent) {
  const Request request = read(sent);
  Search search(request);
  const Seen& best = search.run();
  const Sheet& sheet = best.sheet;
  FoundHome found = {};
  if (best.drawn) found = {1, static_cast<i64>(best.draft.kind), sheet.width, sheet.depth, best.verdict};
  Writer writer(static_cast<i64>(sizeof(FoundHome) + sizeof(sheet.boxes)));
  writer.put(Span<FoundHome>{&found, 1});
  if (best.drawn) writer.put(sheet.all());
  return writer.written();
}

}  // namespace homes
