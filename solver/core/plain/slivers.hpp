// Slivers: gaps that are no contact, and in which no hand comes.
#pragma once

#include "plain/numbers.hpp"

constexpr i64 TOUCHING_MM = 50, SLIVER_MM = 150;
