// The pieces of a list in its order, each with its ways when those before it are known.
#include "furnish/listed.hpp"

#include "furnish/comfort.hpp"
#include "furnish/relations/around.hpp"

namespace furnish {

// Pulls, m^-2, to a piece that a relation names, or into line with it.
constexpr f64 NEAR_PULL = 0.2, ALIGN_PULL = 0.5;
// A piece is pushed away until it is that much farther than asked, m, at that share of the relation's cost.
constexpr f64 PUSHED_BEYOND = 1.0, PUSHED_SHARE = 0.25;
constexpr i32 MOST_RELATIONS = 64;
// The share of what it costs in a room of a type that fronts do not open: of several together it is less than of a relation.
constexpr f64 OF_FRONTS = 1.0 / 24;

namespace {

// Behind a room's own rows; the rows of what stands and of the list follow, and where all of these are, if that is told.
struct ListHeader {
  i32 standing, listed, told;
  i32 all;     // of the ways, as nearly as can be
  i32 fronts;  // whether the floor follows that fronts open over
  i32 unused;
};

// Where the centre of a footprint may be within a rectangle.
Rect centres_in(const Rect& at, Extent extent) {
  const i64 half_x = floor_div(extent.x, 2), half_z = floor_div(extent.z, 2);
  return {at.x0 + half_x, at.z0 + half_z, at.x1 - half_x, at.z1 - half_z};
}


class Lister {
 public:
  Lister(const Scope& scope, const RoomType& type, const ListHeader& header, Span<ListedRow> rows, Span<StandsRow> others)
      : in_{scope, type, header.all ? NEARLY_ALL : FEW, rows, {}}, others_(others), with_fronts_(header.fronts != 0) {
    for (i32 i = 0; i < header.standing; i++) {
      const ListedRow& row = rows[i];
      in_.ways.add({}).add({row.stance, centres_in(row.at, {row.at.width(), row.at.depth()})});
      candidates_.add(free_candidate(row.kind, 0.0)).stance = stance_number(row.stance.rotation, row.stance.wall);
      pieces_.add({i, 0, row.kind, 1, 0, -1, 1, 0, GONE});
    }
  }

  // Adds the next piece of the list; false where there are too many ways in all.
  bool add() {
    Seeker seeker = seeking(in_.ways.size());
    const List<Foothold> whole = footholds(seeker);
    const List<Candidate> found = ways_of(seeker, whole);
    count_ += found.size();
    if (count_ > in_.kept.in_all) return false;
    note_sureness(seeker, found);
    for (const Bond& pair : seeker.pairs) {
      const i32 owner = pair.owner < 0 ? seeker.number : pair.owner;
      if (seeker.share(pair) < 1.0) unpaid_.add({owner, static_cast<i32>(pair.rule - rules_of(owner).data)});
    }
    add_ways(found);
    List<Candidate> told = found;
    if (others_.size > 0) told = others_[seeker.number].is_loose ? between_others(seeker, whole.all(), others_) : List<Candidate>{};
    const i32 before = links_.size();
    for (const Bond& pair : seeker.pairs) {
      if (pair.owner < 0 && found.size() > 0 && !pair.setting.is_laid) add_links(pair);
    }
    pieces_.add({seeker.number, 0, seeker.row().kind, told.size(), links_.size() - before, -1, seeker.row().required, 0, GONE});
    candidates_.add_all(told.all());
    return true;
  }

  bool is_done() const { return in_.ways.size() == in_.rows.size; }

  Bytes told() const {
    const f64 sure = least_cost_ + most(0.0, spare_);
    return answer_rows(__builtin_bit_cast(u64, sure), unpaid().all(), all());
  }

 private:
  WantedRows all() const {
    const WantedRows found{pieces_.all(), candidates_.all(), links_.all()};
    if (!with_fronts_) return found;
    RoomType own = in_.type;
    own.pieces = reserved<PieceSpec>(in_.rows.size);
    for (PieceSpec& piece : own.pieces) piece.required = true;
    return with_fronts(in_.scope, own, found, OF_FRONTS);
  }

  Span<Rule> rules_of(i32 piece) const { return part_of(in_.type.rules, in_.rows[piece].rules); }

  // Those of the first pieces but one that a relation names, by their own label or one that copies share; first which it is dealt.
  List<i32> named(const Rule& rule, i32 first, i32 but) const {
    List<i32> found;
    for (const Name& name : in_.type.of(rule)) {
      for (i32 i = 0; i < first; i++) {
        const bool is_named = in_.rows[i].name == name.word || in_.rows[i].word == name.word;
        if (i != but && is_named && !has(found.all(), i)) found.add(i);
      }
    }
    return found;
  }

