// Where the front door, doors, passages and garage doors stand, and how their leaves swing: no leaf sweeps another leaf or the square of
// another door; squares of different doors in a furnished room stay apart where the walls allow.
#include "openings/doorways.hpp"

namespace openings {

namespace {

constexpr i64 WIDE_MM = 1200;       // of a passage where two hallways meet or the shared wall is long
constexpr i64 WIDE_WALL_MM = 3000;  // shared wall from which a passage is wide: what is left takes a sofa's end
constexpr i64 CAR_DOOR_MM = 2400;   // width of a garage door for each car
constexpr i64 FACES_MM = 1000;  // facing another door is as awkward as so far a way from the corner
// How many doors in a row may give way to one another in a house too small for doors in the middle of walls; places tried in all for them.
constexpr i32 EJECTIONS = 3;
constexpr i32 TRIES = 2000;
constexpr i32 MOST_EJECTED = 2;

struct Forms {
  Cut each[4];
  i32 size = 0;

  void add(const Cut& cut) { each[size++] = cut; }
  const Cut* begin() const { return each; }
  const Cut* end() const { return each + size; }
};

Cut with_leaf(Cut cut, i64 leaf) {
  cut.leaf = leaf;
  return cut;
}

// Whether a leaf that sweeps a room's floor should swing out of it.
bool swings_wrongly(const House& house, i64 leaf) { return leaf != NONE && house.rooms[leaf].has(MUST_SWING_OUT); }

// What may be cut into a wall: a leaf into the room entered, the other way, and no leaf at all. Between two rooms of passages it is a
// passage from the start. Hallways and their like are swung into last, last of all what must be swung out of.
Forms forms_of(const House& house, const Joint& joint, i64 number) {
  Forms forms;
  const HouseRoom &a = house.rooms[joint.a], &b = house.rooms[joint.b];
  if (!a.has(PASSAGE) || !b.has(PASSAGE)) {
    const auto reluctance = [&](i64 room) { return 2 * house.rooms[room].has(MUST_SWING_OUT) + !house.rooms[room].has(SWINGS_IN); };
    i64 first = joint.entered, second = joint.other(first);
    if (reluctance(second) < reluctance(first)) swap(first, second);
    const Cut door{CutKind::door, number, joint.a, joint.wall, joint.b, 0, house.header.leaf, first, 0};
    forms.add(door);
    forms.add(with_leaf(door, second));
  }
  const bool wide = joint.length() >= (a.has(HALLWAY) && b.has(HALLWAY) ? house.header.hallway : WIDE_WALL_MM);
  const i64 widths[] = {wide ? most(WIDE_MM, house.header.leaf) : house.header.leaf, house.header.leaf};
  for (const i64 width : widths) {
    forms.add({CutKind::passage, number, joint.a, joint.wall, joint.b, 0, width, NONE, 0});
  }
  return forms;
}

// Adds an opening wherever the few others in its way can be added elsewhere in the same manner.
class Shuffle {
 public:
  explicit Shuffle(Doorways& doorways) : doorways_(doorways) {
    for (Span<Cut>& before : before_) before = reserved<Cut>(doorways.house.joints.size + 2);
  }

  // False, and nothing changed, where none of a bounded number of tries works. `strict`: no leaf comes to swing in that should swing out,
  // and no door is left without one: what gives way to a door would else take the door's own leaf off.
  bool add(const Cut& cut, bool strict) {
    tries_ = TRIES;
    strict_ = strict;
    return add(cut, EJECTIONS);
  }

 private:
  // Tries an opening everywhere in its wall: as it is, with its leaf the other way, and at last, if not strict, without a leaf.
  bool add(Cut cut, i32 depth) {
    Forms forms;
    forms.add(cut);
    if (cut.kind == CutKind::door) {
      const i64 sides[] = {cut.room, cut.other};
      for (const i64 leaf : sides) {
        if (leaf != cut.leaf && !(strict_ && swings_wrongly(doorways_.house, leaf))) forms.add(with_leaf(cut, leaf));
      }
      if (cut.other != NONE && !strict_) {
        Cut open = with_leaf(cut, NONE);
        open.kind = CutKind::passage;
        forms.add(open);
      }
    }
    for (const Cut& form : forms) {
      if (tries_ < 0) return false;
      if (place(form, depth)) return true;
    }
    return false;
  }

  bool place(const Cut& form, i32 depth) {
    const House& house = doorways_.house;
    const auto try_at = [&](i64 centre) { return --tries_ < 0 || make_way(form.at(centre), depth); };
    if (form.other != NONE) {
      const Joint* joint = house.joint_of(form);
      return joint != nullptr && any_place(house.header, form.width, joint->over, try_at) && tries_ >= 0;
    }
    for (const Stretch& stretch : house.outside(form.room)) {
      if (stretch.wall == form.wall && any_place(house.header, form.width, stretch.over, try_at)) return tries_ >= 0;
    }
    return false;
  }

  bool make_way(const Cut& moved, i32 depth) {
    Cut ejected[MOST_EJECTED];
    const i32 count = doorways_.colliding(moved, ejected, MOST_EJECTED);
    if (count > least(depth, MOST_EJECTED)) return false;
    for (i32 i = 0; i < count; i++) {
      if (!ejected[i].has_square()) return false;
    }
    const Span<Cut> before{before_[depth].data, doorways_.cuts().size()};
    if (before.size > before_[depth].size) fail(Failure::out_of_range);
    for (i32 i = 0; i < before.size; i++) before[i] = doorways_.cuts()[i];
    for (i32 i = 0; i < count; i++) doorways_.remove(ejected[i]);
    doorways_.add(moved);
    for (i32 i = 0; i < count; i++) {
      if (!add(ejected[i], depth - 1)) {
        doorways_.restore(before);
        return false;
      }
    }
    return true;
  }

