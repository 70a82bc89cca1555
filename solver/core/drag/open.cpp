#include "drag/drag.hpp"

namespace drag {

static bool is_within(i64 number, i64 count) { return number >= 0 && number < count; }

// Ends the call where numbers of pieces and bodies are none.
static void check(const Drag& drag) {
  const placement::Room& room = drag.desk->engine.room;
  bool fits = is_within(drag.held, drag.movers.size) && room.pieces.size == drag.movers.size && drag.rows.size == drag.riders.size;
  for (const Mover& mover : drag.movers) fits = fits && is_within(mover.body, drag.riders.size) && mover.reach >= 0;
  for (const Rider& rider : drag.riders) fits = fits && (rider.piece == -1 || is_within(rider.piece, drag.movers.size));
  for (i64 k = 0; fits && k < room.pieces.size; k++) fits = room.pieces[k].candidates[0] < room.pieces[k].candidates[1];
  if (!fits) fail(Failure::bad_request);
}

Drag* open(u8* sent, i64 size) {
  Reader from(sent, size);
  const OpeningHead& head = from.take<OpeningHead>(1)[0];
  const auto counted = [&](i64 count) { return static_cast<i32>(is_within(count, size) ? count : -1); };
  if (head.version != VERSION || head.problem < static_cast<i64>(sizeof(placement::RoomRequest))) fail(Failure::bad_request);
  Drag& drag = *static_cast<Drag*>(arena::zeroed(sizeof(Drag)));
  const Span<u8> problem = from.take<u8>(counted(head.problem));
  const Span<u8> storey = from.take<u8>(counted(head.storey));
  drag.storey = as_bytes(storey);
  drag.movers = from.take<Mover>(counted(head.pieces));
  drag.riders = from.take<Rider>(counted(head.bodies));
  drag.held = head.held;
  const placement::Room asked = placement::room_of(reinterpret_cast<placement::RoomRequest*>(problem.data)).room;
  placement::Sizes sizes = placement::sizes_of(asked);
  sizes.states = 1;  // nothing searches over ways to stand
  drag.desk = placement::new_desk(asked, sizes);
  const Rows<placement::CandidateRow>& candidates = drag.desk->engine.room.candidates;
  drag.sent = reserved<placement::CandidateRow>(candidates.size);
  for (i64 k = 0; k < candidates.size; k++) drag.sent[k] = candidates[k];
  Reader reader(drag.storey);
  const validate::Storey read = validate::read_storey(reader);
  if (read.rooms.size != 1) fail(Failure::bad_request);
  const Span<validate::Body> bodies = read.rooms[0].room.bodies;
  // the rows lie one behind the other in what was sent
  drag.rows = {bodies.size > 0 ? const_cast<validate::BodyRow*>(bodies[0].row) : nullptr, bodies.size};
  drag.start = reserved<Spot>(bodies.size);
  for (i64 k = 0; k < bodies.size; k++) drag.start[k] = {drag.rows[k].x, drag.rows[k].z};
  check(drag);
  return &drag;
}

}  // namespace drag
