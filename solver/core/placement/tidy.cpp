#include "placement/tidy.hpp"

#include "placement/gaps.hpp"
#include "placement/grid.hpp"
#include "placement/pull.hpp"
#include "plain/rounding.hpp"

namespace placement {

constexpr DifferenceRow VOID = {0, ORIGIN, ORIGIN, 0};  // a row that always holds

static bool is_person(const Part& part) { return part.stand != 0 && part.stand != EMPTY_FLOOR; }

// Tells whether a variable places a body, or is none.
static bool is_of_bodies(const Work& work, i64 axis, i64 variable) {
  if (variable == ORIGIN) return true;
  for (i64 k = 0; k < work.counts->parts; k++) {
    if (!is_person(work.parts[k]) && work.parts[k].variable[axis] == variable) return true;
  }
  return false;
}

// Returns a problem with rows and choices of its own, those of persons' squares made void: the walk tells whether they can use everything.
static Work without_persons(const Work& work) {
  Work alone = work;
  alone.rows = reserved_rows<DifferenceRow>(work.counts->rows);
  alone.choice_size = reserved<i64>(static_cast<i32>(work.counts->choices));
  alone.options = reserved_rows<DifferenceRow>(OPTIONS * work.counts->choices);
  for (i64 k = 0; k < work.counts->rows; k++) {
    const DifferenceRow& row = work.rows[k];
    alone.rows[k] = is_of_bodies(work, row.axis, row.i) && is_of_bodies(work, row.axis, row.j) ? row : VOID;
  }
  for (i64 c = 0; c < work.counts->choices; c++) {
    const i64 first = work.choice_parts[c].part[0], second = work.choice_parts[c].part[1];
    if (is_person(work.parts[first]) || (second >= 0 && is_person(work.parts[second]))) {
      alone.choice_size[c] = 1;
      alone.options[OPTIONS * c] = VOID;
      continue;
    }
    alone.choice_size[c] = work.choice_size[c];
    for (i64 k = OPTIONS * c; k < OPTIONS * c + work.choice_size[c]; k++) alone.options[k] = work.options[k];
  }
  return alone;
}

constexpr i64 BESIDE_MM = 30;  // how far apart closed pieces are left, as the backs are from the walls; else they touch
constexpr f64 MOST_COST = 0.8;  // what tidying a room may cost in all: what moves a kitchen's run of five pieces by 9 cm
constexpr i64 TOGETHER = 2;  // slides of which only the last must leave fewer slivers, and the room walkable
constexpr i64 MOST_TRIES = 100;  // slides tried in a room
constexpr i64 WALL_MM = 1000;  // thickness of the boxes that stand for the walls; any will do

// Variables that move together along an axis, by how much, and by how much more the terms then cost.
struct Slide {
  f64 cost;
  i64 axis, by;
  Span<i64> variables;
};

// Positions with fewer slivers; `data` is null where there are none.
struct Better {
  Table<i64> positions;
  f64 cost;
};

// Positions with as many slivers as before.
struct Equal {
  Table<i64> positions;
  List<Gap> gaps;
  f64 cost;
};

static bool is_equal(const Span<i64>& a, const Span<i64>& b) {
  if (a.size != b.size) return false;
  for (i32 k = 0; k < a.size; k++) {
    if (a[k] != b[k]) return false;
  }
  return true;
}

// Orders slides: the cheapest first, then by axis, way and variables.
static bool goes_first(const Slide& a, const Slide& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  if (a.axis != b.axis) return a.axis < b.axis;
  if (a.by != b.by) return a.by < b.by;
  for (i32 k = 0; k < a.variables.size && k < b.variables.size; k++) {
    if (a.variables[k] != b.variables[k]) return a.variables[k] < b.variables[k];
  }
  return a.variables.size < b.variables.size;
}

static Table<i64> copied(const Table<i64>& positions) {
  const Table<i64> copy = {reserved<i64>(positions.rows * positions.columns).data, positions.rows, positions.columns};
  for (i32 k = 0; k < positions.rows * positions.columns; k++) copy.data[k] = positions.data[k];
  return copy;
}

static Table<i64> slid(const Table<i64>& positions, const Slide& slide) {
  const Table<i64> found = copied(positions);
  for (const i64 v : slide.variables) found.at(slide.axis, v) += slide.by;
  return found;
}

// What of a room tidying needs: the bodies on the floor, what is fixed, and what goes along with a variable.
class Tidier {
 public:
  explicit Tidier(const Desk& desk);
  f64 run(const Table<i64>& positions);

