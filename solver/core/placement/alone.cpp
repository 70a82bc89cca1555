#include "placement/alone.hpp"

namespace placement {

constexpr DifferenceRow VOID = {0, ORIGIN, ORIGIN, 0};  // a row that always holds

static bool is_person(const Part& part) { return part.stand != 0 && part.stand != EMPTY_FLOOR; }

// Tells whether a variable places a body, or is none.
static bool is_of_bodies(const Work& work, i64 axis, i64 variable) {
  if (variable == ORIGIN) return true;
  for (i64 k = 0; k < work.counts->parts; k++) {
    if (!is_person(work.parts[k]) && work.parts[k].variable[axis] == variable) return true;
  }
  return false;
}

Work without_persons(const Work& work) {
  Work alone = work;
  alone.rows = reserved_rows<DifferenceRow>(work.counts->rows);
  alone.choice_size = reserved<i64>(static_cast<i32>(work.counts->choices));
  alone.options = reserved_rows<DifferenceRow>(OPTIONS * work.counts->choices);
  for (i64 k = 0; k < work.counts->rows; k++) {
    const DifferenceRow& row = work.rows[k];
    alone.rows[k] = is_of_bodies(work, row.axis, row.i) && is_of_bodies(work, row.axis, row.j) ? row : VOID;
  }
  for (i64 c = 0; c < work.counts->choices; c++) {
    const i64 first = work.choice_parts[c].part[0], second = work.choice_parts[c].part[1];
    if (is_person(work.parts[first]) || (second >= 0 && is_person(work.parts[second]))) {
      alone.choice_size[c] = 1;
      alone.options[OPTIONS * c] = VOID;
      continue;
    }
    alone.choice_size[c] = work.choice_size[c];
    for (i64 k = OPTIONS * c; k < OPTIONS * c + work.choice_size[c]; k++) alone.options[k] = work.options[k];
  }
  return alone;
}

}  // namespace placement
