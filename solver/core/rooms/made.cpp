#include "rooms/made.hpp"

#include "placement/grid.hpp"
#include "placement/options.hpp"
#include "placement/settle.hpp"
#include "placement/whole.hpp"
#include "plain/rounding.hpp"
#include "rooms/left_out.hpp"

namespace rooms {

using placement::Desk;
using placement::Settled;
using placement::WholeRoom;

constexpr placement::RoomLimits LIMITS = {3000, 2000, 16, 50, 2, 8, 24000};
constexpr i64 MARGIN_MM = 2;  // rounding to millimetres moves each of two bodies by less than one
constexpr i64 NEAR_WALL_MM = 150;  // a companion whose back is this close to its parent's wall counts as standing at it

static WantingRoom read(Bytes type_rows, Bytes room_rows) {
  WantingRoom room;
  room.type = furnish::read_room_type(type_rows.data, type_rows.size);
  furnish::RoomHeader header;
  Reader reader(room_rows.data, room_rows.size);
  room.scope = furnish::read_room(reader, header);
  room.header = reader.take<PlaceHeader>(1)[0];
  if (room.header.doorways < 0 || room.header.doorways > 1 << 16) fail(Failure::bad_request);
  room.doorways = reader.take<Doorway>(static_cast<i32>(room.header.doorways));
  for (const Doorway& one : room.doorways) {
    if (static_cast<i32>(one.wall) < 0 || static_cast<i32>(one.wall) > 3) fail(Failure::bad_request);
  }
  room.wanted = furnish::wanted_in(room.type, header, room.scope).rows;
  return room;
}

namespace {

// A room while it is made.
class Making {
 public:
  Making(const WantingRoom& room, bool tidy) : room_(room), tidy_(tidy) {}

  Bytes answer(f64 budget) {
    whole_ = placement::arrange_wide(asked_room(room_, room_.header.robot, 0), LIMITS, budget, made_.spent);
    const placement::FinalProblem* problem = nullptr;
    made_.failed = !desk().engine.nodes.result->found;
    if (!made_.failed) {
      made_.optimal = desk().engine.nodes.result->exhausted;
      made_.solves = whole_.solves;
      placement::hand_over(desk());
      problem = placement::final_problem(desk());
      settle(budget);
    }
    if (!made_.failed) {
      add_placed();
      add_standing();
      add_left_out();
    }
    return written(problem);
  }

 private:
  const Desk& desk() const { return *whole_.desk; }
  const placement::Engine& engine() const { return whole_.desk->engine; }

  // Puts what was found on whole millimetres.
  void settle(f64 budget) {
    const bool walk = whole_.walk || is_walkable_as_found();
    Settled settled = settle_found(walk);
    WholeRoom wider;
    if (walk && settled == Settled::not_walkable && is_found_for_wider(budget, wider)) {
      whole_ = wider;
      made_.widened = 1;
      placement::hand_over(desk());
      settled = settle_found(true);
    }
    if (walk && settled == Settled::not_walkable && whole_.ways != 0) {  // what is left is not quite so wide
      engine().room.space->ways = 0;
      settled = settle_found(true);
    }
    made_.failed = settled == Settled::no_whole_place || settled == Settled::not_valid;
    made_.walkable = settled == Settled::walkable;
    made_.proven = whole_.proven;
    made_.best = whole_.best;
    const f64 preference = placement::total_preference(engine().room, desk().decisions);
    made_.cost = rounded_6(engine().nodes.best_cost[0] + preference + desk().added[0]);
  }

  // Finds a room for a somewhat wider person: as it was found, else anew.
  bool is_found_for_wider(f64 budget, WholeRoom& wider) {
    const i64 robot = room_.header.robot + MARGIN_MM, ways = whole_.ways ? whole_.ways + MARGIN_MM : 0;
    if (arrange_again(asked_room(room_, robot, ways), whole_, LIMITS.final_qps, wider)) return true;
    wider = placement::arrange_wide(asked_room(room_, robot, 0), LIMITS, budget, made_.spent);
    wider.proven = wider.best = false;
    return wider.walk && wider.desk->engine.nodes.result->found;
  }

  Settled settle_found(bool walk) const { return placement::settle(desk(), walk, tidy_); }

  // Tells whether what was found, rounded to millimetres, is walkable.
  bool is_walkable_as_found() const {
    const Table<i64>& p = engine().grid.positions;
    for (i64 axis = 0; axis < 2; axis++) {
      for (i64 v = 0; v < engine().work.sizes[axis]; v++) p.at(axis, v) = whole(floor(desk().owns.at(axis, v) * 1000 + 0.5));
    }
    return placement::walkable(engine().room, engine().work, engine().grid, p);
  }

