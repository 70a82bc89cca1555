#include "placement/space.hpp"

#include "placement/branch.hpp"

namespace placement {

constexpr i64 SPARE_PATH = 64;  // rows a path may have beside one for every choice: its widenings, and what leaves siblings
constexpr i64 MOST_WIDE = 8192;  // rows that the widenings of one search may ask for
constexpr i64 MOST_NODES = 4096;  // open nodes of one search; where there would be more, the search stops as at its limit
constexpr i64 MOST_PICKS = 200'000;  // children one search may create; as with the nodes
constexpr i64 MOST_STATES = 6500;  // prefixes the best-first search may keep
constexpr i64 MOST_OPTIMA = 512;  // of the first states it is kept where they stand
constexpr i64 MOST_MOVES = 64;
constexpr i64 MOST_REFUSED = 4096;  // a power of two

template <class T> static Table<T> new_table(i64 rows, i64 columns) {
  return {reserved<T>(static_cast<i32>(rows * columns)).data, static_cast<i32>(rows), static_cast<i32>(columns)};
}

template <class T> static Table<T> new_zeroes(i64 rows, i64 columns) {
  return {zeroes<T>(static_cast<i32>(rows * columns)).data, static_cast<i32>(rows), static_cast<i32>(columns)};
}

template <class T> static Cube<T> new_cube(i64 blocks, i64 rows, i64 columns) {
  const Table<T> table = new_table<T>(blocks * rows, columns);
  return {table.data, static_cast<i32>(blocks), static_cast<i32>(rows), static_cast<i32>(columns)};
}

template <class T> static Span<T> new_span(i64 count) { return reserved<T>(static_cast<i32>(count)); }

template <class T> static One<T> new_one() { return {zeroes<T>(1).data, sizeof(T) / 8}; }

// Takes tables that lie one behind the other.
struct Cursor {
  u8* at;

