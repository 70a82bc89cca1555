// What the host calls of this stage: where the openings of a house are cut, and where else one of them could be.
#include "openings/doorways.hpp"

namespace openings {

const Stretch* House::stretch_at(i64 room, i64 wall, i64 centre) const {
  for (const Stretch& one : outside(room)) {
    if (one.wall == wall && one.over.low <= centre && centre <= one.over.high) return &one;
  }
  return nullptr;
}

const Joint* House::joint_of(const Cut& cut) const {
  const i64 a = least(cut.room, cut.other), b = most(cut.room, cut.other);
  for (const Joint& joint : joints) {
    if (joint.a == a && joint.b == b) return &joint;
  }
  return nullptr;
}

namespace {

constexpr i64 MOST_MM = 1'000'000;

bool is_within(i64 value, i64 low, i64 high) { return low <= value && value <= high; }
bool is_length(i64 value) { return is_within(value, -MOST_MM, MOST_MM); }
bool is_stretch(Interval over) { return is_length(over.low) && is_length(over.high) && over.low <= over.high; }

bool is_sound(const House& house) {
  const Header& header = house.header;
  const i64 last = house.rooms.size - 1;
  bool sound = last >= 0 && is_within(header.jamb, 0, MOST_MM) && is_within(header.least_jamb, 0, MOST_MM) && is_length(header.hallway);
  sound = sound && is_within(header.leaf, 1, MOST_MM) && is_within(header.entrance, 1, MOST_MM);
  sound = sound && is_within(header.entrance_room, 0, last) && is_within(header.entrance_wall, 0, 3);
  for (const HouseRoom& room : house.rooms) {
    const Rect& rect = room.rect;
    sound = sound && is_stretch({rect.x0, rect.x1}) && is_stretch({rect.z0, rect.z1}) && is_within(room.cars, 0, 9);
    part_of(house.wishes, {room.first_wish, room.wishes});
    i64 before = 0;
    for (const Stretch& one : part_of(house.stretches, {room.first_stretch, room.stretches})) {
      sound = sound && is_within(one.wall, before, 3) && is_stretch(one.over);
      before = one.wall;
    }
  }
  for (const Wish& wish : house.wishes) sound = sound && is_length(wish.length) && is_length(wish.depth) && is_length(wish.across);
  for (const Joint& one : house.joints) {
    sound = sound && is_within(one.a, 0, last) && is_within(one.b, one.a + 1, last) && is_within(one.wall, 0, 3) && is_stretch(one.over);
    sound = sound && (one.entered == one.a || one.entered == one.b);
  }
  for (const Cut& one : house.cuts) {
    sound = sound && is_within(static_cast<i64>(one.kind), 0, 3) && is_within(one.room, 0, last) && is_within(one.wall, 0, 3);
    sound = sound && is_within(one.other, NONE, last) && is_length(one.centre) && is_within(one.width, 1, MOST_MM);
  }
  return sound;
}

}  // namespace

House read(Bytes sent) {
  Reader reader(sent.data, sent.size);
  const Header& header = reader.take<Header>(1)[0];
  House house{header, {}, {}, {}, {}, {}};
  house.rooms = reader.take<HouseRoom>(header.rooms);
  house.wishes = reader.take<Wish>(header.wishes);
  house.stretches = reader.take<Stretch>(header.stretches);
  house.joints = reader.take<Joint>(header.joints);
  house.cuts = reader.take<Cut>(header.cuts);
  if (!is_sound(house)) fail(Failure::bad_request);
  return house;
}

Bytes open_walls(Bytes sent) {
  const House house = read(sent);
  Doorways doorways(house);
  place_entrance(doorways);
  place_doors(doorways);
  move_to_corners(doorways);
  place_garage_doors(doorways);
  place_windows(doorways);
  keep_walls(doorways);
  place_windows(doorways);  // where a door stood in the way of a room's only one
  make_room_for_windows(doorways);
  Writer writer(bytes_of(doorways.cuts().all()));
  writer.put(doorways.cuts().all());
  return writer.written();
}

Bytes door_places(Bytes sent) {
  const House house = read(sent);
  if (house.cuts.size == 0) fail(Failure::bad_request);
  const Cut cut = house.cuts[house.cuts.size - 1];
  const Stretch* stretch = cut.other == NONE ? house.stretch_at(cut.room, cut.wall, cut.centre) : nullptr;
  const Joint* joint = cut.other == NONE ? nullptr : house.joint_of(cut);
  const Doorways doorways(house);
  List<i64> centres, found;
  if (stretch != nullptr || joint != nullptr) {  // none has the door of a wall that is too short for it
    any_place(house.header, cut.width, stretch != nullptr ? stretch->over : joint->over, [&](i64 centre) {
      centres.add(centre);
      return false;
    });
  }
  if (centres.size() > 0) {
    i64 low = centres[0], high = low;
    for (const i64 centre : centres) low = least(low, centre), high = most(high, centre);
    const i64 quarter = floor_div(floor_div(high - low, 4), STEP_MM) * STEP_MM;
    const auto offer = [&](i64 centre) {
      for (const i64 known : found) {
        if (known == centre) return;
      }
      if (centre != cut.centre && doorways.score(cut.at(centre)) < CROWDED) found.add(centre);
    };
    const i64 ends[] = {low, high, low + quarter, high - quarter};
    for (const i64 centre : ends) offer(centre);
    for (const i64 centre : centres) offer(centre);
  }
  Writer writer(bytes_of(found.all()));
  writer.put(found.all());
  return writer.written();
}

extern "C" __attribute__((export_name("open_walls"))) i64 entry_open_walls(u8* request, i64 size) {
  return told(open_walls({request, size}));
}

extern "C" __attribute__((export_name("door_places"))) i64 entry_door_places(u8* request, i64 size) {
  return told(door_places({request, size}));
}

}  // namespace openings
