// What a drawn home costs: one number, lower is better; a person's reasons, weighted by our choice.
#pragma once

#include "homes/drafts.hpp"
#include "homes/programme.hpp"

namespace homes {

// What a home costs; how many of its rooms are short of their limits, cannot be entered as they should, miss the street, are dark.
struct HomeVerdict {
  f64 cost;
  i64 short_rooms, unreached, streetless, dark;
};

// What outlines cost nothing (width over depth, least and most), and what a habitable room without an outside wall costs.
struct Taste {
  f64 low, high, dark;
};

// Judges the drawings of one programme. Rooms, and the hallways behind them, are bits of a number.
class Judge {
 public:
  Judge(Span<const PlannedRoom> rooms, Taste taste, i64 door_wall);

  HomeVerdict verdict(const Sheet& sheet);

 private:
  struct Ways {
    i64 unreached, at_entrance, others, off_living, past_kitchen, bathless, past_living;
    bool between;
  };
  // How long the walls of a room are, in the order of Wall, that other rooms lie at.
  void look(const Sheet& sheet);
  void meet(i32 i, i32 j, Wall wall, Interval shared);
  f64 sizes(const Sheet& sheet, i64& short_rooms) const;
  f64 outline(const Sheet& sheet) const;
  f64 company() const;
  f64 smallness(const Sheet& sheet) const;
  Ways access(const Sheet& sheet) const;
  u64 beside_of(u64 rooms) const;
  u64 reached(u64 ways, u64 start) const;
  bool is_behind(i32 room, u64 reached) const;
  bool is_lit(const Rect& box, i32 room) const;

  Span<const PlannedRoom> rooms_;
  Taste taste_;
  i64 door_wall_;
  u64 ways_ = 0, wet_ = 0, entry_ = 0, kitchen_ = 0, dining_ = 0, living_ = 0, leaves_ = 0, beds_ = 0, toilets_ = 0, suites_ = 0;
  u64 beside_[2 * MOST_ROOMS];  // which others share a wall with a room that takes a door
  // The stretches at which others lie, by room and wall.
  Interval covered_[MOST_ROOMS][4][2 * MOST_ROOMS];
  i32 covers_[MOST_ROOMS][4];
};

}  // namespace homes