 private:
  void find_terms();
  bool is_person_alone(i64 axis, i64 variable) const;
  Span<Box> boxes(const Table<i64>& p) const;
  bool are_wished_together(const Gap& gap) const;
  List<Gap> gaps_at(const Table<i64>& p) const;
  bool holds_alone(const Table<i64>& p);
  Span<i64> moving_with(const Span<u8>& moved, i64 axis) const;
  bool is_within(const Table<i64>& p, const Slide& slide) const;
  f64 cost(const Table<i64>& p, const Slide& slide) const;
  void add_slides(List<Slide>& slides, const Table<i64>& p, const Gap& gap, bool ahead, const Span<i64>& moving) const;
  List<Slide> slides(const Table<i64>& p, const List<Gap>& gaps) const;
  Better better(const Table<i64>& p, const List<Gap>& gaps, i64 before, f64 most, i64 together);

  const Desk& desk_;
  const Work& work_;
  List<i64> bodies_;  // parts of the bodies on the floor
  List<ChoiceParts> carried_;  // parts of a body and of what is attached to it
  List<Box> fixed_;
  List<PullRow> terms_;  // anchors are pulls from the origin
  List<PullCost> term_costs_;
  i64 tries_ = MOST_TRIES;
  Work alone_ = {};  // laid out when it is first asked
};

Tidier::Tidier(const Desk& desk) : desk_(desk), work_(desk.engine.work) {
  const Room& room = desk.engine.room;
  for (i64 piece = 0; piece < room.pieces.size; piece++) {
    if (work_.taken_candidate[piece] == ABSENT || room.pieces[piece].empty) continue;
    const CandidateRow& own = room.candidates[work_.taken_candidate[piece]];
    const i64 part = work_.body_part[piece];
    if (own.on == ABSENT && own.under == ABSENT) bodies_.add(part);
    if (own.parent != ABSENT) carried_.add({{work_.body_part[own.parent], part}});
  }
  const i64 x0 = room.space->low[0], z0 = room.space->low[1], x1 = room.space->high[0], z1 = room.space->high[1];
  fixed_.add({{x0 - WALL_MM, z0}, {x0, z1}});
  fixed_.add({{x1, z0}, {x1 + WALL_MM, z1}});
  fixed_.add({{x0, z0 - WALL_MM}, {x1, z0}});
  fixed_.add({{x0, z1}, {x1, z1 + WALL_MM}});
  for (i64 k = 0; k < room.zones.size; k++) {
    const Zone& zone = room.zones[k];
    if (zone.is_wall) fixed_.add({{zone.low[0], zone.low[1]}, {zone.high[0], zone.high[1]}});
  }
  find_terms();
}

// Tells whether a variable places persons and no body: where they stand costs nothing here.
bool Tidier::is_person_alone(i64 axis, i64 variable) const {
  bool found = false;
  for (i64 k = 0; k < work_.counts->parts; k++) {
    if (work_.parts[k].variable[axis] != variable) continue;
    if (work_.parts[k].stand == 0) return false;
    found = true;
  }
  return found;
}

void Tidier::find_terms() {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work_.sizes[axis]; v++) {
      const f64 weight = work_.anchor_weight.at(axis, v);
      if (!(weight > 0) || is_person_alone(axis, v)) continue;
      terms_.add({axis, ORIGIN, v});
      term_costs_.add({work_.anchor_at.at(axis, v), weight});
    }
  }
  for (i64 k = 0; k < work_.counts->pulls; k++) {
    const PullRow& pull = work_.pulls[k];
    if (is_person_alone(pull.axis, pull.j)) continue;
    terms_.add(pull);
    term_costs_.add(work_.pull_costs[k]);
  }
}

