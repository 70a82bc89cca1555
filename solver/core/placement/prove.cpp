#include "placement/prove.hpp"

#include "placement/grid.hpp"
#include "placement/narrow.hpp"

namespace placement {

static ProofNode node_at(const ProofNodes& nodes, i64 k) {
  return {nodes.low.block(k), nodes.high.block(k), nodes.picks.row(k), nodes.refused.row(k)};
}

// Tells whether an option of a choice is neither refused nor settled by the intervals.
static bool is_open(const Work& work, const ProofNode& node, i64 choice, i64 k) {
  return !(node.refused[choice] & (1LL << k)) && holds_in(node, work.options[OPTIONS * choice + k]) == Holds::DEPENDS;
}

// The undecided choice with the fewest options left, of these the one between the largest parts; -1 where all are decided.
static i64 open_choice(const Work& work, const ProofNode& node) {
  i64 best = -1, fewest = 9, largest = 0;
  for (i64 choice = 0; choice < work.counts->choices; choice++) {
    if (node.picks[choice] != UNDECIDED) continue;
    i64 left = 0, size = 0;
    for (i64 k = 0; k < work.choice_size[choice]; k++) left += is_open(work, node, choice, k);
    for (const i64 part : work.choice_parts[choice].part) {
      if (part >= 0) size += work.parts[part].extent[0] * work.parts[part].extent[1];
    }
    if (left < fewest || (left == fewest && size > largest)) {
      best = choice;
      fewest = left;
      largest = size;
    }
  }
  return best;
}

// A variable of one axis, or none (-1).
struct Variable {
  i64 axis, number;
};

// The body's variable with the widest interval; none where all are single millimetres.
static Variable widest(const Work& work, const ProofNode& node) {
  Variable best = {0, -1};
  i64 width = 0;
  for (i64 k = 0; k < work.counts->parts; k++) {
    if (work.parts[k].stand != 0) continue;
    for (i64 axis = 0; axis < 2; axis++) {
      const i64 v = work.parts[k].variable[axis];
      const i64 own = node.high.at(axis, v) - node.low.at(axis, v);
      if (own > width) {
        best = {axis, v};
        width = own;
      }
    }
  }
  return best;
}

static void copy(const Work& work, const ProofNode& from, const ProofNode& to) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      to.low.at(axis, v) = from.low.at(axis, v);
      to.high.at(axis, v) = from.high.at(axis, v);
    }
  }
  for (i64 choice = 0; choice < work.counts->choices; choice++) {
    to.picks[choice] = from.picks[choice];
    to.refused[choice] = from.refused[choice];
  }
}

// Replaces a node by one for every option left of a choice, each without what those before it hold; returns the nodes' number.
static i64 part_by_choice(const Work& work, const ProofNodes& nodes, i64 number, i64 choice) {
  const ProofNode node = node_at(nodes, number);
  i64 first = -1, last = number;
  for (i64 k = 0; k < work.choice_size[choice]; k++) {
    if (!is_open(work, node, choice, k)) continue;
    if (first < 0) {
      first = k;
      continue;
    }
    const ProofNode child = node_at(nodes, ++last);
    copy(work, node, child);
    child.picks[choice] = k;
    child.refused[choice] |= (1LL << k) - 1;
  }
  node.picks[choice] = first;
  return last + 1;
}

// Replaces a node by its two halves along an interval; returns how many nodes there are.
static i64 part_by_interval(const Work& work, const ProofNodes& nodes, i64 number, const Variable& at) {
  const ProofNode node = node_at(nodes, number), other = node_at(nodes, number + 1);
  const i64 middle = floor_div(node.low.at(at.axis, at.number) + node.high.at(at.axis, at.number), 2);
  copy(work, node, other);
  node.high.at(at.axis, at.number) = middle;
  other.low.at(at.axis, at.number) = middle + 1;
  return number + 2;
}

// Brings every part to the nearer end of its interval, one after the other; tells whether all rows and choices still hold.
static bool push_to_walls(const Room& room, const Work& work, const ProofNode& node) {
  const SpaceRow& space = *room.space.data;
  bool all = true;
  for (i64 k = 0; k < work.counts->parts; k++) {
    const Part& part = work.parts[k];
    for (i64 axis = 0; axis < 2; axis++) {
      i64& low = node.low.at(axis, part.variable[axis]);
      i64& high = node.high.at(axis, part.variable[axis]);
      if (low >= high) continue;
      if (low + high + 2 * part.offset[axis] + part.extent[axis] < space.low[axis] + space.high[axis]) {
        high = low;
      } else {
        low = high;
      }
      all &= narrow(work, node);
    }
  }
  return all;
}

// Tells whether a placement of a node whose choices are decided is walkable, of a few: all near a wall, or all to one end.
static bool is_somewhere(const Engine& engine, const ProofNodes& nodes, i64 number) {
  const Work& work = engine.work;
  const ProofNode node = node_at(nodes, number), trial = node_at(nodes, number + 1);
  for (i64 sample = 0; sample < 3; sample++) {
    copy(work, node, trial);
    const bool holds = sample > 0 || push_to_walls(engine.room, work, trial);
    for (i64 axis = 0; axis < 2; axis++) {
      for (i64 v = 0; v < work.sizes[axis]; v++) {
        const i64 at = sample == 2 ? trial.high.at(axis, v) : trial.low.at(axis, v);
        trial.low.at(axis, v) = trial.high.at(axis, v) = engine.grid.positions.at(axis, v) = at;
      }
    }
    if (holds && narrow(work, trial) && walkable(engine.room, work, engine.grid, engine.grid.positions)) return true;
  }
  return false;
}

// Makes the first node: all that the bounds leave, nothing decided.
static void open_root(const Work& work, const ProofNode& root) {
  for (i64 axis = 0; axis < 2; axis++) {
    for (i64 v = 0; v < work.sizes[axis]; v++) {
      root.low.at(axis, v) = work.low.at(axis, v);
      root.high.at(axis, v) = work.high.at(axis, v);
    }
  }
  for (i64& pick : root.picks) pick = UNDECIDED;
  for (i64& bits : root.refused) bits = 0;
}

Verdict prove(const Engine& engine, const ProofNodes& nodes, i64& allowed) {
  const Work& work = engine.work;
  open_root(work, node_at(nodes, 0));
  Verdict verdict = Verdict::IMPOSSIBLE;
  i64 count = 1;
  while (count > 0) {
    if (allowed <= 0 || count + 4 > nodes.picks.rows) return Verdict::UNKNOWN;
    allowed--;
    const i64 number = count - 1;
    const ProofNode node = node_at(nodes, number);
    if (!narrow(work, node) || !may_be_walkable(engine.room, work, engine.grid, node.low, node.high)) {
      count--;
      continue;
    }
    const i64 choice = open_choice(work, node);
    if (choice >= 0) {
      count = part_by_choice(work, nodes, number, choice);
      continue;
    }
    if (is_somewhere(engine, nodes, number)) return Verdict::POSSIBLE;
    const Variable at = widest(work, node);
    if (at.number < 0) {
      verdict = Verdict::UNKNOWN;
      count--;
      continue;
    }
    count = part_by_interval(work, nodes, number, at);
  }
  return verdict;
}

}  // namespace placement
