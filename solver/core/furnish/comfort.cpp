#include "furnish/comfort.hpp"

#include "furnish/relations/at_side.hpp"

namespace furnish {

// Floor that is worth as much comes right behind its piece: of a required one it is weighed together with where the required pieces stand.
constexpr f64 WEIGHED = 1.0;
// Extent of no floor.
constexpr i64 NOTHING_MM = 2;
constexpr f64 WEIGHT = 0.02;
// What it costs a required piece that its fronts do not open half of their way.
constexpr f64 BLOCKED = 12.0;
// What doing without floor costs that a standard asks for, at a side, before a door and to turn in: more than any piece that is not
// required.
constexpr f64 UNMET = 40.0, NO_APPROACH = 250.0, NO_TURNING = 250.0;

namespace {

class Comforted {
 public:
  Comforted(const Scope& scope, const RoomType& type, const WantedRows& wanted, f64 share)
      : scope_(scope), type_(type), wanted_(wanted), share_(share) {
    moved_ = reserved<i32>(wanted.pieces.size);
    candidates_.reserve(2 * wanted.candidates.size);
  }

  // Adds the pieces, each with what its fronts open over.
  void add_with_fronts() {
    visit(true, [&](const Comfortable& one, bool) { add_opened(one, !pieces_[one.piece].required); });
  }

  // Adds the required pieces, then the floor at their sides: first what their fronts open over, then what is weighed.
  void add_required() {
    List<Comfortable> added;
    visit(true, [&](const Comfortable& one, bool) { added.add(one); });
    for (const Comfortable& one : added) {
      if (is_in_run(pieces_[one.piece])) run_.add(one);
      else add_opened(one, false);
    }
    for (const Comfortable& one : added) add_asked(one);
    add_turning();
    add_approaches();
    for (const Comfortable& one : added) add_floors(one, true);
    for (const Comfortable& one : added) add_floors(one, false);
  }

  // Adds the optional pieces, each with what its fronts open over, each group with its weighed floor, then the rest of the floor at their
  // sides. What the fronts of a run's worktop and its required pieces open over comes when the run is whole: worktop stands without, too.
  void add_optional() {
    List<Comfortable> added;
    i32 done = 0;
    const auto add_weighed = [&] {
      for (; done < added.size(); done++) {
        add_asked(added[done]);
        add_floors(added[done], true);
      }
    };
    i32 coming = 0;
    for (const PieceRow& piece : wanted_.pieces) coming += is_in_run(piece) && !type_.pieces[piece.spec].required;
    if (coming == 0) add_opened_of_run();
    visit(false, [&](const Comfortable& one, bool with_next) {
      added.add(one);
      const bool in_run = is_in_run(pieces_[one.piece]);
      if (in_run && has(type_.worktop, type_.pieces[pieces_[one.piece].spec].word)) run_.add(one);
      else add_opened(one, false);
      if (in_run && --coming == 0) add_opened_of_run();
      if (!with_next) add_weighed();
    });
    add_weighed();
    for (const Comfortable& one : added) add_floors(one, false);
  }

  WantedRows all() const { return {pieces_.all(), candidates_.all(), links_.all()}; }

 private:
  // A piece that was added, and its candidates in the wanted rows.
  struct Comfortable {
    i32 piece;
    Range ways;
  };

  // Adds the pieces that are required, or not; tells `added` of each, and whether it stands only with the next one.
  template <class Added> void visit(bool required, Added added) {
    Range ways = {0, 0}, bonds = {0, 0};
    for (i32 k = 0; k < wanted_.pieces.size; k++) {
      const PieceRow& piece = wanted_.pieces[k];
      const PieceSpec& spec = type_.pieces[piece.spec];
      ways = {ways.first + ways.count, piece.candidates};
      bonds = {bonds.first + bonds.count, piece.links};
      if ((spec.required != 0) != required) continue;
      moved_[k] = pieces_.size();
      pieces_.add(piece);
      copy(ways, bonds);
      added(Comfortable{moved_[k], ways}, spec.with_next != 0);
    }
  }

  void copy(Range ways, Range bonds) {
    for (const Candidate& way : part_of(wanted_.candidates, ways)) {
      Candidate& own = candidates_.add(way);
      if (own.parent >= 0) own.parent = moved_[own.parent];
    }
    for (const Link& bond : part_of(wanted_.links, bonds)) {
      Link& own = links_.add(bond);
      own.of = moved_[own.of];
    }
  }