// The bodies' footprints, then what is fixed.
Span<Box> Tidier::boxes(const Table<i64>& p) const {
  const Span<Box> found = reserved<Box>(bodies_.size() + fixed_.size());
  for (i32 k = 0; k < bodies_.size(); k++) {
    const Part& body = work_.parts[bodies_[k]];
    for (i64 axis = 0; axis < 2; axis++) {
      found[k].low[axis] = p.at(axis, body.variable[axis]) + body.offset[axis];
      found[k].high[axis] = found[k].low[axis] + body.extent[axis];
    }
  }
  for (i32 k = 0; k < fixed_.size(); k++) found[bodies_.size() + k] = fixed_[k];
  return found;
}

// Tells whether the bodies at the ends of a gap are wished where they touch, as those of a run are.
bool Tidier::are_wished_together(const Gap& gap) const {
  if (gap.low >= bodies_.size() || gap.high >= bodies_.size()) return false;
  f64 apart = 0.0;
  const i64 ends[] = {gap.low, gap.high};
  for (const i64 end : ends) {
    const Part& body = work_.parts[bodies_[end]];
    const i64 v = body.variable[gap.axis];
    if (!(work_.anchor_weight.at(gap.axis, v) > 0)) return false;
    const i64 edge = body.offset[gap.axis] + (end == gap.low ? body.extent[gap.axis] : 0);
    apart += (end == gap.low ? -1 : 1) * (work_.anchor_at.at(gap.axis, v) * 1000 + static_cast<f64>(edge));
  }
  return -1 < apart && apart < 1;
}

// The gaps beside bodies; those between bodies that are wished together have to be closed however narrow they are.
List<Gap> Tidier::gaps_at(const Table<i64>& p) const {
  List<Gap> found = gaps_between(boxes(p), bodies_.size());
  for (Gap& gap : found) {
    if (are_wished_together(gap)) gap.contact = 1;
  }
  return found;
}

// Tells whether the rules hold without persons' squares: whether all can be used is the walk's to say.
bool Tidier::holds_alone(const Table<i64>& p) {
  if (!alone_.rows.data) alone_ = without_persons(work_);
  return holds(alone_, p);
}

// The variables, in order, that move when boxes do: those of the bodies among them, and of all that is attached to these.
Span<i64> Tidier::moving_with(const Span<u8>& moved, i64 axis) const {
  const i32 size = static_cast<i32>(work_.sizes[axis]);
  const Span<u8> moves = zeroes<u8>(size);
  for (i32 k = 0; k < bodies_.size(); k++) {
    if (moved[k]) moves[work_.parts[bodies_[k]].variable[axis]] = 1;
  }
  for (const ChoiceParts& both : carried_) {
    if (moves[work_.parts[both.part[0]].variable[axis]]) moves[work_.parts[both.part[1]].variable[axis]] = 1;
  }
  const Span<i64> found = reserved<i64>(size);
  i32 count = 0;
  for (i32 v = 0; v < size; v++) {
    if (moves[v]) found[count++] = v;
  }
  return {found.data, count};
}

bool Tidier::is_within(const Table<i64>& p, const Slide& slide) const {
  for (const i64 v : slide.variables) {
    const i64 at = p.at(slide.axis, v) + slide.by;
    if (at < work_.low.at(slide.axis, v) || at > work_.high.at(slide.axis, v)) return false;
  }
  return true;
}

static f64 squared(f64 x) { return x * x; }

// How much more the terms cost once variables have moved.
f64 Tidier::cost(const Table<i64>& p, const Slide& slide) const {
  arena::Scope scope;
  const i32 size = static_cast<i32>(work_.sizes[slide.axis]);
  const Span<f64> before = reserved<f64>(size), after = reserved<f64>(size);
  for (i32 v = 0; v < size; v++) before[v] = after[v] = static_cast<f64>(p.at(slide.axis, v)) / 1000;
  for (const i64 v : slide.variables) after[v] += static_cast<f64>(slide.by) / 1000;
  f64 more = 0.0;
  for (i32 k = 0; k < terms_.size(); k++) {
    const PullRow& term = terms_[k];
    if (term.axis != slide.axis) continue;
    const auto [offset, weight] = term_costs_[k];
    const bool anchored = term.i == ORIGIN;
    const f64 was = before[term.j] - (anchored ? 0.0 : before[term.i]) - offset;
    const f64 is = after[term.j] - (anchored ? 0.0 : after[term.i]) - offset;
    more += weight * squared(is) - weight * squared(was);
  }
  return rounded_9(more);
}

