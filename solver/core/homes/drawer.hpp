// Draws drafts: gives their strips depths, and their rooms rectangles.
#pragma once

#include "homes/drafts.hpp"
#include "plain/streams.hpp"

namespace homes {

// How often depths are drawn until those of strips side by side go together.
constexpr i32 CHOICES = 4;

// Two strips of one length: the spans of their columns, and the lengths both may have, mm.
struct StripPair {
  WidthRange spans[2][MOST_ROOMS];
  i32 count[2];
  i64 low, wished, high;

  Span<const WidthRange> row(i32 k) const { return {spans[k], count[k]}; }
};

// A strip on the plan: where it starts along u, its inner line across, and its depth: positive where it lies before that line, negative
// where it lies behind.
struct StripPlace {
  i64 at, line, depth;
};

// Draws the drafts of one programme in one frame. `wished` is a strip's depth in a house of the rooms' typical areas, mm.
class Drawer {
 public:
  Drawer(Columns& columns, Frame frame, f64 wished) : columns_(columns), frame_(frame), wished_(wished) {}

  // Gives the strips depths at which all their columns have a width, pairs of strips about one length. A strip whose columns have no such
  // depth in common takes what the others leave it.
  void choose_depths(Draft& draft, Stream& stream) const;

  // Makes a changed draft's depths add up to what the frame and its kind ask for, near to what its columns can have.
  void fit_depths(Draft& draft) const;

  // Draws a draft whose depths fit; with `stretch` even where its strips do not come out: rooms then miss their limits.
  Misfit draw(const Draft& draft, bool stretch, Sheet& sheet) const;

 protected:
  bool choose_pair(Draft& draft, i32 first, i64 together, Stream& stream) const;
  i64 drawn_near(const DepthList& depths, Stream& stream) const;
  u64 possible(const Draft& draft, i32 strip) const;
  void spans_of(const Draft& draft, i32 strip, StripPair& pair) const;
  Misfit pair(const Draft& draft, i32 first, bool stretch, StripPair& pair) const;
  void lay(Span<const Column> strip, const i64* widths, StripPlace place, Sheet& sheet) const;
  static void share(i64* depths, i32 first, i64 together);

  Columns& columns_;
  Frame frame_;
  f64 wished_;

 private:
  i64 hallway_of(Kind kind) const;
  i64 across(Kind kind) const;
  static void close(Draft& draft, i64 across);
  Misfit drawn(const Draft& draft, Span<const StripPair> pairs, bool stretch, Sheet& sheet) const;
  void turn(const Draft& draft, Sheet& sheet) const;
};

// Draws drafts whose outline is no rectangle: each pair of strips has its own depth, and a wing slides along the public block as far as its
// hallway meets it; of rows each strip has its own length.
class BentDrawer : public Drawer {
 public:
  // `garages` lie at the end of the first of two wings.
  BentDrawer(Columns& columns, f64 wished, Outline outline, Span<const i32> garages)
      : Drawer(columns, {0, 0}, wished), outline_(outline), garages_(garages) {}

  void choose_depths(Draft& draft, Stream& stream) const;
  void fit_depths(Draft& draft) const;
  Misfit draw(const Draft& draft, Sheet& sheet) const;

 private:
  void choose_pair(Draft& draft, i32 first, Stream& stream) const;
  void choose_public(Draft& draft, Stream& stream) const;
  void make_flush(Draft& draft) const;
  Misfit winged(const Draft& draft, Span<const StripPair> pairs, const i64* chosen, Sheet& sheet) const;
  void block(const Draft& draft, i32 which, const StripPair& pair, Point corner, Sheet& sheet) const;
  Misfit rows(const Draft& draft, Sheet& sheet) const;

  Outline outline_;
  Span<const i32> garages_;
};

// Draws drafts with blocks: each is a house of its own in a fixed frame.
class GivenDrawer {
 public:
  GivenDrawer(Columns& columns, f64 wished) : columns_(columns), wished_(wished) {}

  void choose_depths(Draft& draft, Stream& stream) const;
  void fit_depths(Draft& draft) const;
  // Rooms miss their limits where strips do not come out; a draft with a block without rooms is a misfit.
  Misfit draw(const Draft& draft, Sheet& sheet) const;

 private:
  Drawer drawer(const Block& block) const { return {columns_, {block.along(), block.across()}, wished_}; }
  Misfit draw_block(const Block& block, const Draft& part, Sheet& drawn) const;

  Columns& columns_;
  f64 wished_;
};

}  // namespace homes