  List<i32> kinds_of(const Comfortable& of) const {
    List<i32> kinds;
    for (const Candidate& way : part_of(wanted_.candidates, of.ways)) add_new(kinds, way.kind);
    return kinds;
  }

  bool is_in_run(const PieceRow& piece) const { return has(type_.words, type_.pieces[piece.spec].word); }

  // Adds the floor that the fronts of a run open over, where there is any: its pieces stand without, too.
  void add_opened_of_run() {
    for (const Comfortable& one : run_) add_opened(one, true);
  }

  // Adds the floor that the fronts of a piece open over: an optional one stands with it or not at all, but `in_run`.
  void add_opened(const Comfortable& of, bool in_run) {
    const Span<Candidate> ways = part_of(wanted_.candidates, of.ways);
    const i32 before = candidates_.size();
    const bool required = pieces_[of.piece].required && !in_run;
    Side side = Side::front;
    i32 opened = 0;
    f64 cost = 0.0;
    for (i32 kind : kinds_of(of)) {
      bool opens = false;
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
        if (!comfort.opens) continue;
        opens = true;
        side = comfort.side;
        cost = most(cost, comfort.cost);
        add_strip(of.piece, kind, comfort, comfort.side, comfort.depth, 0.0);
        if (comfort.half < comfort.depth) add_strip(of.piece, kind, comfort, comfort.side, comfort.half, comfort.cost * share_);
      }
      opened += opens;
      if (opens && !required) continue;
      Candidate& without = add_nothing(of.piece, kind, opens ? BLOCKED * share_ : 0.0);
      without.bottom = NOWHERE_MM;
    }
    if (opened == 0 || ways[0].is_on) {
      candidates_.cut(before);
      return;
    }
    PieceRow& own = pieces_[of.piece];
    const i32 ways_opened = candidates_.size() - before;
    const f64 skipped = in_run ? BLOCKED * share_ : cost;
    pieces_.add({own.spec, of.piece, -1, ways_opened, 0, OPENED + static_cast<i32>(side), required, own.with_next, skipped});
    if (!required && !in_run) pieces_[of.piece].with_next = true;
  }

  static bool is_wished(const Comfort& comfort) { return !comfort.opens && comfort.asked == 0; }

  // Adds the strips of floor about a piece that a standard asks for.
  void add_asked(const Comfortable& of) {
    const List<i32> kinds = kinds_of(of);
    i32 last = 0;
    for (i32 kind : kinds) {
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) last = most(last, comfort.asked);
    }
    for (i32 number = 1; number <= last; number++) add_asked(of, kinds, number);
  }

