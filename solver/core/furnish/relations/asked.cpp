// What Python asks of relations that a user asks for, and judges by.
#include "furnish/relations/asked.hpp"

#include "furnish/relations/at_side.hpp"
#include "furnish/relations/openings.hpp"

namespace furnish {

List<Opened> Footing::openings(bool doors) const {
  List<Opened> found;
  const auto add = [&](Opening kind) {
    for (const Opened& one : scope.openings) {
      if (Scope::is(one, kind)) found.add(one);
    }
  };
  if (doors) add(Opening::door);
  for (const Name& name : asked.of) {
    if (!doors && name.opening != Opening::none) add(name.opening);
  }
  return found;
}

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
  for (const auto& [across, along, level] : found) {
    if (across.low <= at.x && at.x <= across.high && along.low <= at.z && at.z <= along.high) return true;
  }
  return false;
}

namespace {

// Whether it holds is asked of two bodies as they stand; where, of a footing in the room, or of two kinds, the other unturned at 0.
struct Question {
  Rule rule;
  Rect clear;
  Rect reach;  // of a footing; the own body's footprint
  Rect other;
  Extent extent;  // the own one along x and z
  i64 height;
  i32 rotation, other_rotation;
  Wall wall;
  i32 rests, judged;
  i32 sides, names, openings, levels, other_parts, parts;
  i32 unused;
};

struct PlaceRow {
  Rect centre;
  i64 level;
};

struct Read {
  Question& question;
  const Relation& relation;
  Asked asked;
  Scope scope;
  Footing at;
  Fit fit;

  explicit Read(Reader reader)
      : question(reader.take<Question>(1)[0]),
        relation(relation_of(question.rule.word)),
        asked{question.rule, reader.take<Side>(question.sides), reader.take<Name>(question.names), question.judged ? HELD : SOUGHT},
        scope{question.clear, 0, 0, reader.take<Opened>(question.openings), {}},
        at{asked, scope, question.rotation, question.wall, question.extent, question.reach},
        fit{asked, turned({question.other.width(), question.other.depth()}, question.other_rotation),
            turned(question.extent, question.other_rotation), (360 + question.rotation - question.other_rotation) % 360, question.height,
            reader.take<Level>(question.levels), reader.take<PartBox>(question.other_parts), reader.take<PartBox>(question.parts)} {}
};

}  // namespace

template <class T> static Bytes written(Span<T> rows) {
  Writer writer(bytes_of(rows));
  writer.put(rows);
  return writer.written();
}

Bytes relation_regions(Bytes asked) {
  const Read read(Reader(asked.data, asked.size));
  List<Rect> found;
  read.relation.regions(read.at, found);
  return written(found.all());
}

Bytes relation_boxes(Bytes asked) {
  const Read read(Reader(asked.data, asked.size));
  List<DoubleBox> found;
  read.relation.boxes(read.fit, found);
  List<PlaceRow> rows;
  for (const DoubleBox& box : found) rows.add({rounded(box), box.level});
  return written(rows.all());
}

bool relation_holds(Bytes asked, bool in_room) {
  const Read read(Reader(asked.data, asked.size));
  const Question& question = read.question;
  if (in_room) return read.relation.holds_in_room(read.at);
  const Standing own{question.reach, question.rotation, question.rests != 0}, other{question.other, question.other_rotation, false};
  return read.relation.holds_with(read.fit, own, other);
}

i64 relation_traits(Word word) {
  const Relation& it = relation_of(word);
  const bool traits[] = {it.gives_place, it.by_degree, it.turns, it.with_all, it.among_copies, it.at_walls, it.into_line};
  i64 told = it.usual;
  for (bool trait : traits) told = 2 * told + trait;
  return told;
}

}  // namespace furnish
