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
// Added to the side of floor that fronts open over.
constexpr i32 OPENED = 4;

namespace {

class Comforted {
 public:
  explicit Comforted(const RoomType& type, const WantedRows& wanted) : type_(type), wanted_(wanted) {
    moved_ = reserved<i32>(wanted.pieces.size);
  }

  // Adds the required pieces, then the floor at their sides: first what their fronts open over, then what is weighed.
  void add_required() {
    List<Comfortable> added;
    visit(true, [&](const Comfortable& one, bool) { added.add(one); });
    for (const Comfortable& one : added) add_opened(one);
    for (const Comfortable& one : added) add_floors(one, true);
    for (const Comfortable& one : added) add_floors(one, false);
  }

  // Adds the optional pieces, each with what its fronts open over, each group with its weighed floor, then the rest of the floor at their
  // sides.
  void add_optional() {
    List<Comfortable> added;
    i32 done = 0;
    const auto add_weighed = [&] {
      for (; done < added.size(); done++) add_floors(added[done], true);
    };
    visit(false, [&](const Comfortable& one, bool with_next) {
      added.add(one);
      add_opened(one);
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

  // Adds the floor that the fronts of a piece open over: an optional one stands with it or not at all. Not in rooms with a run: round a
  // corner it hides some of its own fronts, and what stands about it is as varied as the room only without.
  void add_opened(const Comfortable& of) {
    const Span<Candidate> ways = part_of(wanted_.candidates, of.ways);
    const i32 before = candidates_.size();
    const bool required = pieces_[of.piece].required;
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
        add_strip(of.piece, kind, comfort, comfort.depth, 0.0);
        if (comfort.half < comfort.depth) add_strip(of.piece, kind, comfort, comfort.half, comfort.cost);
      }
      opened += opens;
      if (opens && !required) continue;
      Candidate& without = add_nothing(of.piece, kind, opens ? BLOCKED : 0.0);
      without.bottom = NOWHERE_MM;
    }
    if (opened == 0 || ways[0].is_on || type_.has_run) {
      candidates_.cut(before);
      return;
    }
    PieceRow& own = pieces_[of.piece];
    pieces_.add({own.spec, of.piece, -1, candidates_.size() - before, 0, OPENED + static_cast<i32>(side), required, own.with_next, cost});
    if (!required) pieces_[of.piece].with_next = true;
  }

  // Adds the floor at the sides of a piece that is worth enough to be weighed, or all other.
  void add_floors(const Comfortable& of, bool weighed) {
    const List<i32> kinds = kinds_of(of);
    List<Side> sides;
    for (i32 kind : kinds) {
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
        if (!comfort.opens) add_new(sides, comfort.side);
      }
    }
    for (Side side : sides) {
      const f64 cost = cost_of(kinds, side) / sides.size();
      if ((cost >= WEIGHED) != weighed) continue;
      const i32 before = candidates_.size();
      for (i32 kind : kinds) {
        for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
          if (comfort.side == side && !comfort.opens) add_strip(of.piece, kind, comfort, comfort.depth, 0.0);
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
        if (comfort.side == side && !comfort.opens) cost = most(cost, comfort.cost);
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
  void add_strip(i32 piece, i32 kind, const Comfort& comfort, i64 depth, f64 cost) {
    const Extent own = type_.kinds[kind].size();
    const bool beside = is_lateral(comfort.side);
    const i64 width = comfort.opens ? comfort.across.high - comfort.across.low : own.x;
    const Extent floor = beside ? Extent{depth, own.z - comfort.behind} : Extent{width, depth};
    const Rect box = at_side(own, floor, comfort.side, {0, 0}, beside ? Align::front : Align::centre);
    const i64 aside = comfort.opens ? comfort.across.middle() : 0;
    Candidate& made = candidates_.add(free_candidate(-1, cost));
    made.parent = piece;
    made.parent_kind = kind;
    made.across = {box.x0 + aside, box.x1 + aside};
    made.along = {box.z0, box.z1};
    made.bottom = comfort.bottom;
    made.weight = WEIGHT;
    made.floor = floor;
  }

  template <class T> static void add_new(List<T>& values, T value) {
    for (T one : values) {
      if (one == value) return;
    }
    values.add(value);
  }

  const RoomType& type_;
  const WantedRows& wanted_;
  Span<i32> moved_;  // by piece: where it is now
  List<PieceRow> pieces_;
  List<Candidate> candidates_;
  List<Link> links_;
};

}  // namespace

WantedRows with_comfort(const RoomType& type, const WantedRows& wanted) {
  Comforted found(type, wanted);
  found.add_required();
  found.add_optional();
  return found.all();
}

}  // namespace furnish
