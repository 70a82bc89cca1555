// What the host calls of the free floor, whatever the stage.
#include "floor/free_floor.hpp"
#include "floor/nearest.hpp"
#include "plain/tables.hpp"
#include "plain/told_body.hpp"

namespace {

struct NearestHeader {
  Rect own;  // where it is wished, and where the answer goes
  Rect area;
  i64 reach;
  i32 blocks;
  i32 unused;
};

struct FloorHeader {
  Rect clear;
  i64 robot;
  i32 bodies, doors, goals;
  i32 outer;  // how many of the first doors are joined outside
};

constexpr i64 FLAT_MM = 20;  // what is no higher is no body, one stands on it

// Adds what bodies take up between two heights, mm; `loose`: but for what rests on something, hangs, or is above the floor.
void add_taken(List<Rect>& taken, Bytes bodies, f64 low, f64 high, bool loose) {
  for (const ToldBody& one : Reader(bodies.data, bodies.size).take<ToldBody>(static_cast<i32>(bodies.size / sizeof(ToldBody)))) {
    const f64 bottom = static_cast<f64>(one.low) / 1000, top = bottom + static_cast<f64>(one.height) / 1000;
    const bool rests = one.on >= 0 || one.hangs() || one.low != 0;
    if (one.height <= FLAT_MM || (loose && rests)) continue;
    if (bottom * 1000 < high && low < top * 1000) taken.add(one.rect);
  }
}

}  // namespace

extern "C" {

// Tells what furniture and small things take up between two heights, mm. `loose`: of the things, those alone that stand on the floor.
__attribute__((export_name("taken_between"))) i64 entry_taken_between(
    u8* furniture, i64 furniture_size, u8* things, i64 things_size, f64 low, f64 high, i32 loose) {
  List<Rect> taken;
  add_taken(taken, {furniture, furniture_size}, low, high, false);
  add_taken(taken, {things, things_size}, low, high, loose != 0);
  return told(as_bytes(taken.all()));
}

// Writes the nearest place over the wish; tells whether there is one.
__attribute__((export_name("nearest_place"))) i32 entry_nearest_place(u8* data, i64 size) {
  Reader reader(data, size);
  NearestHeader& header = reader.take<NearestHeader>(1)[0];
  const NearestPlace nearest = nearest_place(header.own, header.area, reader.take<Rect>(header.blocks), header.reach);
  if (nearest.found) header.own = nearest.place;
  return nearest.found;
}

__attribute__((export_name("connects"))) i32 entry_connects(u8* data, i64 size) {
  const arena::Scope scope;
  Reader reader(data, size);
  const FloorHeader& header = reader.take<FloorHeader>(1)[0];
  const Span<Rect> bodies = reader.take<Rect>(header.bodies);
  const Span<Doorway> doors = reader.take<Doorway>(header.doors);
  FreeFloor floor(header.clear, header.robot, doors, reader.take<Goal>(header.goals), header.outer);
  for (const Rect& body : bodies) floor.add(body);
  return floor.connects();
}
}