  void add_placed() {
    const placement::Room& room = engine().room;
    for (i32 k = 0; k < room.pieces.size; k++) {
      const i64 decision = desk().decisions[k];
      if (decision == placement::ABSENT || room.pieces[k].empty != 0) continue;
      const placement::Part& body = engine().work.parts[engine().work.body_part[k]];
      PlacedRow row;
      row.piece = whole_.asked.pieces[k];
      row.rotation = engine().work.rotation[k];
      row.way = room_.wanted.candidates[whole_.asked.candidates[placement::candidate_of(decision)]];
      const Table<i64>& p = engine().grid.positions;
      row.footprint.x0 = p.at(0, body.variable[0]) + body.offset[0];
      row.footprint.z0 = p.at(1, body.variable[1]) + body.offset[1];
      row.footprint.x1 = row.footprint.x0 + body.extent[0];
      row.footprint.z1 = row.footprint.z0 + body.extent[1];
      row.wall = static_cast<i64>(wall_of(row));
      placed_.add(row);
    }
  }

  // The wall that a piece stands at: its own, or that of the piece at whose slot it has its back to it, too.
  Wall wall_of(const PlacedRow& row) const {
    if (row.way.wall != Wall::none || row.way.parent < 0 || row.way.bottom != 0) return row.way.wall;
    const Wall behind = wall_behind(row.rotation);
    for (const PlacedRow& other : placed_) {
      if (other.piece == row.way.parent && other.wall == static_cast<i64>(behind)) {
        return row.footprint.wall_distance(behind, room_.scope.clear) <= NEAR_WALL_MM ? behind : Wall::none;
      }
    }
    return Wall::none;
  }

  // The number of a wanted piece among those that stand, -1 where it does not.
  i32 standing(i64 piece) const {
    for (i32 i = 0; i < placed_.size(); i++) {
      if (placed_[i].piece == piece) return i;
    }
    return -1;
  }

  void add_standing() {
    for (const PlacedRow& one : placed_) {
      i64 size[3];
      room_.size_of(one.way, size);
      ToldBody row = {};
      row.kind = one.way.kind;
      row.on = one.way.is_on ? standing(one.way.parent) : -1;
      row.under = one.way.is_under ? standing(one.way.parent) : -1;
      row.wall = static_cast<i32>(one.wall);
      row.rotation = static_cast<i32>(one.rotation);
      row.number = 1;
      for (const ToldBody& other : standing_) row.number += name_of(other) == name_of(row);
      row.rect = one.footprint;
      row.low = one.way.bottom;
      row.width = size[0], row.depth = size[1], row.height = size[2];
      standing_.add(row);
    }
  }

  i32 name_of(const ToldBody& row) const { return room_.type.kinds[row.kind].name; }

  void add_left_out() {
    for (const placement::LeftOut& one : whole_.left_out) {
      if (room_.wanted.pieces[static_cast<i32>(one.piece)].floor_side >= 0) continue;
      add_left(one.piece, one.certain ? CANNOT_STAND : NOT_FOUND);
    }
    const placement::Room& room = engine().room;
    for (i32 k = 0; k < room.pieces.size; k++) {
      if (desk().decisions[k] != placement::ABSENT || room.pieces[k].empty != 0) continue;
      const i64 fate = whole_.complete ? desk().fates[k] : static_cast<i64>(placement::SPENT);
      add_left(whole_.asked.pieces[k], fate == placement::NO_WAY ? NO_WAY : fate == placement::COVERED ? COVERED : SPENT);
    }
  }

  void add_left(i64 piece, Why why) { left_out_.add(left_out_row(room_, piece, why, placed_.all())); }

  // The rows one behind the other.
  Bytes written(const placement::FinalProblem* problem) {
    List<NameRow> names;
    for (const furnish::PieceRow& piece : room_.wanted.pieces) names.add({piece.spec, piece.number, piece.floor_side});
    made_.names = names.size();
    made_.placed = placed_.size();
    made_.left_out = left_out_.size();
    made_.problem = problem == nullptr ? 0 : problem->size;
    const Span<const i64> numbers = {reinterpret_cast<const i64*>(problem), static_cast<i32>(made_.problem)};
    const i64 rows = bytes_of(names.all()) + bytes_of(placed_.all()) + bytes_of(standing_.all()) + bytes_of(left_out_.all());
    Writer writer(sizeof(MadeRoom) + rows + 8 * made_.problem);
    writer.put(Span<MadeRoom>{&made_, 1});
    writer.put(names.all());
    writer.put(placed_.all());
    writer.put(standing_.all());
    writer.put(left_out_.all());
    writer.put(numbers);
    return writer.written();
  }

  const WantingRoom& room_;
  bool tidy_;
  WholeRoom whole_ = {};
  MadeRoom made_ = {};
  List<PlacedRow> placed_;
  List<ToldBody> standing_;
  List<LeftOutRow> left_out_;
};

}  // namespace

Bytes made_room(Bytes type_rows, Bytes room_rows, bool tidy, f64 budget) {
  const arena::Mark mark = arena::mark();
  const WantingRoom room = read(type_rows, room_rows);
  return moved_down(mark, Making(room, tidy).answer(budget));
}

}  // namespace rooms