  List<i32> earlier(const Rule& rule, i32 piece) const { return named(rule, piece, piece); }

  // The sides of a piece, bit by bit, that are at a wall, or where somebody has to stand to use it.
  i32 closed(i32 piece) const {
    const Kind& kind = in_.type.kind(in_.rows[piece].kind);
    i32 found = kind.need_all || kind.use_count == 1 ? kind.use_sides : 0;
    for (const Rule& rule : rules_of(piece)) found |= static_cast<i32>(relation_of(rule.word).at_walls) << static_cast<i32>(Side::back);
    return found;
  }

  // Where a piece sits that is asked to stand around another, the first of those named, among all that are.
  Setting setting(const Rule& rule, i32 parent) const {
    List<Guest> guests;
    i32 own = -1;
    for (i32 i = 0; i < in_.rows.size && rule.word == Word::around; i++) {
      for (const Rule& one : rules_of(i)) {
        if (one.word != Word::around || one.align != Align::none) continue;
        const List<i32> others = named(one, in_.rows.size, i);
        if (others.size() == 0 || others[0] != parent) continue;
        if (&one == &rule) own = guests.size();
        guests.add({in_.type.kind(in_.rows[i].kind).width, all_or(part_of(in_.type.sides, one.sides))});
        break;
      }
    }
    return own < 0 ? Setting{} : settings(in_.type.kind(in_.rows[parent].kind), closed(parent), guests.all())[own];
  }

  // The pieces that have to keep to another's relation, those of them that come later: all it is to, or the only one.
  List<i32> owing(const Rule& rule, i32 piece) const {
    const List<i32> others = named(rule, in_.rows.size, piece);
    const bool all = rule.word != Word::on && (others.size() == 1 || relation_of(rule.word).with_all);
    return all ? others : List<i32>{};
  }

  bool any_stands(const List<i32>& pieces) const {
    for (i32 piece : pieces) {
      if (in_.ways[piece].size() > 0) return true;
    }
    return false;
  }

  // A piece with its relations to the room and to earlier pieces, and what earlier ones want of it; those to later ones are theirs.
  Seeker seeking(i32 number) const {
    Seeker seeker{in_, number, {}, {}};
    for (const Rule& rule : rules_of(number)) {
      const List<i32> pieces = earlier(rule, number);
      const Span<Name> names = in_.type.of(rule);
      bool to_room = names.size == 0;
      for (const Name& name : names) to_room = to_room || name.opening != Opening::none;
      if (pieces.size() == 0 && to_room) seeker.to_room.add(&rule);
      // To keep away from what has no way to stand is kept.
      if (pieces.size() == 0 || (relation_of(rule.word).with_all && !any_stands(pieces))) continue;
      seeker.pairs.add({&rule, -1, pieces, setting(rule, pieces[0])});
    }
    for (i32 owner = 0; owner < number; owner++) {
      for (const Rule& rule : rules_of(owner)) {
        for (i32 other : owing(rule, owner)) {
          if (other != number) continue;
          List<i32> only;
          only.add(owner);
          seeker.pairs.add({&rule, owner, only});
          break;
        }
      }
    }
    return seeker;
  }

  // All ways, cheapest first; none where the piece is too large, or hard relations rule all of them out.
  List<Candidate> ways_of(Seeker& seeker, const List<Foothold>& whole) const {
    const List<Foothold> few = searched(seeker, whole);
    List<Candidate> found, attached;
    bool hard = false;
    f64 dearest = INFINITE, worth = 0.0;
    for (const Bond& pair : seeker.pairs) {
      hard = hard || (pair.owner < 0 && pair.rule->required);
      worth += pair.rule->cost;
    }
    if (!hard) add_alone(seeker, few.all(), found);
    for (const Candidate& one : found) dearest = least(dearest, one.cost);
    dearest += worth;
    if (seeker.pairs.size() > 0 && found.size() > 0) seeker.drop(dearest);
    add_attached(seeker, few.all(), dearest, attached);
    const auto is_cheaper = [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; };
    stable_sort(attached.all(), is_cheaper);
    const i64 most = in_.kept.attached;
    if (attached.size() > most) seeker.drop(attached[most].cost);
    attached.cut(static_cast<i32>(most));
    found.add_all(attached.all());
    stable_sort(found.all(), is_cheaper);
    return found;
  }

