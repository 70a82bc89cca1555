// Arranges rooms natively, step by step, and tells what each step made of them.
//
// Of a room: its request; RoomLimits; whether to walk, whether with wide ways (8 bytes each), the budget (a float). Told of it: decisions,
// what is said of WholeRoom, its pieces' numbers, those left out, the cost, positions along x and z, whether they may be walked between;
// the final problem and what is said of its optimum; and what becomes of that in whole millimetres.
#pragma once

#include "native_io.hpp"

#include "placement/confirm.hpp"
#include "placement/grid.hpp"
#include "placement/house.hpp"
#include "placement/settle.hpp"
#include "placement/whole.hpp"

namespace placement {

template <class T> static void write(const T* from, i64 count) { fwrite(from, sizeof(T), static_cast<unsigned long>(count), stdout); }

// Hands over what was found, and writes the final problem, the same as a house's, and what is said of the optimum itself as its answer.
static void confirm_found(const Desk& desk) {
  hand_over(desk);
  const FinalProblem* problem = final_problem(desk);
  const f64* linear = reinterpret_cast<const f64*>(problem + 1);
  const f64* start = linear + problem->columns;
  const f64* multipliers = start + problem->columns + 2 * problem->rows;
  write(&problem->size, problem->size);
  const i64 problems[] = {static_cast<i64>(reinterpret_cast<u64>(problem))};
  const HouseProblem* house = join({problems, 1});
  write(reinterpret_cast<const u8*>(house), house->bytes);
  write(judge({problems, 1}, start, multipliers), 1);
  const Holding* found = confirm(desk, start, multipliers);
  write(reinterpret_cast<const HoldingRow*>(found + 1), found->rows);
}

// Puts what was found on whole millimetres, tidied, and writes what became of it, positions along x and z, and what tidying cost.
static void settle_found(const Desk& desk, bool walk) {
  const i64 settled = static_cast<i64>(settle(desk, walk, true));
  write(&settled, 1);
  for (i64 axis = 0; axis < 2; axis++) write(desk.engine.grid.positions.row(axis).data, desk.engine.work.sizes[axis]);
  write(desk.added.data, 1);
}

struct Asked {
  i64 walk, wide;
  f64 budget;
};

// Arranges the next room of a file; false at its end.
static bool arrange_next(FILE* file) {
  const arena::Scope scope;
  const Bytes request = read_bytes(file);
  if (request.data == nullptr) return false;
  const RoomLimits& limits = read_row<RoomLimits>(file);
  Asked asked = read_row<Asked>(file);
  f64 spent = 0;
  const Room room = room_of(reinterpret_cast<RoomRequest*>(request.data));
  const WholeRoom whole =
      asked.wide != 0 ? arrange_wide(room, limits, asked.budget, spent) : arrange_whole(room, limits, asked.budget, asked.walk != 0);
  const Desk* desk = whole.desk;
  const Engine& engine = desk->engine;
  write(desk->decisions.data, desk->decisions.size);
  const i64 said[] = {whole.walk, whole.complete, whole.proven, whole.best, whole.solves, whole.ways};
  write(said, 6);
  write(whole.asked.pieces.data, whole.asked.pieces.size);
  write(whole.left_out.begin(), whole.left_out.size());
  write(engine.nodes.best_cost.data, 1);
  if (engine.nodes.result->found) {
    for (i64 axis = 0; axis < 2; axis++) write(engine.nodes.best.row(axis).data, engine.work.sizes[axis]);
    const i64 walked = walkable(engine.room, engine.work, engine.grid, engine.grid.positions);
    write(&walked, 1);
    confirm_found(*desk);
    settle_found(*desk, walked != 0);
  }
  return true;
}

}  // namespace placement