  void add_asked(const Comfortable& of, const List<i32>& kinds, i32 number) {
    const i32 before = candidates_.size();
    const bool required = pieces_[of.piece].required;
    Side side = Side::front;
    for (i32 kind : kinds) {
      bool asks = false;
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
        if (comfort.asked != number) continue;
        asks = true;
        side = comfort.side;
        add_strip(of.piece, kind, comfort, side, comfort.depth, 0.0);
        if (comfort.other >= 0) add_strip(of.piece, kind, comfort, static_cast<Side>(comfort.other), comfort.depth, 0.0);
      }
      if (required || !asks) add_nothing(of.piece, kind, asks ? UNMET : 0.0).bottom = NOWHERE_MM;
    }
    const i32 ways = candidates_.size() - before;
    pieces_.add({pieces_[of.piece].spec, of.piece, -1, ways, 0, ASKED + static_cast<i32>(side), required, 0, UNMET});
  }

  // Adds the square that stays empty for a person to turn in.
  void add_turning() {
    const Rect& clear = scope_.clear;
    const i64 side = type_.turning;
    if (side == 0 || wanted_.pieces.size == 0 || least(clear.x1 - clear.x0, clear.z1 - clear.z0) < side) return;
    add_free(clear, {side, side}, 0, TURNING, NO_TURNING);
  }

  // Adds the floor before doors that a standard asks for.
  void add_approaches() {
    for (i32 k = 0; k < scope_.approaches.size && wanted_.pieces.size > 0; k++) {
      const Rect& floor = scope_.approaches[k];
      add_free(floor, {floor.width(), floor.depth()}, k, APPROACH, NO_APPROACH);
    }
  }

  // Adds floor of an extent within a rectangle of the room, which stays empty or costs so much.
  void add_free(const Rect& within, Extent extent, i32 number, i32 floor_side, f64 cost) {
    Candidate& floor = candidates_.add(free_candidate(-1, 0.0));
    floor.anchor = {(within.x0 + within.x1) / 2, (within.z0 + within.z1) / 2};
    floor.weight = WEIGHT;
    floor.floor = extent;
    floor.within = within;
    Candidate& without = candidates_.add(free_candidate(-1, cost));
    without.anchor = floor.anchor;
    without.bottom = NOWHERE_MM;
    without.weight = WEIGHT;
    without.floor = {NOTHING_MM, NOTHING_MM};
    pieces_.add({wanted_.pieces[0].spec, number, -1, 2, 0, floor_side, 1, 0, cost});
  }

  // Adds the floor at the sides of a piece that is worth enough to be weighed, or all other.
  void add_floors(const Comfortable& of, bool weighed) {
    const List<i32> kinds = kinds_of(of);
    List<Side> sides;
    for (i32 kind : kinds) {
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
        if (is_wished(comfort)) add_new(sides, comfort.side);
      }
    }
    for (Side side : sides) {
      const f64 cost = cost_of(kinds, side) / sides.size();
      if ((cost >= WEIGHED) != weighed) continue;
      const i32 before = candidates_.size();
      for (i32 kind : kinds) {
        for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
          if (comfort.side == side && is_wished(comfort)) add_strip(of.piece, kind, comfort, side, comfort.depth, 0.0);
        }
      }
      const bool required = pieces_[of.piece].required && cost >= WEIGHED;
      for (i32 k = 0; required && k < kinds.size(); k++) add_nothing(of.piece, kinds[k], cost);
      const i32 ways = candidates_.size() - before;
      pieces_.add({pieces_[of.piece].spec, of.piece, -1, ways, 0, static_cast<i32>(side), required, 0, cost});
    }
  }

  // What doing without the floor at a side costs.
  f64 cost_of(const List<i32>& kinds, Side side) const {
    f64 cost = 0.0;
    for (i32 kind : kinds) {
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
        if (comfort.side == side && is_wished(comfort)) cost = most(cost, comfort.cost);
      }
    }
    return cost;
  }

  // Adds doing without the floor at a side of a piece that stands as that kind.
  Candidate& add_nothing(i32 piece, i32 kind, f64 cost) {
    Candidate& made = candidates_.add(free_candidate(-1, cost));
    made.parent = piece;
    made.parent_kind = kind;
    made.is_under = true;
    made.weight = WEIGHT;
    made.floor = {NOTHING_MM, NOTHING_MM};
    return made;
  }

  // Adds floor so deep at a side of a piece that stands as that kind.
  void add_strip(i32 piece, i32 kind, const Comfort& comfort, Side side, i64 depth, f64 cost) {
    const Extent own = type_.kinds[kind].size();
    const bool beside = is_lateral(side);
    const i64 part = comfort.across.high - comfort.across.low;
    const i64 width = part > 0 ? part : own.x;
    const Extent floor = beside ? Extent{depth - comfort.off, own.z - comfort.behind} : Extent{width, depth - comfort.off};
    const Rect box = at_side(own, floor, side, {comfort.off, comfort.off}, beside ? Align::front : Align::centre);
    const i64 aside = part > 0 ? comfort.across.middle() : 0;
    Candidate& made = candidates_.add(free_candidate(-1, cost));
    made.parent = piece;
    made.parent_kind = kind;
    made.across = {box.x0 + aside, box.x1 + aside};
    made.along = {box.z0, box.z1};
    made.bottom = comfort.bottom;
    made.weight = WEIGHT;
    made.floor = floor;
    if (comfort.opens == ALONG_SIDE) made.within = opened_within(scope_, type_.kinds[kind].height);
  }

  const Scope& scope_;
  const RoomType& type_;
  const WantedRows& wanted_;
  f64 share_;  // of what it costs that fronts do not open
  Span<i32> moved_;  // by piece: where it is now
  List<PieceRow> pieces_;
  List<Comfortable> run_;  // the pieces of the run, so far
  List<Candidate> candidates_;
  List<Link> links_;
};

}  // namespace

WantedRows with_comfort(const Scope& scope, const RoomType& type, const WantedRows& wanted) {
  Comforted found(scope, type, wanted, 1.0);
  found.add_required();
  found.add_optional();
  return found.all();
}

WantedRows with_fronts(const Scope& scope, const RoomType& type, const WantedRows& wanted, f64 share) {
  Comforted found(scope, type, wanted, share);
  found.add_with_fronts();
  return found.all();
}

}  // namespace furnish
