// A furnished room as Python sends it (solver/decorations/decorating.py), and a room while it is being decorated. Lengths are mm.
#pragma once

#include "decorate/decorating.hpp"
#include "floor/free_floor.hpp"
#include "plain/streams.hpp"

namespace decorate {

// Rugs and mats: what is no higher is no body, one stands on it (docs/scene.md, The rules).
constexpr i64 FLAT_MM = 20;
constexpr i64 NOBODY = -1;

struct RoomHeader {
  u64 stream;
  Rect clear;
  f64 width, depth;  // m
  i64 wide, deep;    // the same
  i64 ceiling;
  i64 robot;
  i32 word;  // its type
  i32 outdoor;
  i32 plain;  // it has no outline
  i32 has_accent;
  i32 pieces, openings, zones, doors, kept, manners;
};

// Floor at a side of a piece that is better kept free: the wall it faces, how far in from the piece's ends it begins and ends.
struct Beside {
  Wall faced;
  i32 low, high;
  i32 deep;
};

// What is said of all furniture of a kind and size that is turned so. `faced`: one comes to it from its front alone. `sides`: it is used
// from, as in Goal. Its fronts come so far before it as they `open`, 0 for none, from `opens_above` its underside on.
struct Manner {
  i32 rotation;  // 0 of what stands askew
  i32 word;
  Range surfaces;
  Range insides;
  i32 faced;
  i32 sides;
  i32 need_all;
  i32 opens;
  i32 opens_above;
  i32 kept;  // how many of these there are
  Beside beside[4];
};

// A piece of furniture. `in_the_way`: of who walks.
struct Piece : Manner {
  Rect rect;
  i64 low;
  i64 high;
  i64 under;  // the piece it is tucked under
  bool in_the_way;
};

// An opening where nothing hangs: over an interval of its wall, from `bottom` to `top`.
struct Opening {
  i32 wall;
  i32 unused;
  Interval along;
  i64 bottom;
  i64 top;
};

// What must stay free of all that reaches above a height.
struct Zone {
  Rect rect;
  i64 above;
  i64 is_outline;  // a missing part of the rectangle
};

// A piece of furniture as it was put into the room, or a thing. `parent`: what carries it, the number of a piece, or behind those of a
// thing. `under`: the piece it is tucked under. `colour`: -1 is the room's accent. `number` counts what the room has of its word, furniture
// first.
struct Thing {
  i32 kind;
  i32 parent;
  i32 under;
  i32 wall;
  i32 rotation;
  i32 colour;
  i32 number;
  i32 unused;
  Rect rect;
  i64 low;
  Size size;
};

// What may carry things: a piece, or a thing behind them. Right-angled pieces alone have another rotation than 0.
struct Carrier {
  Rect rect;
  i64 low;
  i64 high;
  i64 rotation;
  i64 word;
  Span<Surface> surfaces;
  i64 parent;
};

// Kinds that take turns; empty where there are to be none.
struct Turns {
  Span<Choice> choices;
  i32 first;

  const Choice& at(i64 k) const { return choices[(first + k) % choices.size]; }
};

class DecoratedRoom {
 public:
  DecoratedRoom(const Decorating& known, Bytes rows);

  // Draws which kinds of a row there are to be, in the order in which they take turns.
  Turns wanted(const Row& row);

  // Draws how far askew a thing lies, degrees.
  i64 jitter(const Kind& kind);

  // Fills `found` with what shares space with a box, but what a carrier stands in or on and what is tucked under the piece it is all on.
  void near(const Rect& rect, Interval heights, i64 carrier, List<Rect>& found) const;

  // Adds what fronts come into as they open.
  void opened_over(Interval heights, List<Rect>& found) const;

  // Puts a thing into the room, where it may carry others.
  void add(const Choice& choice, const Row& row, const Rect& rect, i64 low, const Size& size, i64 rotation, i64 parent, Wall wall);

  // The extents along x and z of a rotated footprint's bounding rectangle, rounded up.
  Extent bounds_of(const Size& size, i64 rotation) const;

  bool is_sat_under(i64 piece, i64 table) const { return piece < pieces.size && pieces[piece].under == table; }

  const Decorating& known;
  RoomHeader room;
  Span<Piece> pieces;
  List<Opening> openings;
  Span<Zone> zones;
  Span<Doorway> doors;
  List<Rect> kept;  // floor that is better kept free
  Stream stream;
  List<Carrier> carriers;  // the pieces, then the things
  List<Thing> things;

  struct Block {
    Rect rect;
    i64 low;
    i64 high;
    i64 body;
  };
  List<Block> blocks;
  List<Block> opened;  // what fronts come into as they open

 private:
  struct Drawn {
    i64 parent;
    i32 kind;
    i32 colour;
  };

  void keep_beside(const Piece& piece);
  void open_fronts(const Piece& piece);
  i64 root_of(i64 carrier) const;
  bool stands_on(i64 carrier, i64 body) const;
  i32 colour(const Choice& choice, const Row& row, i64 parent);

  List<Drawn> colours_;
};

}  // namespace decorate
