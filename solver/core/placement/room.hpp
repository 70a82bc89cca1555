// What placement is asked: a room and its pieces, as rows of numbers. The host writes them; nothing here is changed by a search.
//
// Whole numbers are millimetres unless a name says otherwise, floats metres and costs. Axis 0 is x (east), axis 1 is z (south).
// Where a row is about another piece, candidate and so on it has its number, or -1.
#pragma once

#include "plain/rects.hpp"
#include "plain/spans.hpp"

namespace placement {

constexpr i64 ORIGIN = -1;  // in place of a variable: the origin of its axis
constexpr i64 ABSENT = -1;  // in place of a decision: the piece is left out
constexpr i64 MANY = 1'000'000;  // a limit that is none
constexpr i64 PERSON_MM = 1800;  // height a standing person needs free
constexpr i64 HEADROOM_MM = 2000;  // what hangs higher is walked under (as the validator has it)

enum Wall : i64 { NO_WALL = -1, NORTH, SOUTH, EAST, WEST };
enum Side : i64 { FRONT = 1, BACK = 2, LEFT = 4, RIGHT = 8, EMPTY_FLOOR = 16 };
enum WallsOfTwo : i64 { ANY_WALLS, SAME, OPPOSITE, OTHER, ADJACENT };

// Where furniture may stand, and what is asked of the room as a whole.
struct SpaceRow {
  i64 low[2], high[2];
  i64 gap;  // between a body and the wall it stands at
  i64 robot;  // how wide the person is
  i64 cover;  // mm2 of floor to be covered, or 0
  i64 least_floor;  // mm2 of free centres that a person must have
  i64 ways;  // how wide the ways from door to door are; no more than `robot` asks for nothing
  // How many of the first doors one comes in by from outside the house: they are joined there; -1: nobody comes in, and one walks in
  // the largest part of the floor.
  i64 outer;
};

// A rectangle above which height it counts, and whether it is a part missing from the room.
struct Zone {
  i64 low[2], high[2];
  i64 above;
  i64 is_wall;
};

// Where the person's centre is when it has just come through a door, in doubled millimetres.
struct Door {
  i64 low[2], high[2];
};

constexpr i64 STANDS = 2;

// A piece: its candidates, links and choices of use sides are ranges of their tables. A group is up to `group_end`.
// `required` is STANDS where it stands already: it need not keep apart from zones and from others that do. It is below nothing, and says
// why (Fate of fill.hpp), where the piece is left out already and only told of.
// `empty` is EMPTY_FLOOR for floor that is asked for empty, as if a person stood all over it: no body, but apart from all bodies.
struct PieceRow {
  i64 required;
  i64 candidates[2], links[2], sides[2];
  i64 group_end;
  i64 empty;
};

// A choice of use sides, as bits: which get a stand; without one, of which any and of which all must be reached. So much of either end of
// a side does not count, mm.
struct SidesRow {
  i64 stands, any_of, all_of, inset = 0;
};

// One way for a piece to stand: free in a rectangle, flush at a wall, or at a slot of a parent.
struct CandidateRow {
  i64 kind, width, depth, height;
  i64 turn;  // degrees; relative to the parent where there is one
  i64 wall;
  i64 anchor[2];  // where its centre is wished; with a parent twice that, in its frame from its centre
  i64 low[2], high[2];  // where its footprint may be
  i64 bottom;
  i64 parent, parent_kind;
  i64 across[2], along[2];  // least and most, of its centre in the parent's frame
  i64 slot, under, on;
  i64 slack;  // farthest from its wall; -1: at the gap
  i64 kin;  // candidates of one kin differ only in their anchor and cost
};

struct CandidateCost {
  f64 weight[2];
  f64 cost;
};

constexpr i64 LOOKS_AT = 360;  // the turn of a link by which one piece looks at the other

// A relation to a piece before; its turn is in degrees, LOOKS_AT, or -1 where any will do.
struct LinkRow {
  i64 of, turn, walls, required;
};

struct LinkCost {
  f64 cost, align, near, apart, apart_cost;
};

struct Room {
  One<SpaceRow> space;
  Rows<Zone> zones;
  Rows<Door> doors;
  Rows<PieceRow> pieces;
  Span<f64> skip_costs;
  Rows<SidesRow> sides;
  Span<f64> side_costs;
  Rows<CandidateRow> candidates;
  Rows<CandidateCost> candidate_costs;
  Rows<LinkRow> links;
  Rows<LinkCost> link_costs;
};

// Tells whether nobody comes in: one walks in the largest part of the floor.
inline bool is_walked_in_largest(const Room& room) { return room.doors.size == 0 || room.space->outer < 0; }

// Where the person's centre is when it has just come through each door.
Rows<Door> doors_of(const SpaceRow& space, const Span<Doorway>& doorways);

// Derives which candidates are of one kin, and groups: a piece whose `group_end` is 1 comes with the next only, one with 0 by itself.
void derive(const Room& room);

// What is decided: of each piece 8 * candidate + the number of its choice of sides, or ABSENT.
using Decisions = Span<i64>;

inline i64 candidate_of(i64 decision) { return decision >> 3; }
inline i64 sides_of(i64 decision) { return decision & 7; }

// A hash of numbers, with one more; its upper bits are the good ones.
constexpr u64 mixed(u64 hash, i64 number) { return (hash ^ static_cast<u64>(number)) * 0x9E3779B97F4A7C15ULL; }

static_assert(sizeof(SpaceRow) == 10 * 8 && sizeof(Zone) == 6 * 8 && sizeof(Door) == 4 * 8 && sizeof(PieceRow) == 9 * 8);
static_assert(sizeof(SidesRow) == 4 * 8 && sizeof(CandidateRow) == 24 * 8 && sizeof(CandidateCost) == 3 * 8);
static_assert(sizeof(LinkRow) == 4 * 8 && sizeof(LinkCost) == 5 * 8);

}  // namespace placement
