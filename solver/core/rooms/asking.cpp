#include "rooms/asking.hpp"

#include "placement/piece_tables.hpp"
#include "plain/least_floor.hpp"

namespace rooms {

using furnish::Candidate;
using placement::CandidateRow;
using placement::SidesRow;

constexpr f64 OTHER_SIDE_COST = 0.05;  // what using the second of several allowed sides costs: order, not preference

void WantingRoom::size_of(const Candidate& way, i64 (&size)[3]) const {
  const bool is_floor = way.kind < 0;
  size[0] = is_floor ? way.floor.x : type.kinds[way.kind].width;
  size[1] = is_floor ? way.floor.z : type.kinds[way.kind].depth;
  size[2] = is_floor ? placement::PERSON_MM : type.kinds[way.kind].height;
}

namespace {

// The room's tables while they are written.
class Asked {
 public:
  explicit Asked(const WantingRoom& room) : room_(room) {}

  placement::Room all() {
    add_pieces();
    placement::Room made;
    made.space = {space().data, sizeof(placement::SpaceRow) / 8};
    // A zone is the same row to both stages.
    static_assert(sizeof(furnish::Zone) == sizeof(placement::Zone));
    made.zones = {reinterpret_cast<placement::Zone*>(room_.scope.zones.data), room_.scope.zones.size, sizeof(placement::Zone) / 8};
    made.doors = placement::doors_of(*made.space.data, room_.doorways);
    tables_.give_to(made);
    placement::derive(made);
    return made;
  }

 private:
  Span<placement::SpaceRow> space() const {
    const Rect& clear = room_.scope.clear;
    const Span<placement::SpaceRow> found = reserved<placement::SpaceRow>(1);
    const PlaceHeader& header = room_.header;
    found[0] = {{clear.x0, clear.z0}, {clear.x1, clear.z1}, room_.scope.gap, header.robot, header.cover, LEAST_FLOOR_MM2, 0, 0};
    return found;
  }

  void add_pieces() {
    Range ways = {0, 0}, bonds = {0, 0};
    tables_.pieces.reserve(room_.wanted.pieces.size);
    tables_.skip_costs.reserve(room_.wanted.pieces.size);
    tables_.candidates.reserve(room_.wanted.candidates.size);
    tables_.candidate_costs.reserve(room_.wanted.candidates.size);
    for (const furnish::PieceRow& piece : room_.wanted.pieces) {
      ways = {ways.first + ways.count, piece.candidates};
      bonds = {bonds.first + bonds.count, piece.links};
      placement::PieceRow own = {};
      tables_.mark(own, 0);
      add_candidates(part_of(room_.wanted.candidates, ways));
      for (const furnish::Link& link : part_of(room_.wanted.links, bonds)) add_link(link);
      const bool is_floor = piece.floor_side >= 0;
      if (is_floor) {
        add_sides({0, 0, 0}, 0.0);
      } else {
        add_use(piece);
      }
      tables_.mark(own, 1);
      own.required = piece.required;
      own.group_end = piece.with_next;
      own.empty = is_floor ? placement::EMPTY_FLOOR : 0;
      tables_.pieces.add(own);
      tables_.skip_costs.add(piece.skip_cost);
    }
  }

  void add_candidates(Span<Candidate> ways) {
    for (const Candidate& way : ways) {
      CandidateRow own = {};
      i64 size[3];
      room_.size_of(way, size);
      own.kind = way.kind;
      own.width = size[0];
      own.depth = size[1];
      own.height = size[2];
      own.turn = floor_mod(way.rotation, 360);
      own.wall = static_cast<i64>(way.wall);
      const Rect& clear = way.within.x0 < way.within.x1 ? way.within : room_.scope.clear;
      own.anchor[0] = way.anchor.x, own.anchor[1] = way.anchor.z;
      own.low[0] = clear.x0, own.low[1] = clear.z0;
      own.high[0] = clear.x1, own.high[1] = clear.z1;
      own.bottom = way.bottom;
      own.parent = own.parent_kind = own.slot = -1;
      if (way.parent >= 0) add_place_at(way, own);
      own.under = way.is_under ? way.parent : -1;
      own.on = way.is_on ? way.parent : -1;
      own.slack = -1;
      tables_.candidates.add(own);
      tables_.candidate_costs.add({{way.weight, way.weight}, way.cost});
    }
  }

  void add_place_at(const Candidate& way, CandidateRow& own) const {
    if (way.parent >= tables_.pieces.size()) fail(Failure::bad_request);
    own.parent = way.parent;
    own.parent_kind = way.parent_kind;
    own.across[0] = way.across.low, own.across[1] = way.across.high;
    own.along[0] = way.along.low, own.along[1] = way.along.high;
    own.anchor[0] = way.across.low + way.across.high, own.anchor[1] = way.along.low + way.along.high;
    own.slot = slot_of(way);
  }

  // A number for a slot of a parent: two pieces never take the same one; -1 for none.
  i64 slot_of(const Candidate& way) const {
    constexpr i64 SORTS = 4, SIDES = 4, MIDDLE = 1LL << 40;
    const i64 sort = static_cast<i64>(way.slot);
    if (way.slot == furnish::Slot::none) return -1;
    if (way.slot == furnish::Slot::level) return SORTS * level_name(way) + sort;
    const i64 number = way.slot == furnish::Slot::seat ? way.slot_number + MIDDLE : 0;
    return SORTS * (SIDES * number + static_cast<i64>(way.slot_side)) + sort;
  }

  i64 level_name(const Candidate& way) const {
    return room_.type.levels_of(room_.type.kind(way.parent_kind))[way.slot_number].name;
  }

  void add_link(const furnish::Link& link) {
    constexpr i64 WALLS[] = {placement::ANY_WALLS, placement::SAME, placement::OPPOSITE, placement::ADJACENT, placement::OTHER};
    tables_.links.add({link.of, link.turn, WALLS[static_cast<i32>(link.walls)], link.required});
    tables_.link_costs.add({link.cost, link.align, link.near, link.apart_m, link.apart_cost});
  }

  void add_sides(const SidesRow& row, f64 cost) {
    tables_.sides.add(row);
    tables_.side_costs.add(cost);
  }

  // Adds the choices of use sides of a piece: all of them at once, or one of them, the first of them best.
  void add_use(const furnish::PieceRow& piece) {
    constexpr i64 BITS[] = {placement::LEFT, placement::RIGHT, placement::FRONT, placement::BACK};
    const furnish::PieceSpec& spec = room_.type.pieces[piece.spec];
    const furnish::Kind& kind = room_.type.kind(piece.kind);
    const bool asked = spec.approach.count > 0;
    const Span<Side> sides = part_of(room_.type.sides, asked ? spec.approach : kind.use);
    i64 all = 0;
    for (Side side : sides) all |= BITS[static_cast<i32>(side)];
    if (sides.size == 0 || asked || kind.need_all) {
      add_sides({all, 0, 0}, 0.0);
      return;
    }
    for (i32 k = 0; k < sides.size; k++) add_sides({BITS[static_cast<i32>(sides[k])], 0, 0}, OTHER_SIDE_COST * k);
  }

  const WantingRoom& room_;
  placement::PieceTables tables_;
};

}  // namespace

placement::Room asked_room(const WantingRoom& room) { return Asked(room).all(); }

}  // namespace rooms
