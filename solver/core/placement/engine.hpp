// The work space of one room, allocated once (space.hpp).
#pragma once

#include "placement/room.hpp"

namespace placement {

constexpr i64 OPTIONS = 4;  // options a choice has at most

// p_j - p_i >= s along an axis, s in mm.
struct DifferenceRow {
  i64 axis, i, j, s;
};

// Something that takes space: the body of a piece, or (stand != 0) a person's square at one of its use sides.
// It lies from variable + offset to variable + offset + extent, and from height low to high.
struct Part {
  i64 piece, stand;
  i64 variable[2], offset[2], extent[2];
  i64 low, high;
};

// Tells whether a part is in the way of who walks: no person's square, and not hung so high that one walks under it.
inline bool is_in_the_way(const Part& part) { return part.stand == 0 && part.low < HEADROOM_MM; }

// A zone as a part.
inline Part unmoved(const Zone& zone) {
  const auto& [x, z] = zone.low;
  return {-1, 0, {ORIGIN, ORIGIN}, {x, z}, {zone.high[0] - x, zone.high[1] - z}, zone.above, MANY};
}

// A wish for the distance between two variables: weight (p_j - p_i - offset)^2.
struct PullRow {
  i64 axis, i, j;
};

struct PullCost {
  f64 offset, weight;
};

// The two parts that a choice keeps apart; of the second -1 - its number for a zone.
struct ChoiceParts {
  i64 part[2];
};

struct Counts {
  i64 rows, parts, choices, pulls, wide;
  i64 assembled;  // pieces that the problem was laid out for, the last of them decided: all behind are left out
  i64 placed;     // choices whose options are in `placed_options`
  i64 unused;
};

// An option over places in a table of positions (both axes, one behind the other): the one at j less the one at i is s at least, m.
struct PlacedOption {
  i32 i, j;
  f64 s;
};

// What the problem was once a piece was added, beside its bounds.
struct Mark {
  i64 decision;
  i64 sizes[2];
  i64 rows, parts, choices, pulls;
  i64 bounds;  // the last piece that stands, whose `marked_bounds` these are, or -1
};

// A problem: variables with bounds and anchors, pulls, fixed rows, and choices. Choice c has the options 4c ... 4c + choice_size[c] - 1.
struct Work {
  One<Counts> counts;
  Span<i64> sizes;  // number of variables along each axis
  Table<i64> low, high;
  Table<i64> least, most;  // how far the rows, and choices with one option, let each variable go at most
  Table<f64> anchor_weight, anchor_at;
  Rows<PullRow> pulls;
  Rows<PullCost> pull_costs;
  Rows<DifferenceRow> rows;
  Rows<Part> parts;
  Span<i64> choice_size;
  Rows<ChoiceParts> choice_parts;
  Rows<DifferenceRow> options;
  Span<PlacedOption> placed_options;
  Span<PlacedOption> held;  // of a choice: the option that held when it was last looked at, which is looked at first
  Rows<DifferenceRow> wide;  // what widenings ask for; option number options.size + k
  Span<i64> body_part, rotation, taken_candidate, taken_side;  // by piece
  Rows<Mark> marks;
  Cube<i64> marked_bounds;  // by piece: low of both axes, high, least, most
};

// x_j - x_i + rest >= 0 along an axis, m, over numbers of its free variables. What does not move has the number after theirs: its x is 0.
struct FreeRow {
  i32 i, j;
  f64 rest;
};

// The quadratic programme of an axis over its free variables; see program.hpp. Rows by free variable are `width` long: an even number with
// room for what does not move, and noughts there.
struct Program {
  i32 variables, size;  // how many there are, and how many of them are free
  i32 width;
  i32 fixed_rows, most_rows;
  f64 start_cost;
  Span<i32> column;  // of a variable, the last one the origin: its number among the free ones
  Span<f64> value;   // of a fixed variable, m; of others 0
  Span<f64> start;
  Table<f64> inverse;
  Span<FreeRow> rows;  // first the lower and the upper bound of every free variable
  Span<f64> low, high;    // bounds of each free variable, m
  Span<f64> least, most;  // how far the rows let each free variable go, m
  Table<f64> columns, factor;
  Span<f64> rates;
};

struct NodesState {
  i64 open, spare, picked;
  i64 untouched;  // of the spare slots, so many at the bottom were never open: each its own number, not written out
  i64 versions;   // axes solved so far
  i64 shown[2], based[2], reached[2];  // the version of an axis whose rows and positions, base and reach are there, or none
};

constexpr i64 NO_VERSION = -1;

// What a node knows of an axis beside places and multipliers. Two nodes with one version of it know the same.
struct NodeAxis {
  f64 cost;
  i32 active, rows;  // constraints that are active; rows of its path
  i64 version, before;  // and the version that has the rows of its path but the last
};

struct OptionSlack {
  i64 option, slack;
};

struct Child {
  i64 slot, key;
};

struct SearchResult {
  i64 found, exhausted, solves, turned_down, picks, forces;
  i64 dear;  // whether a node was left for its cost, so that "none" holds for what costs less than asked alone
  i64 beside;  // whether it rests on the optimum of what stood before
};

// A constraint that holds something at the optimum: free variables that its row keeps apart along an axis, or -1 (a bound, a fixed end).
struct ForceRow {
  i64 axis, i, j;
};

// Open nodes of the tree, by slot; `stack` and `spare` hold slots. A path is a chain of picks: the one before and its option.
struct Nodes {
  One<NodesState> state;
  Cube<f64> x;
  Cube<i32> active;
  Cube<f64> multiplier;
  Table<NodeAxis> axes;
  Span<i64> last_pick, widened, stack, spare, pick_before, pick_option;
  Table<f64> positions;  // of the open node, m; the last column is the origin's
  Rows<OptionSlack> order;
  Rows<Child> family;
  Table<f64> best;
  Span<i64> best_picks;
  Span<f64> best_cost;
  Rows<ForceRow> best_forces;
  Span<f64> best_multipliers;  // of these rows, per m
  One<SearchResult> result;

