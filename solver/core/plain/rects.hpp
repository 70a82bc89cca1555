// Rectangles, walls and right angles on the lattice of whole millimetres.
#pragma once

#include "numbers.hpp"

// In the order in which Python's WALLS names them.
enum class Wall : i32 { none = -1, north = 0, south = 1, east = 2, west = 3 };
constexpr Wall WALLS[] = {Wall::north, Wall::south, Wall::east, Wall::west};

// Of an unrotated body; front is south, left is west.
enum class Side : i32 { left = 0, right = 1, front = 2, back = 3 };

// So high lies what is in nobody's way, mm.
constexpr i64 NOWHERE_MM = 100'000;

constexpr bool runs_along_x(Wall wall) { return wall == Wall::north || wall == Wall::south; }
constexpr i64 inwards(Wall wall) { return wall == Wall::north || wall == Wall::west ? 1 : -1; }
constexpr bool is_lateral(Side side) { return side == Side::left || side == Side::right; }

// The rotation of a body with its back to that wall, degrees.
constexpr i32 rotation_at(Wall wall) { return wall == Wall::north ? 0 : wall == Wall::west ? 90 : wall == Wall::south ? 180 : 270; }

// The wall that the front of a body looks to.
constexpr Wall wall_ahead(i32 rotation) {
  constexpr Wall AHEAD[] = {Wall::south, Wall::east, Wall::north, Wall::west};
  return AHEAD[floor_mod(rotation, 360) / 90];
}

struct Point {
  i64 x;
  i64 z;
};

struct Interval {
  i64 low;
  i64 high;

  constexpr bool operator==(const Interval&) const = default;
  constexpr i64 middle() const { return floor_div(low + high, 2); }
};

// As Python orders tuples; of a type of its own, so that a sort by it calls no pointer.
constexpr auto begins_before = [](const Interval& a, const Interval& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; };

// Extents along x and z.
struct Extent {
  i64 x;
  i64 z;
};

// The wall behind a body.
constexpr Wall wall_behind(i64 rotation) {
  constexpr Wall BEHIND[] = {Wall::north, Wall::west, Wall::south, Wall::east};
  return BEHIND[floor_mod(rotation, 360) / 90];
}

constexpr Wall opposite(Wall wall) {
  return wall == Wall::north ? Wall::south : wall == Wall::south ? Wall::north : wall == Wall::east ? Wall::west : Wall::east;
}

