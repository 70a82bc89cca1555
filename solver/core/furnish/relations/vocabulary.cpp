// The vocabulary: every relation by its word.
#include "furnish/relations/against_wall.hpp"
#include "furnish/relations/aligned_with.hpp"
#include "furnish/relations/around.hpp"
#include "furnish/relations/at_side.hpp"
#include "furnish/relations/at_window.hpp"
#include "furnish/relations/centred.hpp"
#include "furnish/relations/facing.hpp"
#include "furnish/relations/far_from.hpp"
#include "furnish/relations/in_corner.hpp"
#include "furnish/relations/in_row.hpp"
#include "furnish/relations/near.hpp"
#include "furnish/relations/on.hpp"
#include "furnish/relations/opposite.hpp"

namespace furnish {

constexpr Side LEFT_RIGHT[] = {Side::left, Side::right};
constexpr Side FRONT[] = {Side::front};

static constexpr AgainstWall against_wall;
static constexpr InCorner in_corner;
static constexpr AtSide beside_it({LEFT_RIGHT, 2, 20, 0, false, {20, 280}, {0, 300}, Align::back}, true);
static constexpr AtSide in_front_of({FRONT, 1, 400, 0, false, {250, 650}, {0, 700}, Align::centre});
static constexpr AtSide under({FRONT, 1, -300, -10, true, {-10'000, -50}, {-10'000, -10}, Align::none});
static constexpr Opposite opposite;
static constexpr Facing facing_it;
static constexpr Near near(false), near_door(true);
static constexpr FarFrom far_from(false), far_from_door(true);
static constexpr Around around;
static constexpr AlignedWith aligned_with;
static constexpr Centred centred;
static constexpr InRow in_row;
static constexpr AtWindow at_window;
static constexpr On on;

// In the order of the enum.
static constexpr const Relation* RELATIONS[] = {
  &against_wall, &in_corner, &beside_it, &in_front_of, &opposite, &facing_it, &near, &far_from, &around,
  &aligned_with, &centred, &in_row, &at_window, &near_door, &far_from_door, &on, &under,
};
static_assert(sizeof(RELATIONS) / sizeof(RELATIONS[0]) == static_cast<i32>(Word::COUNT));

const Relation& relation_of(Word word) { return *RELATIONS[static_cast<i32>(word)]; }

}  // namespace furnish