  Doorways& doorways_;
  i32 tries_ = 0;
  bool strict_ = false;
  Span<Cut> before_[EJECTIONS + 1];
};

}  // namespace

void place_entrance(Doorways& doorways) {
  const Header& header = doorways.house.header;
  const i64 room = header.entrance_room;
  const Cut cut{CutKind::door, 0, room, header.entrance_wall, NONE, 0, header.entrance, room, 1};
  doorways.add(doorways.best_outside(cut).placed);
}

// Places one of some forms where it is in nobody's way, or where others can give way to it; `best` is the best place in any case.
static bool place_in_the_clear(Doorways& doorways, Shuffle& shuffle, const Forms& forms, const Joint& joint, bool strict, Offer& best) {
  i32 allowed = 0;
  while (allowed < forms.size && !(strict && swings_wrongly(doorways.house, forms.each[allowed].leaf))) allowed++;
  best = {INFINITE, forms.each[0]};
  for (i32 i = 0; i < allowed && best.score >= COLLISION; i++) {
    const Offer offer = doorways.best(forms.each[i], joint.over);
    if (offer.score < best.score) best = offer;
  }
  if (best.score < COLLISION) {
    doorways.add(best.placed);
    return true;
  }
  for (i32 i = 0; i < allowed; i++) {
    if (shuffle.add(forms.each[i], strict)) return true;
  }
  return false;
}

void place_doors(Doorways& doorways) {
  const House& house = doorways.house;
  Shuffle shuffle(doorways);
  for (i32 i = 0; i < house.joints.size; i++) {
    const Joint& joint = house.joints[i];
    const Forms forms = forms_of(house, joint, i + 1);
    Offer best;
    const bool placed = place_in_the_clear(doorways, shuffle, forms, joint, true, best) ||
                        place_in_the_clear(doorways, shuffle, forms, joint, false, best);
    if (!placed) doorways.add(best.placed);
  }
}

// By how much a door stands in the way, mm: how far it is from the corner of the room that its leaf is in, unless one enters the home
// beside it, where walls stay whole for coats; and how many doors it faces.
static i64 awkwardness(const Doorways& doorways, const Cut& cut) {
  const House& house = doorways.house;
  const i64 faced = FACES_MM * doorways.faced(cut), entrance = house.header.entrance_room;
  if (cut.room == entrance || cut.other == entrance) return faced;
  const Interval wall = house.rooms[cut.leaf].rect.along(cut.wall_of(cut.leaf)), ends = cut.ends();
  return least(ends.low - wall.low, wall.high - ends.high) + faced;
}

// Into rooms that one does not walk through.
static bool is_for_a_corner(const House& house, const Cut& cut) {
  if (cut.kind != CutKind::door || cut.leaf == NONE || cut.other == NONE) return false;
  return house.rooms[cut.leaf].has(HABITABLE) && !house.rooms[cut.leaf].has(PASSAGE);
}

void move_to_corners(Doorways& doorways) {
  for (i32 i = 0; i < doorways.cuts().size(); i++) {
    const Cut cut = doorways.cuts()[i];
    const Joint* joint = is_for_a_corner(doorways.house, cut) ? doorways.house.joint_of(cut) : nullptr;
    if (joint == nullptr) continue;
    const f64 score = doorways.score(cut);
    i64 least_awkward = awkwardness(doorways, cut);
    Cut best = cut;
    any_place(doorways.house.header, cut.width, joint->over, [&](i64 centre) {
      const Cut moved = cut.at(centre);
      const i64 awkward = awkwardness(doorways, moved);
      if (awkward < least_awkward && doorways.score(moved) <= score) best = moved, least_awkward = awkward;
      return false;
    });
    doorways.replace(cut, best);
  }
}

// As many cars wide as a wall takes, the south wall first.
static void place_garage_door(Doorways& doorways, i64 room) {
  const HouseRoom& garage = doorways.house.rooms[room];
  i64 found[4];
  Span<i64> walls{found, 0};
  for (const Stretch& stretch : doorways.house.outside(room)) {
    if (walls.size == 0 || walls[walls.size - 1] != stretch.wall) found[walls.size++] = stretch.wall;
  }
  const auto length = [&](i64 wall) {
    const Interval along = garage.rect.along(static_cast<Wall>(wall));
    return along.high - along.low;
  };
  constexpr i64 STREET = static_cast<i64>(Wall::south);
  stable_sort(walls, [&](i64 a, i64 b) { return (a == STREET) != (b == STREET) ? a == STREET : length(a) > length(b); });
  for (i64 cars = garage.cars; cars > 0; cars--) {
    for (const i64 wall : walls) {
      const Offer offer = doorways.best_outside({CutKind::garage_door, room, room, wall, NONE, 0, CAR_DOOR_MM * cars, NONE, 0});
      if (offer.score < COLLISION) {
        doorways.add(offer.placed);
        return;
      }
    }
  }
}

void place_garage_doors(Doorways& doorways) {
  for (i64 room = 0; room < doorways.house.rooms.size; room++) place_garage_door(doorways, room);
}

}  // namespace openings