  f64 total(i64 slot) const { return axes.at(slot, 0).cost + axes.at(slot, 1).cost; }
};

struct GridState {
  i64 blocks, targets;
  i64 cuts[2];
  i64 components;
  i64 numbers;  // of targets: of the rectangles of one number any will do
  i64 entered;  // the component one walks in, or 0
  i64 width;  // of who walked last
  i64 unfinished;  // whether pieces are to come that stand in the room already
};

// A rectangle with a number: of a block its part, or -1 - its zone; of a target what is to be reached there.
struct NumberedRect {
  i64 low[2], high[2];
  i64 number;
};

// Cells from `first` to before `last` along both axes.
struct Cells {
  i32 first[2], last[2];
};

// Free cells side by side along z, from `first` to before `last`; its component's number.
struct Run {
  i32 first, last, component;
};

struct Reached {
  i64 count, last;
};

// The compressed grid of the walk; see grid.hpp. Lengths in it are doubled millimetres.
struct WalkGrid {
  One<GridState> state;
  Rows<NumberedRect> blocks, targets;
  Table<i64> cuts;
  Span<i64> edges;  // ends of blocks along an axis: where, and of which block, as one number
  Span<Cells> block_cells;
  Span<u64> blocked;  // cells, a bit each, row by row along x, each of whole words
  Span<Run> runs;    // row by row
  Span<i32> first_run;  // by row, and where they end
  Span<i64> areas;
  Rows<Reached> reached;
  Table<i64> positions;  // mm, not doubled; the last column is the origin's
};

struct Counters {
  i64 states, heaped, order, evaluated;
  i64 closed;  // whether the answer is exact within the search
  i64 diving;
  i64 best, deepest;  // numbers of states, or -1
  i64 refused;
  i64 incumbent, lapsed, solved_qps, moves_left;
  i64 begun;         // whether it began with decisions whose optimum is known
};

struct HeapEntry {
  i64 rank, bound, age, state, decision;
};

struct Move {
  i64 piece, decision;
};

// Pieces from `first` to before `last`.
struct Group {
  i64 first, last;
};

// Evaluations before the dive, QPs of each, and evaluations that may end at that limit before the search gives up. `every_gap`: whether a
// way for which the walk turned a placement down is evaluated again in all ways to open the walk.
struct SearchLimits {
  i64 evaluations, qps, lapses, every_gap;
};

// What a QP of a search costs, and what reading its choices does, in QPs of a small room.
struct Effort {
  f64 of_a_qp, reading;
};

// A cost, of it the preferences, and the cost above which no answer counts.
struct Costs {
  f64 all, preferences, ceiling;
};

constexpr Costs NOTHING_SPENT = {0.0, 0.0, 1e12};

// What is known of a state: what its terms cost, whether that is the optimum, and whether a placement was turned down for the wider ways.
struct Optimum {
  f64 cost;
  i64 proven, closed;
};

// Best-first search over prefixes; see grow.hpp.
struct Tree {
  One<Counters> counters;
  Span<f64> budget;  // QPs of a small room that are left
  Table<i64> decisions;
  Span<f64> costs, preferences;
  Span<i64> depths;
  Span<Optimum> optima;  // of the first states
  Cube<f64> places;      // and where their variables are, m
  Span<i64> begun;       // the decisions that those of number 0 are of
  Rows<HeapEntry> heap;
  Span<f64> heap_cost;
  Span<u64> refused;      // fingerprints
  Span<i32> refused_at;   // where in the table each is
  Span<i32> refused_table;        // their numbers; a place is taken where the fingerprint of its number is there: nothing is ever cleared
  Span<i64> found;
  Span<f64> found_cost;
  Span<i64> trial;
  Rows<Move> moves;
  Span<f64> move_cost;
  Span<i64> shifted;
};

struct Memo;

struct Engine {
  Room room;
  Work work;
  Span<Program> programs;  // by axis
  Nodes nodes;
  WalkGrid grid;
  Tree tree;
  Memo* memo;  // where evaluations are noted, or recalled from; null: nowhere
};

// The row of an option of a choice, or of a widening.
inline const DifferenceRow& row_of(const Work& work, i64 option) {
  return option < work.options.size ? work.options[option] : work.wide[option - work.options.size];
}

// A bound of a variable; the origin does not move.
inline i64 bound_of(const Table<i64>& bounds, i64 axis, i64 variable) { return variable == ORIGIN ? 0 : bounds.at(axis, variable); }

// A position of a table (axis, variable) whose last column is the origin's.
template <class T> inline T place_of(const Table<T>& positions, i64 axis, i64 variable) {
  return positions.at(axis, variable < 0 ? positions.columns - 1 : variable);
}

static_assert(sizeof(Part) == 10 * 8 && sizeof(Mark) == 8 * 8 && sizeof(Counters) == 14 * 8 && sizeof(GridState) == 9 * 8);

}  // namespace placement
