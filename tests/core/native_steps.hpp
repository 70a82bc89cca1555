// Makes rooms natively, and tells what is made of them.
//
// Of a room: its request; MakingAsked. Told of it: the answer, the final problem as a house's, and what is said of its optimum.
#pragma once

#include "native_io.hpp"

#include "placement/house.hpp"
#include "placement/making.hpp"

namespace placement {

template <class T> static void write(const T* from, i64 count) { fwrite(from, sizeof(T), static_cast<unsigned long>(count), stdout); }

// Writes the final problem of what was found, the same as a house's, and what is said of the optimum itself as its answer.
static void confirm_found(const Desk& desk) {
  const FinalProblem* problem = final_problem(desk);
  const f64* linear = reinterpret_cast<const f64*>(problem + 1);
  const f64* start = linear + problem->columns;
  const f64* multipliers = start + problem->columns + 2 * problem->rows;
  write(&problem->size, problem->size);
  const i64 problems[] = {static_cast<i64>(reinterpret_cast<u64>(problem))};
  const HouseProblem* house = join({problems, 1});
  write(reinterpret_cast<const u8*>(house), house->bytes);
  write(judge({problems, 1}, start, multipliers), 1);
  const Holding* found = holding(desk, multipliers);
  write(reinterpret_cast<const HoldingRow*>(found + 1), found->rows);
}

// Makes the next room of a file; false at its end.
static bool make_next(FILE* file) {
  const arena::Scope scope;
  const Bytes request = read_bytes(file);
  if (request.data == nullptr) return false;
  const MakingAsked& asked = read_row<MakingAsked>(file);
  const SentRoom sent = room_of(reinterpret_cast<RoomRequest*>(request.data));
  Making making(sent.room, sent.doorways, asked);
  making.make();
  Writer writer(making.size());
  making.put(writer);
  const Bytes answer = writer.written();
  write(answer.data, answer.size);
  if (!making.made().failed) confirm_found(*making.whole().desk);
  return true;
}

}  // namespace placement
