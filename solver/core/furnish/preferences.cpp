#include "furnish/preferences.hpp"

namespace furnish {

// Most that a wall, a quarter, a side of another piece, a size variant may cost a piece by the seed alone.
constexpr f64 WALL_PREFERENCE = 1.6, QUARTER_PREFERENCE = 0.35, SIDE_PREFERENCE = 0.3, KIND_PREFERENCE = 0.5;

Preferences::Preferences(Stream& stream) {
  for (f64& cost : walls_) cost = stream.up_to(WALL_PREFERENCE);
  for (f64& cost : quarters_) cost = stream.up_to(QUARTER_PREFERENCE);
  for (f64& cost : sides_) cost = stream.up_to(SIDE_PREFERENCE);
  for (f64& cost : kinds_) cost = stream.up_to(KIND_PREFERENCE);
}

f64 Preferences::cost(const Subject& subject, const Candidate& candidate) const {
  f64 total = 0.0;
  for (i32 i = 0; subject.variants.size > 1 && i < least(KINDS, subject.variants.size); i++) {
    if (subject.variants[i].kind != candidate.kind) continue;
    total = kinds_[i];
    break;
  }
  if (candidate.parent >= 0) return total + (candidate.slot == Slot::side ? sides_[static_cast<i32>(candidate.slot_side)] : 0.0);
  if (candidate.wall != Wall::none) return total + walls_[static_cast<i32>(candidate.wall)];
  const Rect& clear = subject.scope.clear;
  const bool east = 2 * candidate.anchor.x > clear.x0 + clear.x1, south = 2 * candidate.anchor.z > clear.z0 + clear.z1;
  return total + quarters_[2 * south + east];
}

// Pieces that stay together, one behind the other, and neighbours whose units change places by the seed.
using Unit = List<i32>;
using Block = List<Unit>;

// Tells whether a piece cannot do without one of a unit.
static bool needs(const RoomType& type, const PieceSpec& piece, const Unit& unit) {
  for (const Rule& rule : type.rules_of(piece)) {
    if (!rule.required) continue;
    for (const Name& name : type.of(rule)) {
      for (i32 other : unit) {
        if (type.pieces[other].word == name.word) return true;
      }
    }
  }
  return false;
}

static void add_to(Block& block, const RoomType& type, i32 piece) {
  for (Unit& unit : block) {
    if (!needs(type, type.pieces[piece], unit)) continue;
    unit.add(piece);
    return;
  }
  Unit alone;
  alone.add(piece);
  block.add(alone);
}

// The pieces by importance, required ones first; neighbours with one `among` change places by the seed. A piece that only stands with
// another one of its neighbours stays behind it.
static List<i32> ordered(const RoomType& type, Stream& stream) {
  constexpr bool REQUIRED_FIRST[] = {true, false};
  List<Block> blocks;
  i32 last = -1;
  for (bool required : REQUIRED_FIRST) {
    for (i32 i = 0; i < type.pieces.size; i++) {
      if ((type.pieces[i].required != 0) != required) continue;
      const i32 among = required ? -1 : type.pieces[i].among;
      if (among < 0 || among != last || blocks.size() == 0) blocks.add({});
      last = among;
      add_to(blocks[blocks.size() - 1], type, i);
    }
  }
  List<i32> found;
  for (Block& block : blocks) {
    stream.shuffle(block.all());
    for (const Unit& unit : block) found.add_all(unit.all());
  }
  return found;
}

// How many of a piece a room of that area wants; always draws two numbers.
static i32 drawn_count(const PieceSpec& piece, f64 area, Stream& stream) {
  const f64 chance = stream.unit(), share = stream.unit();
  if (chance >= piece.chance || area < piece.min_area) return 0;
  i64 low = piece.count, high = piece.count;
  if (piece.has_per_area) {
    high = most<i64>(1, least<i64>(piece.count, whole(area / piece.per_area)));
    low = (high + 1) / 2;
  }
  return static_cast<i32>(low + whole(share * static_cast<f64>(high - low + 1)));
}

// The variants that suit a room of that area, but those for corners; all where none does.
static Span<Variant> suited(const RoomType& type, const PieceSpec& piece, f64 area) {
  List<Variant> all, found;
  for (const Variant& variant : type.variants_of(piece)) {
    if (variant.corner >= 0) continue;
    all.add(variant);
    if (variant.min_area <= area && area < variant.max_area) found.add(variant);
  }
  return found.size() > 0 ? found.all() : all.all();
}

List<CountedPiece> counted_pieces(const RoomType& type, f64 area, Stream& stream) {
  List<CountedPiece> found;
  for (i32 spec : ordered(type, stream)) {
    const PieceSpec& piece = type.pieces[spec];
    found.add({spec, drawn_count(piece, area, stream), suited(type, piece, area)});
  }
  return found;
}

}  // namespace furnish