  // The few rectangles that cost least, and the dearest: where nothing is held, a piece can still stand.
  List<Foothold> searched(Seeker& seeker, const List<Foothold>& whole) const {
    List<Foothold> few;
    const i32 each = static_cast<i32>(in_.kept.each);
    for (const Foothold& at : whole) {
      List<Costed>& found = few.add({at.stance, at.extent, at.reach, {}}).found;
      const i32 size = at.found.size();
      for (i32 i = 0; i < size; i++) {
        if (i < each || i == size - 1) found.add(at.found[i]);
      }
      if (each < size - 1) seeker.drop(at.found[each].cost);
    }
    return few;
  }

  // Notes what a placement costs at least that takes a way which was kept out.
  void note_sureness(const Seeker& seeker, const List<Candidate>& found) {
    const f64 cheapest = found.size() > 0 ? found[0].cost : 0.0;
    least_cost_ += cheapest;
    spare_ = least(spare_, seeker.dropped - cheapest);
  }

  // Notes the stances of the piece just made, and where its centre may be in each.
  void add_ways(const List<Candidate>& found) {
    List<Way> ways;
    for (const Candidate& one : found) {
      const Stance stance = stance_of(one.stance);
      Way* way = nullptr;
      for (Way& known : ways) way = known.stance == stance ? &known : way;
      if (!way) way = &ways.add({stance, ANY_PLACE});
      const Rect at = one.within == Rect{} ? in_.scope.clear : one.within;
      const Extent extent = turned(in_.type.kind(one.kind).size(), stance.rotation);
      if (extent.x > at.width() || extent.z > at.depth()) continue;
      const Rect centres = centres_in(at, extent), &all = way->reach;
      way->reach = all == ANY_PLACE ? centres : all.with(centres);
    }
    in_.ways.add(ways);
  }

  // Adds weak pulls to the pieces that a relation names, or away from them, for ways that are not at one of them.
  void add_links(const Bond& pair) {
    const Rule& rule = *pair.rule;
    const Relation& relation = pair.relation();
    for (i32 other : pair.earlier) {
      Link& link = links_.add(link_to(rule, other));
      if (!relation.with_all) {
        (relation.into_line ? link.align : link.near) = relation.into_line ? ALIGN_PULL : NEAR_PULL;
        return;
      }
      link.apart_m = PUSHED_BEYOND + static_cast<f64>(rule.distance_or(relation.usual)) / 1000;
      link.apart_cost = PUSHED_SHARE * rule.cost / link.apart_m;
    }
  }

  // Relations that some way, or each, does not pay for in full: those that it may hold or not, and those to any of several later pieces.
  List<CountRow> unpaid() const {
    List<CountRow> found = unpaid_;
    for (i32 piece = 0; piece < in_.rows.size; piece++) {
      const Span<Rule> rules = rules_of(piece);
      for (i32 i = 0; i < rules.size; i++) {
        const bool later = earlier(rules[i], piece).size() == 0 && owing(rules[i], piece).size() == 0;
        if (later && named(rules[i], in_.rows.size, -1).size() > 0) found.add({piece, i});
      }
    }
    return found;
  }

  Listing in_;
  Span<StandsRow> others_;
  bool with_fronts_;
  i64 count_ = 0;  // of ways
  f64 least_cost_ = 0.0, spare_ = INFINITE;
  List<CountRow> unpaid_;
  List<PieceRow> pieces_;
  List<Candidate> candidates_;
  List<Link> links_;
};

}  // namespace

Bytes listed_pieces(Bytes type_rows, Bytes room_rows) {
  const RoomType type = read_room_type(type_rows.data, type_rows.size);
  RoomHeader room;
  Reader reader(room_rows.data, room_rows.size);
  const Scope scope = read_room(reader, room);
  const ListHeader& header = reader.take<ListHeader>(1)[0];
  const Span<ListedRow> rows = reader.take<ListedRow>(header.standing + header.listed);
  const Span<StandsRow> others = reader.take<StandsRow>(header.told);
  if (header.told != 0 && header.told != rows.size) fail(Failure::bad_request);
  for (const ListedRow& row : rows) {
    type.kind(row.kind);
    if (part_of(type.rules, row.rules).size > MOST_RELATIONS / 2) fail(Failure::bad_request);
  }
  Lister lister(scope, type, header, rows, others);
  while (!lister.is_done()) {
    if (!lister.add()) return answer_rows(__builtin_bit_cast(u64, -1.0), {}, {});
  }
  return lister.told();
}

}  // namespace furnish
