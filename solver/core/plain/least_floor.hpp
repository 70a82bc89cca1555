// The least floor of a room: how much of it there must be for the centre of who walks (docs/scene.md, unreachable). A centre counts where
// the whole square lies on clear floor: those in doorways do not.
#pragma once

#include "plain/numbers.hpp"

constexpr i64 LEAST_FLOOR_MM2 = 250'000;

// What of a free cell's area is left where who walks is a unit wider on each side. Walks look for ways of somebody that much
// narrower, so that gaps of exactly the width let it through; the floor is that of the whole person. Cells are two units wide or wider.
// `is_taken(x, z)` tells whether the cell so many on is taken; what lies outside is.
template <class Taken> i64 area_within(i64 wide, i64 deep, Taken is_taken) {
  const bool west = is_taken(-1, 0), east = is_taken(1, 0), north = is_taken(0, -1), south = is_taken(0, 1);
  i64 corners = 0;
  corners += !west && !north && is_taken(-1, -1);
  corners += !east && !north && is_taken(1, -1);
  corners += !west && !south && is_taken(-1, 1);
  corners += !east && !south && is_taken(1, 1);
  return (wide - west - east) * (deep - north - south) - corners;
}
