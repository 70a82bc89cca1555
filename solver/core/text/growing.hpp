// Text that grows, letter by letter and piece by piece.
#pragma once

#include "plain/tables.hpp"

namespace text {

constexpr i64 FARTHEST_MM = 1'000'000'000;  // metres with four decimals then have no more digits than a float keeps
constexpr i64 LONGEST_NUMBER = 32;
constexpr i64 WORD = 8;

inline Bytes word(const char* text) {
  i64 size = 0;
  while (text[size] != 0) size++;
  return {reinterpret_cast<u8*>(const_cast<char*>(text)), size};
}

class Text {
 public:
  void put(Bytes part) {
    reach(part.size);
    u8* to = data_ + size_;
    if (part.size > 4 * WORD) {
      __builtin_memcpy(to, part.data, static_cast<unsigned long>(part.size));
    } else {  // most are of a few letters
      for (i64 i = 0; i < part.size; i++) to[i] = part.data[i];
    }
    size_ += part.size;
  }
  void put(u8 letter) {
    reach(1);
    data_[size_++] = letter;
  }
  void whole(i64 number) {
    u8 digits[LONGEST_NUMBER];
    i64 at = LONGEST_NUMBER;
    u64 left = static_cast<u64>(magnitude(number));
    do digits[--at] = static_cast<u8>('0' + left % 10);
    while ((left /= 10) != 0);
    if (number < 0) digits[--at] = '-';
    put({digits + at, LONGEST_NUMBER - at});
  }
  // Half millimetres in metres, as Python writes a float.
  void metres(i64 halves) {
    if (magnitude(halves) > 2 * FARTHEST_MM) fail(Failure::bad_request);
    const i64 size = magnitude(halves);
    if (halves < 0) put('-');
    whole(size / 2000);
    i64 left = size % 2000 * 5, unit = 1000;
    put('.');
    do {
      put(static_cast<u8>('0' + left / unit));
      left %= unit;
      unit /= 10;
    } while (left != 0);
  }
  Bytes all() const { return {data_, size_}; }
  void clear() { size_ = 0; }

 private:
  void reach(i64 more) {
    if (size_ + more <= room_) return;
    room_ = 2 * (size_ + more) + 4096;
    u8* wider = static_cast<u8*>(arena::reserve(room_));
    if (size_ > 0) __builtin_memcpy(wider, data_, static_cast<unsigned long>(size_));
    data_ = wider;
  }

  u8* data_ = nullptr;
  i64 size_ = 0;
  i64 room_ = 0;
};

}  // namespace text
