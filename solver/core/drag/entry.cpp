// What the host calls of a drag.
#include "drag/drag.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

extern "C" {

EXPORT(open_drag) drag::Drag* entry_open_drag(u8* sent, i64 size) { return drag::open(sent, size); }

// A frame is 16 bytes and 16 a body; the answer is written over it.
EXPORT(answer_frame) void entry_answer_frame(const drag::Drag* drag, drag::Frame* frame) { drag::answer(*drag, *frame); }
}
