#include "furnish/room_type.hpp"

namespace furnish {

// More than a room type may ask for.
constexpr i32 MOST_COPIES = 100;

template <class E> static bool is_one(E value, E last) { return static_cast<i32>(value) >= 0 && value <= last; }

static bool is_word(i32 word, const RoomType& type) { return word >= 0 && word < type.all_words; }

static void check_rule(const Rule& rule, const RoomType& type) {
  constexpr Word LAST_WORD = static_cast<Word>(static_cast<i32>(Word::COUNT) - 1);
  check(is_one(rule.word, LAST_WORD) && is_one(rule.align, Align::any) && is_one(rule.wall, Walls::other));
  for (const Name& name : type.of(rule)) check(is_word(name.word, type));
  for (Side side : part_of(type.sides, rule.sides)) check(is_one(side, Side::back));
  for (const SortCost& sort : part_of(type.sorts, rule.sorts)) check(is_one(sort.sort, Sort::across));
}

static void check_type(const RoomType& type) {
  for (const Kind& kind : type.kinds) {
    type.levels_of(kind);
    type.parts_of(kind);
    for (Side side : part_of(type.sides, kind.use)) check(is_one(side, Side::back));
    for (const Comfort& comfort : type.comforts_of(kind)) {
      check(is_one(comfort.side, Side::back) && comfort.half <= comfort.depth && comfort.across.low <= comfort.across.high);
      check(comfort.other >= -1 && comfort.other <= static_cast<i32>(Side::back));
      check(comfort.asked >= 0 && comfort.off >= 0 && comfort.off <= comfort.depth);
    }
  }
  for (const Variant& variant : type.variants) {
    type.kind(variant.kind);
    check(variant.corner >= -1 && variant.corner <= static_cast<i32>(Side::right));
  }
  for (const Rule& rule : type.rules) check_rule(rule, type);
  for (const PieceSpec& piece : type.pieces) {
    check(is_word(piece.word, type) && piece.count >= 0 && piece.count <= MOST_COPIES && piece.variants.count > 0);
    check(type.variants_of(piece)[0].corner < 0);
    type.rules_of(piece);
    for (Side side : part_of(type.sides, piece.approach)) check(is_one(side, Side::back));
  }
  for (const Range& order : type.orders) check(part_of(type.words, order).size <= MOST_IN_RUN);
  for (i32 word : type.words) check(is_word(word, type));
  for (i32 word : type.worktop) check(is_word(word, type));
  for (i32 word : type.landing) check(is_word(word, type));
  for (i32 word : type.ends) check(is_word(word, type));
  for (i32 word : type.triangle) check(is_word(word, type));
  for (const Leaving& leaving : type.leaves) check(is_word(leaving.word, type) && leaving.beside >= 0);
  check(!type.has_run || type.orders.size > 0);
}

RoomType read_room_type(u8* data, i64 size) {
  Reader reader(data, size);
  const TypeHeader header = reader.take<TypeHeader>(1)[0];
  RoomType type{};
  type.kinds = reader.take<Kind>(header.kinds);
  type.levels = reader.take<Level>(header.levels);
  type.parts = reader.take<PartBox>(header.parts);
  type.pieces = reader.take<PieceSpec>(header.pieces);
  type.variants = reader.take<Variant>(header.variants);
  type.rules = reader.take<Rule>(header.rules);
  type.names = reader.take<Name>(header.names);
  type.sorts = reader.take<SortCost>(header.sorts);
  type.sides = reader.take<Side>(header.sides);
  type.comforts = reader.take<Comfort>(header.comforts);
  type.orders = reader.take<Range>(header.orders);
  type.words = reader.take<i32>(header.words);
  type.worktop = reader.take<i32>(header.worktop);
  type.landing = reader.take<i32>(header.landing);
  type.ends = reader.take<i32>(header.ends);
  type.triangle = reader.take<i32>(header.triangle);
  type.leaves = reader.take<Leaving>(header.leaves);
  type.all_words = header.all_words;
  type.has_run = header.has_run != 0;
  type.turning = header.turning;
  check(type.turning >= 0);
  check(type.all_words >= 0 && type.all_words <= 1 << 16);
  check_type(type);
  return type;
}

}  // namespace furnish
