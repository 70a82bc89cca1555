// A room from what is asked to what stands in it: arranged, put on whole millimetres, tidied, and said in rows.
#pragma once

#include "placement/confirm.hpp"
#include "placement/settle.hpp"
#include "placement/whole.hpp"
#include "plain/tables.hpp"

namespace placement {

// The answer's beginning. How many rows follow of pieces that stand and of those left out, and how many numbers of the final problem
// (confirm.hpp).
struct MadeRoom {
  i64 placed, left_out, problem;
  i64 failed;    // whether the search found nothing, or what breaks a rule: a fault of ours
  i64 walked;    // whether only walkable placements were looked for, or what was found is one
  i64 walkable;  // whether it is on whole millimetres
  i64 proven, best;
  i64 optimal;   // whether the final problem's optimum is proven
  i64 widened;   // whether what stands is not that optimum: it was found again for a wider person, so that the walk outlasts the snap
  i64 solves;    // QPs
  f64 cost;      // terms and preferences
  f64 added;     // by how much tidying made the terms dearer
  f64 spent;     // work, in QPs of a small room
};

// A piece that stands, by its number and its candidate's in the room asked for. Its footprint is in mm.
struct PlacedRow {
  i64 piece, candidate, rotation;
  ::Wall wall;
  i32 unused;
  Rect footprint;
};

// A piece left out: what it counts, its smallest way to stand, and by wall the longest stretch that is free at its depth and height, mm.
struct LeftOutRow {
  i64 piece;
  Fate fate;
  f64 skip_cost;
  i64 parent;     // of that way, where all of its ways are at one; -1
  i64 kind, width, depth;  // the kind is -1 where it has no way
  i64 at_walls;   // whether any of its ways is at a wall
  i64 free[4];
};

// What is asked of a room.
struct MakingAsked {
  RoomLimits limits;
  f64 budget;  // work that each width of its ways may cost
  i64 walk;    // whether doors and use sides must be joined
  i64 wide;    // whether its ways are to be as wide as they are worth
  i64 tidy;    // whether slivers are tidied away
};

// A room while it is made.
class Making {
 public:
  // `doorways`: those of the room's doors.
  Making(const Room& room, const Span<Doorway>& doorways, const MakingAsked& asked) : room_(room), doorways_(doorways), asked_(asked) {}

  // Makes the room.
  void make();
  // Tells of a room what a search just found in it, put on whole millimetres; `walk`: only walkable placements were looked for.
  void tell(Desk& desk, bool walk);
  // How many bytes its answer takes, and the answer: what is said of it, its rows, its final problem.
  i64 size() const;
  void put(Writer& writer) const;

  const WholeRoom& whole() const { return whole_; }
  const MadeRoom& made() const { return made_; }
  Span<PlacedRow> placed() const { return placed_.all(); }

 private:
  const Desk& desk() const { return *whole_.desk; }
  const Engine& engine() const { return whole_.desk->engine; }
  WholeRoom arranged(const Room& room);
  Room for_person(i64 robot, i64 ways) const;
  bool is_found() const { return engine().nodes.result->found != 0; }
  bool is_found_for_wider(WholeRoom& wider);
  bool is_walkable_as_found() const;
  void conclude(bool walk, Settled settled);
  void add_placed();
  ::Wall wall_of(const PlacedRow& row) const;
  void add_left_out();
  void add_left(i64 piece, Fate fate);
  i64 longest_free(::Wall wall, i64 depth, i64 height) const;

  Room room_;
  Span<Doorway> doorways_;
  MakingAsked asked_;
  WholeRoom whole_ = {};
  MadeRoom made_ = {};
  const FinalProblem* problem_ = nullptr;
  List<PlacedRow> placed_;
  List<LeftOutRow> left_out_;
};

}  // namespace placement
