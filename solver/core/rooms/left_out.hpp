// What there is to say of a piece that was left out.
#pragma once

#include "rooms/made.hpp"

namespace rooms {

LeftOutRow left_out_row(const WantingRoom& room, i64 piece, Why why, Span<PlacedRow> placed);

}  // namespace rooms
