// What Python asks of relations that a user asks for, and judges by.
#include "furnish/relations/asked.hpp"

#include "furnish/relations/at_side.hpp"

namespace furnish {

i64 Footing::off_wall(Point at) const {
  const bool level = runs_along_x(wall);
  const i64 low = level ? reach.z0 : reach.x0, high = level ? reach.z1 : reach.x1, point = level ? at.z : at.x;
  return most<i64>(most(low - point, point - high), 0);
}

bool Relation::suits(Walls asked, Wall mine, Wall theirs) const {
  if (asked == Walls::any) return true;
  if (mine == Wall::none || theirs == Wall::none) return false;
  const Walls found = mine == theirs ? Walls::same : mine == opposite(theirs) ? Walls::opposite : Walls::adjacent;
  return found == asked || (asked == Walls::other && found != Walls::same);
}

bool Relation::holds_in_room(const Footing& at) const {
  List<Rect> found;
  regions(at, found);
  for (const Rect& rect : found) {
    if (rect.contains(at.reach)) return true;
  }
  return false;
}

bool Relation::holds_with(const Fit& fit, const Standing& own, const Standing& other) const {
  const Point at = rotated(own.double_way_from(other), 360 - other.rotation);
  List<DoubleBox> found;
  boxes(fit, found);
  for (const auto& [across, along, level, is_seat] : found) {
    if (across.low <= at.x && at.x <= across.high && along.low <= at.z && at.z <= along.high) return true;
  }
  return false;
}

// A relation, and what of two bodies as they stand, or of one and its room, tells whether it holds; its sides, names and openings follow.
struct Question {
  Rule rule;
  Rect clear;
  Rect own, other;
  i32 rotation, other_rotation;
  Wall wall, other_wall;
  i32 rests, sides, names, openings;
};

bool relation_holds(Bytes asked, bool in_room) {
  Reader reader(asked.data, asked.size);
  const Question& question = reader.take<Question>(1)[0];
  const Rule& rule = question.rule;
  const Relation& relation = relation_of(rule.word);
  const Span<Side> sides = reader.take<Side>(question.sides);
  const Asked meant{rule, sides, reader.take<Name>(question.names), HELD};
  const Standing own{question.own, question.rotation, question.rests != 0}, other{question.other, question.other_rotation, false};
  const Extent size{own.rect.width(), own.rect.depth()}, its{other.rect.width(), other.rect.depth()};
  if (in_room) {
    const Scope scope{question.clear, 0, 0, reader.take<Opened>(question.openings), {}};
    return relation.holds_in_room({meant, scope, own.rotation, question.wall, size, own.rect});
  }
  const i32 turn = (360 + own.rotation - other.rotation) % 360;
  const Fit fit{meant, turned(its, other.rotation), turned(size, other.rotation), turn, 0, {}, {}, {}, {}};
  return relation.suits(rule.wall, question.wall, question.other_wall) && relation.holds_with(fit, own, other);
}

i64 relation_traits(Word word) {
  const Relation& it = relation_of(word);
  const bool traits[] = {it.gives_place, it.by_degree, it.turns, it.with_all, it.among_copies, it.at_walls, it.into_line};
  i64 told = it.usual;
  for (bool trait : traits) told = 2 * told + trait;
  return told;
}

}  // namespace furnish
