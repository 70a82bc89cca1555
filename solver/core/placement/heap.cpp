#include "placement/heap.hpp"

#include "placement/nodes.hpp"

namespace placement {

static bool before(const Tree& tree, i64 a, i64 b) {
  const HeapEntry &one = tree.heap[a], &two = tree.heap[b];
  if (one.rank != two.rank) return one.rank < two.rank;
  if (one.bound != two.bound) return one.bound < two.bound;
  if ((one.decision == EXPANDED) != (two.decision == EXPANDED)) return one.decision == EXPANDED;
  return one.age < two.age;
}

static void exchange(const Tree& tree, i64 a, i64 b) {
  swap(tree.heap[a], tree.heap[b]);
  swap(tree.heap_cost[a], tree.heap_cost[b]);
}

static void sift_up(const Tree& tree, i64 at) {
  while (at > 0 && before(tree, at, (at - 1) / 2)) {
    exchange(tree, at, (at - 1) / 2);
    at = (at - 1) / 2;
  }
}

bool push(const Tree& tree, f64 bound, i64 state, i64 decision, f64 cost, i64 depth) {
  Counters& counters = *tree.counters.data;
  const i64 at = counters.heaped;
  if (at >= tree.heap.size) return false;
  tree.heap[at] = {counters.diving ? -depth : 0, in_steps(bound), counters.order, state, decision};
  tree.heap_cost[at] = cost;
  counters.order++;
  counters.heaped++;
  sift_up(tree, at);
  return true;
}

void pop(const Tree& tree) {
  const i64 last = tree.counters->heaped - 1;
  exchange(tree, 0, last);
  tree.counters->heaped = last;
  i64 at = 0;
  while (true) {
    i64 first = at;
    for (i64 child = 2 * at + 1; child < least(2 * at + 3, last); child++) {
      if (before(tree, child, first)) first = child;
    }
    if (first == at) return;
    exchange(tree, at, first);
    at = first;
  }
}

void dive(const Tree& tree) {
  tree.counters->diving = 1;
  tree.counters->closed = 0;
  for (i64 k = 0; k < tree.counters->heaped; k++) {
    tree.heap[k].rank = -tree.depths[tree.heap[k].state];
    sift_up(tree, k);
  }
}

}  // namespace placement
