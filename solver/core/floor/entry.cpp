// What the host calls of the free floor, whatever the stage.
#include "floor/free_floor.hpp"
#include "floor/nearest.hpp"
#include "plain/tables.hpp"

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

}  // namespace

extern "C" {

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
