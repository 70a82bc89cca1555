// A frame of a drag: while one piece of a room is dragged, where it and its neighbours go next.
//
// Opened once a drag with all that does not change (`Opening`); then a frame is poses in, poses out. Of the room's placement problem every
// neighbour may go no farther than its reach from where it was in the last frame, so that nearly all choices of the last frame hold and
// the search is short; the piece in hand goes no farther from its wish than it was, but for its reach. Work is counted, never timed.
// What it finds is put on whole millimetres and judged by the rules of validate/; where that fails, everything goes from the last frame
// towards its wish as far as it can; else nothing moves.
#pragma once

#include "placement/space.hpp"
#include "validate/walk.hpp"

namespace drag {

constexpr i64 VERSION = 4;

// What the host sends at the start: this, a `placement::RoomRequest`, the room as a storey of its own (`validate::StoreyRow`), and then
// movers and riders.
struct OpeningHead {
  i64 version;
  i64 problem, storey;  // bytes
  i64 pieces, bodies;
  i64 held;  // the number of the piece in hand
};

// A piece of the problem.
struct Mover {
  i64 body;   // which body of the room it is
  i64 reach;  // how far it may go between frames along each axis, mm; the piece in hand: how much farther from its wish
};

// A body of the room.
struct Rider {
  i64 piece;  // the piece, standing free, that takes it along: itself or what carries it; -1: it stays
};

// Where the middle of a body is, m.
struct Spot {
  f64 x, z;
};

// What becomes of a frame: there is no valid answer; the best found; all gone as far towards their wishes as they can; nothing moved.
enum class Outcome : i32 { none = 0, placed = 1, drawn = 2, stayed = 3 };

// A frame: where the middle of the piece in hand is wished, and behind it the spots of all bodies in the last frame. The answer takes its
// place: the outcome, and the work it cost, QPs and walks; behind them the spots of all bodies.
struct Frame {
  union {
    Spot wish;
    struct {
      f64 outcome, work;
    };
  };
  Spot spots[1];
};

// A drag that was opened.
struct Drag {
  placement::Desk* desk;
  i64 held;
  Span<Mover> movers;
  Span<Rider> riders;
  Span<placement::CandidateRow> sent;  // the candidates as they were sent
  Span<Spot> start;                    // of all bodies
  Bytes storey;
  Span<validate::BodyRow> rows;  // of all bodies, in `storey`
};

// Takes space for a drag; what was sent must stay where it is.
Drag* open(u8* sent, i64 size);

// Answers a frame in its place.
void answer(const Drag& drag, Frame& frame);

// Tells whether the room breaks no rule, every body at its spot, and all of it can be come to.
bool is_valid(const Drag& drag, const Frame& frame);

}  // namespace drag
