#include "furnish/demanded.hpp"

namespace furnish {

// What leaving floor out costs, from which on it matters.
constexpr f64 MATTERS = 10.0;

namespace {

class Demanded {
 public:
  Demanded(const WantedRows& wanted, i32 piece) : wanted_(wanted), count_(wanted.pieces.size) {
    ways_ = reserved<Range>(count_), bonds_ = reserved<Range>(count_);
    owners_ = reserved<i32>(count_), moved_ = reserved<i32>(count_);
    necessary_ = reserved<bool>(count_);
    Range ways = {0, 0}, bonds = {0, 0};
    for (i32 k = 0; k < count_; k++) {
      const PieceRow& own = wanted.pieces[k];
      ways_[k] = ways = {ways.first + ways.count, own.candidates};
      bonds_[k] = bonds = {bonds.first + bonds.count, own.links};
      owners_[k] = owner_of(k);
      necessary_[k] = own.required != 0 || k == piece;
    }
    while (needs_more()) {}
  }

  WantedRows all() {
    add_pieces(true);
    add_pieces(false);
    for (PieceRow& row : pieces_) {
      const bool is_at_piece = row.floor_side >= 0 && row.floor_side < TURNING;
      if (is_at_piece) row.number = moved_[row.number];
    }
    for (Candidate& way : candidates_) {
      if (way.parent >= 0) way.parent = moved_[way.parent];
    }
    for (Link& link : links_) link.of = moved_[link.of];
    return {pieces_.all(), candidates_.all(), links_.all()};
  }

 private:
  Span<Candidate> ways_of(i32 piece) const { return part_of(wanted_.candidates, ways_[piece]); }

  // The piece whose floor it is, where that floor matters; else -1.
  i32 owner_of(i32 piece) const {
    const PieceRow& row = wanted_.pieces[piece];
    if (row.floor_side < 0 || row.skip_cost < MATTERS) return -1;
    i32 owner = -1;
    for (const Candidate& way : ways_of(piece)) {
      if (way.parent < 0) continue;
      if (owner >= 0 && way.parent != owner) return -1;
      owner = way.parent;
    }
    return owner;
  }

  // Marks what the necessary pieces need and stand together with alone; tells whether that is more than was marked before.
  bool needs_more() {
    bool more = false;
    const auto mark = [&](i32 piece) {
      more = more || !necessary_[piece];
      necessary_[piece] = true;
    };
    for (i32 k = count_ - 1; k >= 0; k--) {
      if (!necessary_[k]) continue;
      for (const Candidate& way : ways_of(k)) {
        if (way.parent >= 0) mark(way.parent);
      }
      for (const Link& link : part_of(wanted_.links, bonds_[k])) mark(link.of);
      if (wanted_.pieces[k].with_next && k + 1 < count_) mark(k + 1);
    }
    return more;
  }

  // Adds the pieces that are required, or those that are not, each with its floor that matters.
  void add_pieces(bool required) {
    for (i32 k = 0; k < count_; k++) {
      if (owners_[k] < 0 && necessary_[k] == required) add_with_floors(k);
    }
  }

  // Adds a piece and right behind it its floor that matters.
  void add_with_floors(i32 piece) {
    const bool required = necessary_[piece];
    List<i32> floors;
    for (i32 k = 0; k < count_; k++) {
      if (owners_[k] == piece) floors.add(k);
    }
    add(piece, required, wanted_.pieces[piece].with_next || (floors.size() > 0 && !required));
    for (i32 i = 0; i < floors.size(); i++) add(floors[i], required, !required && i + 1 < floors.size());
  }

  void add(i32 piece, bool required, bool with_next) {
    moved_[piece] = pieces_.size();
    PieceRow& row = pieces_.add(wanted_.pieces[piece]);
    row.required |= required;
    row.with_next = with_next;
    candidates_.add_all(ways_of(piece));
    links_.add_all(part_of(wanted_.links, bonds_[piece]));
  }

  const WantedRows& wanted_;
  i32 count_;
  Span<Range> ways_, bonds_;  // by piece, as the rest
  Span<i32> owners_;
  Span<i32> moved_;  // where it is now
  Span<bool> necessary_;
  List<PieceRow> pieces_;
  List<Candidate> candidates_;
  List<Link> links_;
};

}  // namespace

WantedRows demanded(const WantedRows& wanted, i32 piece) { return Demanded(wanted, piece).all(); }

}  // namespace furnish
