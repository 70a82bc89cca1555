#include "furnish/comfort.hpp"

#include "furnish/relations/at_side.hpp"

namespace furnish {

// What doing without a piece's comfort costs (measured: kept in nearly all pieces).
constexpr f64 COMFORT_COST = 0.6;
constexpr f64 WEIGHT = 0.02;

namespace {

class Comforted {
 public:
  explicit Comforted(const RoomType& type, const WantedRows& wanted) : type_(type), wanted_(wanted) {
    moved_ = reserved<i32>(wanted.pieces.size);
  }

  // Adds the pieces that are required, or not, then the floor at their sides.
  void add(bool required) {
    Range ways = {0, 0}, bonds = {0, 0};
    const i32 first = pieces_.size();
    List<Range> added;
    for (i32 k = 0; k < wanted_.pieces.size; k++) {
      const PieceRow& piece = wanted_.pieces[k];
      ways = {ways.first + ways.count, piece.candidates};
      bonds = {bonds.first + bonds.count, piece.links};
      if ((type_.pieces[piece.spec].required != 0) != required) continue;
      moved_[k] = pieces_.size();
      pieces_.add(piece);
      copy(ways, bonds);
      added.add(ways);
    }
    for (i32 k = 0; k < added.size(); k++) add_floors(first + k, part_of(wanted_.candidates, added[k]));
  }

  WantedRows all() const { return {pieces_.all(), candidates_.all(), links_.all()}; }

 private:
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

  void add_floors(i32 piece, Span<Candidate> ways) {
    List<i32> kinds;
    for (const Candidate& way : ways) add_new(kinds, way.kind);
    List<Side> sides;
    for (i32 kind : kinds) {
      for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) add_new(sides, comfort.side);
    }
    for (Side side : sides) {
      const i32 before = candidates_.size();
      for (i32 kind : kinds) {
        for (const Comfort& comfort : type_.comforts_of(type_.kinds[kind])) {
          if (comfort.side == side) add_strip(piece, kind, comfort);
        }
      }
      pieces_.add({pieces_[piece].spec, piece, -1, candidates_.size() - before, 0, static_cast<i32>(side), COMFORT_COST / sides.size()});
    }
  }

  // Adds the floor at a side of a piece that stands as that kind.
  void add_strip(i32 piece, i32 kind, const Comfort& comfort) {
    const Extent own = type_.kinds[kind].size();
    const Extent floor = is_lateral(comfort.side) ? Extent{comfort.depth, own.z} : Extent{own.x, comfort.depth};
    const Rect box = at_side(own, floor, comfort.side, {0, 0}, Align::centre);
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
  found.add(true);
  found.add(false);
  return found.all();
}

}  // namespace furnish