  template <class T> T* take(i64 count) {
    T* found = reinterpret_cast<T*>(at);
    at += count * static_cast<i64>(sizeof(T));
    return found;
  }
  template <class T> Rows<T> rows(i64 count) { return {take<T>(count), static_cast<i32>(count), sizeof(T) / 8}; }
  template <class T> Span<T> span(i64 count) { return {take<T>(count), static_cast<i32>(count)}; }
};

SentRoom room_of(RoomRequest* request) {
  const RoomRequest& sent = *request;
  Cursor from = {reinterpret_cast<u8*>(request + 1)};
  SentRoom found;
  Room& room = found.room;
  room.space = {from.take<SpaceRow>(1), sizeof(SpaceRow) / 8};
  room.zones = from.rows<Zone>(sent.zones);
  found.doorways = from.span<Doorway>(sent.doors);
  room.doors = doors_of(*room.space.data, found.doorways);
  room.pieces = from.rows<PieceRow>(sent.pieces);
  room.skip_costs = from.span<f64>(sent.pieces);
  room.sides = from.rows<SidesRow>(sent.sides);
  room.side_costs = from.span<f64>(sent.sides);
  room.candidates = from.rows<CandidateRow>(sent.candidates);
  room.candidate_costs = from.rows<CandidateCost>(sent.candidates);
  room.links = from.rows<LinkRow>(sent.links);
  room.link_costs = from.rows<LinkCost>(sent.links);
  derive(room);
  return found;
}

Sizes sizes_of(const Room& room) {
  i64 stands = 0, decisions = 0;
  for (i64 piece = 0; piece < room.pieces.size; piece++) {
    const PieceRow& row = room.pieces[piece];
    i64 widest = 0;
    for (i64 side = row.sides[0]; side < row.sides[1]; side++) {
      widest = most<i64>(widest, __builtin_popcountll(static_cast<u64>(room.sides[side].stands)));
    }
    stands += widest;
    decisions = most(decisions, (row.candidates[1] - row.candidates[0]) * (row.sides[1] - row.sides[0]));
  }
  const i64 count = room.pieces.size, walls = room.zones.size, doors = room.doors.size, parts = count + stands;
  Sizes found;
  found.pieces = most<i64>(count, 1);
  found.variables = most<i64>(parts, 1);
  found.choices = parts * (parts - 1) / 2 + parts * walls + 1;
  found.rows = 4 * count + 2 * stands + 4;
  found.pulls = 2 * count + stands + 2 * room.links.size + 1;
  found.walls = walls;
  found.doors = doors;
  found.decisions = most<i64>(decisions, 1);
  found.states = MOST_STATES;
  return found;
}

static Work new_work(const Sizes& sizes) {
  const i64 p = sizes.pieces, v = sizes.variables, c = sizes.choices;
  Work work;
  work.counts = new_one<Counts>();
  work.sizes = zeroes<i64>(2);
  work.low = new_table<i64>(2, v);
  work.high = new_table<i64>(2, v);
  work.least = new_table<i64>(2, v);
  work.most = new_table<i64>(2, v);
  work.anchor_weight = new_table<f64>(2, v);
  work.anchor_at = new_table<f64>(2, v);
  work.pulls = reserved_rows<PullRow>(sizes.pulls);
  work.pull_costs = reserved_rows<PullCost>(sizes.pulls);
  work.rows = reserved_rows<DifferenceRow>(sizes.rows);
  work.parts = reserved_rows<Part>(v);
  work.choice_size = new_span<i64>(c);
  work.held = new_span<PlacedOption>(c);
  work.choice_parts = reserved_rows<ChoiceParts>(c);
  work.options = reserved_rows<DifferenceRow>(OPTIONS * c);
  work.placed_options = new_span<PlacedOption>(OPTIONS * c);
  work.body_part = new_span<i64>(p);
  work.rotation = new_span<i64>(p);
  work.taken_candidate = new_span<i64>(p);
  for (i64& candidate : work.taken_candidate) candidate = ABSENT;
  work.taken_side = new_span<i64>(p);
  work.marks = reserved_rows<Mark>(p);
  work.marked_bounds = new_cube<i64>(p, 8, v);
  return work;
}

// How long rows by free variable are where all are free.
static i64 widest(const Sizes& sizes) { return (sizes.variables + 2) / 2 * 2; }

static Program new_program(const Sizes& sizes) {
  const i64 v = sizes.variables, wide = widest(sizes);
  Program program = {};
  program.most_rows = static_cast<i32>(sizes.rows + sizes.choices + SPARE_PATH);
  program.column = new_span<i32>(v + 1);
  program.value = new_span<f64>(v + 1);
  program.start = new_span<f64>(wide);
  program.inverse = new_table<f64>(v + 1, wide);
  program.rows = new_span<FreeRow>(2 * v + program.most_rows);
  program.low = new_span<f64>(wide);
  program.high = new_span<f64>(wide);
  program.least = new_span<f64>(wide);
  program.most = new_span<f64>(wide);
  program.columns = new_table<f64>(v + 1, wide);
  program.factor = new_table<f64>(v + 1, wide);
  program.rates = new_span<f64>(v);
  return program;
}

static Nodes new_nodes(const Sizes& sizes) {
  const i64 v = sizes.variables, n = least(MOST_NODES, 4 * sizes.choices + 128);
  Nodes nodes;
  nodes.state = new_one<NodesState>();
  nodes.x = new_cube<f64>(n, 2, widest(sizes));
  nodes.active = new_cube<i32>(n, 2, v);
  nodes.multiplier = new_cube<f64>(n, 2, v);
  nodes.axes = new_table<NodeAxis>(n, 2);
  nodes.last_pick = new_span<i64>(n);
  nodes.widened = new_span<i64>(n);
  nodes.stack = new_span<i64>(n);
  nodes.spare = new_span<i64>(n);
  nodes.pick_before = new_span<i64>(MOST_PICKS);
  nodes.pick_option = new_span<i64>(MOST_PICKS);
  nodes.positions = new_zeroes<f64>(2, v + 1);
  nodes.order = reserved_rows<OptionSlack>(OPTIONS);
  nodes.family = reserved_rows<Child>(MOST_FAMILY);
  nodes.best = new_zeroes<f64>(2, v + 1);
  nodes.best_picks = new_span<i64>(sizes.choices + SPARE_PATH);
  nodes.best_cost = zeroes<f64>(1);
  nodes.best_forces = reserved_rows<ForceRow>(2 * v);
  nodes.best_multipliers = new_span<f64>(2 * v);
  nodes.result = new_one<SearchResult>();
  return nodes;
}

static WalkGrid new_grid(const Sizes& sizes) {
  WalkGrid grid;
  grid.state = new_one<GridState>();
  grid.positions = new_zeroes<i64>(2, sizes.variables + 1);
  return grid;
}

// Adds what each walk writes anew: cells of where bodies may be.
static void add_cells(WalkGrid& grid, const Sizes& sizes) {
  const i64 blocks = sizes.pieces + sizes.walls;
  const i64 cuts = 2 * blocks + 2;
  const i64 runs = (cuts - 1) * (cuts / 2);
  grid.blocks = reserved_rows<NumberedRect>(blocks);
  grid.targets = reserved_rows<NumberedRect>(sizes.doors + OPTIONS * sizes.pieces);
  grid.cuts = new_table<i64>(2, cuts);
  grid.edges = new_span<i64>(2 * blocks);
  grid.block_cells = new_span<Cells>(blocks);
  grid.blocked = new_span<u64>((cuts - 1) * (cuts / 64 + 1));
  grid.runs = new_span<Run>(runs);
  grid.first_run = new_span<i32>(cuts);
  grid.areas = new_span<i64>(runs + 1);
  grid.reached = reserved_rows<Reached>(runs + 1);
}

static Tree new_tree(const Sizes& sizes) {
  const i64 n = sizes.states, p = sizes.pieces;
  const i64 heap = sizes.decisions * (n / 4 + 8);
  Tree tree;
  tree.counters = new_one<Counters>();
  tree.budget = zeroes<f64>(1);
  tree.decisions = new_table<i64>(n, p);
  tree.costs = new_span<f64>(n);
  tree.preferences = new_span<f64>(n);
  tree.depths = new_span<i64>(n);
  tree.optima = new_span<Optimum>(MOST_OPTIMA);
  tree.places = new_cube<f64>(MOST_OPTIMA, 2, sizes.variables);
  tree.begun = new_span<i64>(p);
  tree.heap = reserved_rows<HeapEntry>(heap);
  tree.heap_cost = new_span<f64>(heap);
  tree.refused = new_span<u64>(MOST_REFUSED / 2);
  tree.refused_at = new_span<i32>(MOST_REFUSED / 2);
  tree.refused_table = new_span<i32>(MOST_REFUSED);
  tree.found = new_span<i64>(sizes.decisions);
  tree.found_cost = new_span<f64>(sizes.decisions);
  tree.trial = new_span<i64>(p);
  tree.moves = reserved_rows<Move>(MOST_MOVES);
  tree.move_cost = new_span<f64>(MOST_MOVES);
  tree.shifted = new_span<i64>(p);
  return tree;
}

template <class T> static i32 address(T* of) { return static_cast<i32>(reinterpret_cast<u64>(of)); }
template <class T> static Shown show(const Span<T>& own) { return {address(own.data), own.size, 0}; }
template <class T> static Shown show(const One<T>& own) { return {address(own.data), own.size, 0}; }
template <class T> static Shown show(const Rows<T>& own) { return {address(own.data), own.size, own.columns}; }
template <class T> static Shown show(const Table<T>& own) { return {address(own.data), own.rows, own.columns}; }

static void show_all(Desk& desk) {
  const Room& room = desk.engine.room;
  const Work& work = desk.engine.work;
  const Nodes& nodes = desk.engine.nodes;
  const Tree& tree = desk.engine.tree;
  const Shown shown[] = {
      show(room.space), show(room.pieces), show(room.candidates),
      show(work.counts), show(work.sizes), show(work.low), show(work.high), show(work.anchor_weight), show(work.anchor_at),
      show(work.pulls), show(work.pull_costs), show(work.rows), show(work.parts), show(work.choice_size), show(work.choice_parts),
      show(work.options), show(work.wide), show(work.body_part), show(work.rotation),
      show(nodes.best), show(nodes.best_cost), show(nodes.result),
      show(desk.engine.grid.positions),
      show(tree.counters), show(tree.budget), show(tree.decisions), show(tree.found), show(tree.found_cost),
      show(desk.decisions), show(desk.fates), show(desk.limits), show(desk.group), show(desk.report),
      show(desk.taken),
  };
  static_assert(sizeof(shown) == SHOWN * sizeof(Shown));
  for (i32 k = 0; k < SHOWN; k++) desk.shown[k] = shown[k];
}

Desk* new_desk(const Room& room, const Sizes& sizes) {
  Desk& desk = *static_cast<Desk*>(arena::zeroed(sizeof(Desk)));
  desk.engine.room = room;
  desk.engine.work = new_work(sizes);
  desk.engine.grid = new_grid(sizes);
  desk.decisions = new_span<i64>(room.pieces.size);
  desk.fates = zeroes<i64>(room.pieces.size);
  desk.limits = zeroes<i64>(sizeof(SearchLimits) / 8);
  desk.group = zeroes<i64>(sizeof(Group) / 8);
  desk.report = zeroes<i64>(1);
  desk.taken = reserved_rows<DifferenceRow>(2 * sizes.choices + SPARE_PATH);
  desk.added = zeroes<f64>(1);
  add_cells(desk.engine.grid, sizes);
  desk.engine.work.wide = reserved_rows<DifferenceRow>(MOST_WIDE);
  desk.engine.programs = new_span<Program>(2);
  for (Program& program : desk.engine.programs) program = new_program(sizes);
  desk.engine.nodes = new_nodes(sizes);
  desk.engine.tree = new_tree(sizes);
  show_all(desk);
  return &desk;
}

}  // namespace placement