// Adds the ways to close or open a gap by moving variables at one of its ends, those within all bounds.
void Tidier::add_slides(List<Slide>& slides, const Table<i64>& p, const Gap& gap, bool ahead, const Span<i64>& moving) const {
  const i64 ways[] = {gap.wide - (gap.contact < BESIDE_MM ? 0 : BESIDE_MM), gap.wide, gap.wide - REACH_MM};
  for (const i64 way : ways) {
    Slide slide = {0.0, gap.axis, ahead ? way : -way, moving};
    if (!is_within(p, slide)) continue;
    bool known = false;
    for (const Slide& other : slides) {
      known |= other.axis == slide.axis && other.by == slide.by && is_equal(other.variables, slide.variables);
    }
    if (known) continue;
    slide.cost = cost(p, slide);
    slides.add(slide);
  }
}

// The slides that close or open a sliver, the cheapest first.
List<Slide> Tidier::slides(const Table<i64>& p, const List<Gap>& gaps) const {
  List<Slide> found;
  const i32 count = bodies_.size() + fixed_.size();
  for (const Gap& gap : gaps) {
    if (!gap.is_sliver()) continue;
    for (i32 end = 0; end < 2; end++) {
      const i64 body = end == 0 ? gap.low : gap.high, other = end == 0 ? gap.high : gap.low;
      if (body >= bodies_.size()) continue;
      const Span<u8> only = zeroes<u8>(count);
      only[body] = 1;
      const Span<i64> alone = moving_with(only, gap.axis);
      const Span<i64> with_touching = moving_with(touching(gaps, count, gap.axis, body, other), gap.axis);
      add_slides(found, p, gap, end == 0, alone);
      if (!is_equal(alone, with_touching)) add_slides(found, p, gap, end == 0, with_touching);
    }
  }
  stable_sort(found.all(), goes_first);
  return found;
}

// Positions with fewer slivers than before and what they cost more than p: one slide from p, or several together.
Better Tidier::better(const Table<i64>& p, const List<Gap>& gaps, i64 before, f64 most, i64 together) {
  List<Equal> equal;
  for (const Slide& slide : slides(p, gaps)) {
    tries_--;
    if (tries_ < 0 || slide.cost > most) continue;
    const Table<i64> trial = slid(p, slide);
    if (!holds_alone(trial)) continue;
    const List<Gap> left = gaps_at(trial);
    const i64 count = count_slivers(left);
    if (count < before) {
      if (walkable(desk_.engine.room, work_, desk_.engine.grid, trial)) return {trial, slide.cost};
    } else if (together > 1 && count == before) {
      equal.add({trial, left, slide.cost});
    }
  }
  for (const Equal& own : equal) {
    const Better further = better(own.positions, own.gaps, before, most - own.cost, together - 1);
    if (further.positions.data) return {further.positions, own.cost + further.cost};
  }
  return {};
}

f64 Tidier::run(const Table<i64>& positions) {
  Table<i64> p = copied(positions);
  f64 spent = 0.0;
  while (true) {  // each slide leaves fewer slivers
    const List<Gap> gaps = gaps_at(p);
    const Better found = better(p, gaps, count_slivers(gaps), MOST_COST - spent, TOGETHER);
    if (!found.positions.data) break;
    p = found.positions;
    spent += found.cost;
  }
  for (i32 k = 0; k < p.rows * p.columns; k++) positions.data[k] = p.data[k];
  return spent;
}

f64 tidy(const Desk& desk, const Table<i64>& positions) {
  arena::Scope scope;
  return Tidier(desk).run(positions);
}

}  // namespace placement
