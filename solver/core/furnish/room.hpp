// The room to be furnished: its clear rectangle, openings and zones, and what of its walls is taken.
#pragma once

#include "furnish/room_type.hpp"
#include "plain/intervals.hpp"

namespace furnish {

// An opening: its kind, its wall, its stretch along it, and the wall line's coordinate across, mm.
struct Opened {
  Opening kind;
  Wall wall;
  Interval stretch;
  i64 across;

  i64 middle() const { return stretch.middle(); }
  Point centre() const { return runs_along_x(wall) ? Point{middle(), across} : Point{across, middle()}; }
};

// Bodies that reach above `above` must stay out of it; it may be a part missing from the room.
struct Zone {
  Rect rect;
  i64 above;
  i64 is_wall;
};

// What Python sends; openings, zones and the floor that a standard asks for before doors follow.
struct RoomHeader {
  u64 stream;
  f64 area;
  Rect clear;
  i64 gap;
  i32 exterior;  // bit by Wall
  i32 openings;
  i32 zones;
  i32 approaches;
  i32 insisted_spec;  // of the piece of its type that is insisted on, or -1
  i32 insisted_number;  // of that piece's copy
};

struct Scope {
  Rect clear;
  i64 gap;
  i32 exterior;
  Span<Opened> openings;
  Span<Zone> zones;
  Span<Rect> approaches = {};

  // Passages are doors here, and so is the front door.
  static bool is(const Opened& one, Opening kind) {
    return one.kind == kind || (kind == Opening::door && (one.kind == Opening::passage || one.kind == Opening::front_door));
  }
  bool has(Opening kind) const {
    for (const Opened& one : openings) {
      if (is(one, kind)) return true;
    }
    return false;
  }
};

// Where doors along the sides of a piece so high open and meet no sill board: off the walls with windows, where it reaches above a sill.
Rect opened_within(const Scope& scope, i64 height);

// The walls of the room and what takes them up.
class WallOccupancy {
 public:
  explicit WallOccupancy(const Scope& scope);

  // The clear stretches for a body of that kind with its back to the wall, west or north first; `occupied`: what was marked counts.
  List<Interval> stretches(Wall wall, const Kind& kind, bool occupied) const;

  void occupy(const Rect& footprint) { taken_.add(footprint); }
  bool is_occupied(const Rect& footprint) const;
  bool is_before_gate(const Rect& footprint) const;

 private:
  const Scope& scope_;
  List<Rect> gates_;
  List<Rect> taken_;
};

}  // namespace furnish
