#include "placement/nodes.hpp"

namespace placement {

void sort_family(const Nodes& nodes, i64 count) {
  for (i64 k = 1; k < count; k++) {
    const Child own = nodes.family[k];
    i64 at = k;
    for (; at > 0 && nodes.family[at - 1].key > own.key; at--) nodes.family[at] = nodes.family[at - 1];
    nodes.family[at] = own;
  }
}

void open_family(const Engine& engine, i64 parent, i64 count) {
  const Nodes& nodes = engine.nodes;
  for (i64 k = count - 1; k >= 0; k--) {
    const i64 slot = nodes.family[k].slot, pick = nodes.state->picked++;
    const i64 option = nodes.last_pick[slot];
    copy_axis(engine, parent, slot, 1 - row_of(engine.work, option).axis);  // the other one was solved
    nodes.pick_option[pick] = option;
    nodes.pick_before[pick] = nodes.last_pick[parent];
    nodes.last_pick[slot] = pick;
    nodes.stack[nodes.state->open++] = slot;
  }
}

void cheapest_on_top(const Nodes& nodes) {
  if (nodes.state->spare < nodes.spare.size / 2) return;
  const i64 top = nodes.state->open - 1;
  i64 found = top, lowest = in_steps(nodes.total(nodes.stack[top]));
  for (i64 k = top - 1; k >= 0; k--) {
    const i64 key = in_steps(nodes.total(nodes.stack[k]));
    if (key < lowest) {
      found = k;
      lowest = key;
    }
  }
  swap(nodes.stack[top], nodes.stack[found]);
}

}  // namespace placement