// The unit vector (x, z) of the front, by rotation.
constexpr Point facing(i64 rotation) {
  constexpr Point FACING[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
  return FACING[floor_mod(rotation, 360) / 90];
}

// A vector in a body's frame (across its +x side, along its front) in the room's.
constexpr Point rotated(Point at, i32 rotation) {
  const Point d = facing(rotation);
  return {d.z * at.x + d.x * at.z, d.z * at.z - d.x * at.x};
}

constexpr Extent turned(Extent size, i32 rotation) { return rotation % 180 == 90 ? Extent{size.z, size.x} : size; }

// The length of a vector; its squares are exact up to 67 km.
inline f64 length(i64 x, i64 z) {
  const f64 dx = static_cast<f64>(x), dz = static_cast<f64>(z);
  return root(dx * dx + dz * dz);
}

struct Rect {
  i64 x0, z0, x1, z1;

  static constexpr Rect around(Point centre, Extent extent) {
    const i64 x0 = centre.x - floor_div(extent.x, 2), z0 = centre.z - floor_div(extent.z, 2);
    return {x0, z0, x0 + extent.x, z0 + extent.z};
  }
  constexpr bool operator==(const Rect&) const = default;
  constexpr i64 width() const { return x1 - x0; }
  constexpr i64 depth() const { return z1 - z0; }
  constexpr Point centre() const { return {floor_div(x0 + x1, 2), floor_div(z0 + z1, 2)}; }
  constexpr Rect shrunk(i64 by) const { return {x0 + by, z0 + by, x1 - by, z1 - by}; }
  constexpr bool overlaps(const Rect& other) const { return x0 < other.x1 && other.x0 < x1 && z0 < other.z1 && other.z0 < z1; }
  constexpr bool contains(const Rect& other) const {
    return x0 <= other.x0 && z0 <= other.z0 && other.x1 <= x1 && other.z1 <= z1;
  }
  constexpr Rect moved(i64 dx, i64 dz) const { return {x0 + dx, z0 + dz, x1 + dx, z1 + dz}; }
  // What lies in both; its extents are negative where they lie apart.
  constexpr Rect common(const Rect& other) const {
    return {most(x0, other.x0), most(z0, other.z0), least(x1, other.x1), least(z1, other.z1)};
  }
  // The bounds of both.
  constexpr Rect with(const Rect& other) const {
    return {least(x0, other.x0), least(z0, other.z0), most(x1, other.x1), most(z1, other.z1)};
  }
  // Shifted by the shortest way into a larger one.
  constexpr Rect held_in(const Rect& area) const {
    return moved(least(most(x0, area.x0), area.x1 - width()) - x0, least(most(z0, area.z0), area.z1 - depth()) - z0);
  }
  // The bounds of all that it covers while it is shifted so far.
  constexpr Rect swept(Point by) const {
    return {x0 + least<i64>(0, by.x), z0 + least<i64>(0, by.z), x1 + most<i64>(0, by.x), z1 + most<i64>(0, by.z)};
  }
  constexpr Interval along(Wall wall) const { return runs_along_x(wall) ? Interval{x0, x1} : Interval{z0, z1}; }
  constexpr i64 line(Wall wall) const {
    return wall == Wall::north ? z0 : wall == Wall::south ? z1 : wall == Wall::west ? x0 : x1;
  }
  constexpr i64 wall_distance(Wall wall, const Rect& room) const { return (line(wall) - room.line(wall)) * inwards(wall); }
  constexpr Point point_at(Wall wall, i64 along, i64 into) const {
    const i64 across = line(wall) + inwards(wall) * into;
    return runs_along_x(wall) ? Point{along, across} : Point{across, along};
  }
  // The free distance to a point; 0 inside.
  f64 distance_to(Point at) const {
    return distance_to(Rect{at.x, at.z, at.x, at.z});
  }
  // The same to another one; 0 where they touch or overlap.
  f64 distance_to(const Rect& other) const {
    return length(most<i64>(most(x0 - other.x1, other.x0 - x1), 0), most<i64>(most(z0 - other.z1, other.z0 - z1), 0));
  }
};

// What of the rectangle of a body lies within its margins, the body turned by so many right angles.
template <typename Margins> constexpr Rect drawn_in(const Rect& body, const Margins& by, i64 quarters) {
  const i64 round[] = {by.left, by.back, by.right, by.front};
  const auto at = [&](i64 edge) { return round[(edge + quarters) % 4]; };
  return {body.x0 + at(0), body.z0 + at(1), body.x1 - at(2), body.z1 - at(3)};
}

// A door or passage as the host sends it: its wall, whether its leaf opens over its square (of what is decorated alone), its square, mm.
struct Doorway {
  Wall wall;
  i32 swings_in;
  Rect square;
};

// The line of a wall of two rectangles that lies further inwards.
constexpr i64 inner_line(Wall wall, const Rect& a, const Rect& b) {
  return inwards(wall) > 0 ? most(a.line(wall), b.line(wall)) : least(a.line(wall), b.line(wall));
}

// By west edge, then north, east, south: as Python orders tuples.
constexpr auto goes_before = [](const Rect& a, const Rect& b) {
  return a.x0 != b.x0 ? a.x0 < b.x0 : a.z0 != b.z0 ? a.z0 < b.z0 : a.x1 != b.x1 ? a.x1 < b.x1 : a.z1 < b.z1;
};

// The rectangle over an interval of a wall whose line is given, `depth` deep into its room.
constexpr Rect strip_at(Wall wall, i64 line, Interval over, i64 depth) {
  const i64 inner = line + inwards(wall) * depth;
  const i64 low = least(line, inner), high = most(line, inner);
  return runs_along_x(wall) ? Rect{over.low, low, over.high, high} : Rect{low, over.low, high, over.high};
}

// The rectangle that lies along a wall of `rect`, inside it, over an interval of that wall.
constexpr Rect strip(const Rect& rect, Wall wall, Interval over, i64 depth) { return strip_at(wall, rect.line(wall), over, depth); }
