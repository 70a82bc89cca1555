// What the host sends and is answered: tables of plain structs, one after the other.
#pragma once

#include "spans.hpp"

struct Bytes {
  u8* data;
  i64 size;
};

// An answer as the host takes it: its size, bytes, in the upper half, and where it begins in the lower.
inline i64 told(Bytes answer) { return answer.size << 32 | static_cast<i64>(reinterpret_cast<u64>(answer.data)); }

// Bytes of the memory as the host tells of them, and is told.
struct SentBytes {
  u64 address;
  i64 size;

  Bytes bytes() const { return {reinterpret_cast<u8*>(static_cast<unsigned long>(address)), size}; }
};

// Moves an answer down to where the work on it began, whose memory is given back.
inline Bytes moved_down(arena::Mark begun, Bytes answer) {
  arena::release(begun);
  u8* kept = static_cast<u8*>(arena::reserve(answer.size));
  __builtin_memmove(kept, answer.data, static_cast<unsigned long>(answer.size));
  return {kept, answer.size};
}

// Rows of another table: the first, and how many.
struct Range {
  i32 first;
  i32 count;
};

template <class T> Span<T> part_of(Span<T> table, Range range) {
  if (range.first < 0 || range.count < 0 || range.first > table.size - range.count) fail(Failure::bad_request);
  return {table.data + range.first, range.count};
}

// Reads tables out of bytes, each of which begins at a multiple of 8; a table that reaches beyond them ends the call.
class Reader {
 public:
  Reader(u8* data, i64 size) : data_(data), left_(size) {}
  explicit Reader(Bytes rows) : Reader(rows.data, rows.size) {}

  template <class T> Span<T> take(i32 count) {
    const i64 bytes = (static_cast<i64>(count) * sizeof(T) + 7) / 8 * 8;
    if (count < 0 || bytes > left_) fail(Failure::bad_request);
    T* found = reinterpret_cast<T*>(data_);
    data_ += bytes;
    left_ -= bytes;
    return {found, count};
  }
  bool is_at_end() const { return left_ == 0; }

 private:
  u8* data_;
  i64 left_;
};

template <class T> i64 bytes_of(Span<T> rows) { return static_cast<i64>(rows.size) * sizeof(T); }
template <class T> Bytes as_bytes(Span<T> rows) { return {reinterpret_cast<u8*>(rows.data), bytes_of(rows)}; }

// Puts tables into new bytes, one right after the other.
class Writer {
 public:
  explicit Writer(i64 size) : start_(static_cast<u8*>(arena::reserve(size))), at_(start_) {}

  template <class T> void put(Span<T> rows) {
    if (rows.size == 0) return;
    const i64 bytes = bytes_of(rows);
    __builtin_memcpy(at_, rows.data, static_cast<unsigned long>(bytes));
    at_ += bytes;
  }
  Bytes written() const { return {start_, at_ - start_}; }

 private:
  u8* start_;
  u8* at_;
};
