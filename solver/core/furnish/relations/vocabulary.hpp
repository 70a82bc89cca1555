// What Python asks of relations that a user asks for (solver/relations/asking.py).
#pragma once

#include "furnish/relations/relation.hpp"

namespace furnish {

Bytes relation_regions(Bytes asked);
Bytes relation_boxes(Bytes asked);
bool relation_holds(Bytes asked, bool in_room);
// The usual distance, mm, and behind it a bit for each of what a relation is.
i64 relation_traits(Word word);

}  // namespace furnish
