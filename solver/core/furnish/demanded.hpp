// What a room wants where one of its pieces is insisted on.
#pragma once

#include "furnish/comfort.hpp"

namespace furnish {

// The same with a piece as if it were required, and with it all that it needs and what it stands together with alone: the floor of its
// fronts, too. Where others, as of a kitchen's run, have floor that matters, they keep it: what is required has it required, what is
// optional stands with it alone. Else what is insisted on would stand where their drawers open.
WantedRows demanded(const WantedRows& wanted, i32 piece);

}  // namespace furnish
