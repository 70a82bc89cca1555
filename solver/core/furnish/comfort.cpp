#include "furnish/comfort.hpp"

#include "furnish/relations/at_side.hpp"

namespace furnish {

// Floor that is worth as much comes right behind its piece: of a required one it is weighed together with where the required pieces stand.
constexpr f64 WEIGHED = 1.0;
// Extent of no floor: a point within the piece itself.
constexpr i64 NOTHING_MM = 2;
constexpr f64 WEIGHT = 0.02;

namespace {

class Comforted {
 public:
  explicit Comforted(const RoomType& type, const WantedRows& wanted) : type_(type), wanted_(wanted) {
    moved_ = reserved<i32>(wanted.pieces.size);
  }

  // Adds the required pieces, then the floor at their sides: first what is weighed.
  void add_required() {
    List<Comfortable> added;
    visit(true, [&](const Comfortable& one, bool) { added.add(one); });
    for (const Comfortable& one : added) add_floors(one, true);
    for (const Comfortable& one : added) add_floors(one, false);
  }

  // Adds the optional pieces, each group with its weighed floor, then the rest of the floor at their sides.
  void add_optional() {
    List<Comfortable> added;
    i32 done = 0;
    const auto add_weighed = [&] {
      for (; done < added.size(); done++) add_floors(added[done], true);
    };
    visit(false, [&](const Comfortable& one, bool with_next) {
      added.add(one);
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

  // Adds the floor at the sides of a piece that is worth enough to be weighed, or all other.
  void add_floors(const Comfortable& of, bool weighed) {
    List<i32> kinds;
    for (const Candidate& way : part_of(wanted_.candidates, of.ways)) add_new(kinds, way.kind);
    List<Side> sides;
    for (i32 kind : kinds) {
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) add_new(sides, comfort.side);
    }
    for (Side side : sides) {
      const f64 cost = cost_of(kinds, side) / sides.size();
      if ((cost >= WEIGHED) != weighed) continue;
      const i32 before = candidates_.size();
      for (i32 kind : kinds) {
        for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
          if (comfort.side == side) add_strip(of.piece, kind, comfort);
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
        if (comfort.side == side) cost = most(cost, comfort.cost);
      }
    }
    return cost;
  }

  // Adds doing without the floor at a side of a piece that stands as that kind.
  void add_nothing(i32 piece, i32 kind, f64 cost) {
    Candidate& made = candidates_.add(free_candidate(-1, cost));
    made.parent = piece;
    made.parent_kind = kind;
    made.is_under = true;
    made.weight = WEIGHT;
    made.floor = {NOTHING_MM, NOTHING_MM};
  }

  // Adds the floor at a side of a piece that stands as that kind.
  void add_strip(i32 piece, i32 kind, const Comfort& comfort) {
    const Extent own = type_.kinds[kind].size();
    const bool beside = is_lateral(comfort.side);
    const Extent floor = beside ? Extent{comfort.depth, own.z - comfort.behind} : Extent{own.x, comfort.depth};
    const Rect box = at_side(own, floor, comfort.side, {0, 0}, beside ? Align::front : Align::centre);
    Candidate& made = candidates_.add(free_candidate(-1, 0.0));
    made.parent = piece;
    made.parent_kind = kind;
    made.across = {box.x0, box.x1};
    made.along = {box.z0, box.z1};
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
