// What the host calls of this stage.
#include "furnish/furnish.hpp"
#include "furnish/listed.hpp"
#include "furnish/relations/relation.hpp"

using namespace furnish;

extern "C" __attribute__((export_name("furnish"))) i64 entry_furnish(u8* type_rows, i64 type_size, u8* room_rows, i64 room_size) {
  return told(furnish_room({type_rows, type_size}, {room_rows, room_size}));
}

// What a list of pieces with relations asks for.
extern "C" __attribute__((export_name("listed_pieces"))) i64 entry_listed_pieces(u8* kinds, i64 kinds_size, u8* room, i64 room_size) {
  return told(listed_pieces({kinds, kinds_size}, {room, room_size}));
}

// Relations as solver/relations asks of them.
extern "C" __attribute__((export_name("relation_holds"))) i32 entry_relation_holds(u8* asked, i64 size, i32 in_room) {
  return relation_holds({asked, size}, in_room != 0);
}

// The usual distance, mm, and seven bits: what it is, in the order of `Traits` of solver/relations.
extern "C" __attribute__((export_name("relation_traits"))) i64 entry_relation_traits(i32 word) {
  return relation_traits(static_cast<Word>(word));
}
