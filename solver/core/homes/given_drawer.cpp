#include "homes/drawer.hpp"

namespace homes {

namespace {

// The house of its own that a block is: its strips begin with one of the draft's.
void take_part(const Draft& draft, const Block& block, i32 first, Draft& part) {
  part.kind = block.kind;
  part.strips = part.columns = 0;
  for (i32 k = first; k < first + block.strips(); k++) part.add_strip(draft.in(k), draft.depth[k]);
}

}  // namespace

void GivenDrawer::choose_depths(Draft& draft, Stream& stream) const {
  i32 first = 0;
  for (const Block& block : draft.blocks) {
    Draft part;
    take_part(draft, block, first, part);
    drawer(block).choose_depths(part, stream);
    for (i32 k = 0; k < part.strips; k++) draft.depth[first++] = part.depth[k];
  }
}

void GivenDrawer::fit_depths(Draft& draft) const {
  i32 first = 0;
  for (const Block& block : draft.blocks) {
    Draft part;
    take_part(draft, block, first, part);
    drawer(block).fit_depths(part);
    for (i32 k = 0; k < part.strips; k++) draft.depth[first++] = part.depth[k];
  }
}

Misfit GivenDrawer::draw(const Draft& draft, Sheet& sheet) const {
  sheet.begin(columns_.rooms());
  i32 first = 0;
  for (const Block& block : draft.blocks) {
    Draft part;
    Sheet drawn;
    take_part(draft, block, first, part);
    const Misfit misfit = draw_block(block, part, drawn);
    if (!misfit.fits) return misfit;
    for (i32 i = 0; i < drawn.hallways; i++) sheet.add_hallway(block.placed(drawn.boxes[drawn.rooms + i]));
    for (i32 i = 0; i < part.columns; i++) {
      for (i32 k = 0; k < part.column[i].size; k++) {
        const i32 room = part.column[i].rooms[k];
        sheet.boxes[room] = block.placed(drawn.boxes[room]);
      }
    }
    first += block.strips();
  }
  for (const Rect& box : sheet.all()) {
    if (box.width() <= 0 || box.depth() <= 0) return Misfit::by(columns_.rooms(), 0);
    sheet.width = most(sheet.width, box.x1);
    sheet.depth = most(sheet.depth, box.z1);
  }
  return Misfit::none();
}

Misfit GivenDrawer::draw_block(const Block& block, const Draft& part, Sheet& drawn) const {
  i32 empty = 0;
  for (i32 first = 0; first < part.strips; first += 2) empty += part.is_empty(first) && part.is_empty(first + 1);
  if (empty) return Misfit::by(columns_.rooms() * empty, 0);
  const Drawer drawer = this->drawer(block);
  return drawer.draw(part, false, drawn).fits ? Misfit::none() : drawer.draw(part, true, drawn);
}

}  // namespace homes
