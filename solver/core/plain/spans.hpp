// Views of memory that others own: a pointer and how much there is. A debug build (CORE_CHECKED) checks every index.
#pragma once

#include "memory.hpp"

#ifdef CORE_CHECKED
inline void check_index(i64 at, i64 size) {
  if (at < 0 || at >= size) fail(Failure::out_of_range);
}
#else
inline void check_index(i64, i64) {}
#endif

// A row of values or of structs.
template <class T> struct Span {
  T* data;
  i32 size;

  T& operator[](i64 at) const {
    check_index(at, size);
    return data[at];
  }
  T* begin() const { return data; }
  T* end() const { return data + size; }
};

// Structs of 8-byte fields: to the host a table of numbers with a column a field.
template <class T> struct Rows {
  T* data;
  i32 size;
  i32 columns;

  T& operator[](i64 at) const {
    check_index(at, size);
    return data[at];
  }
};

// One struct of 8-byte fields: to the host a row of numbers.
template <class T> struct One {
  T* data;
  i32 size;

  T* operator->() const { return data; }
};

// Values by row and column, one row after the other.
template <class T> struct Table {
  T* data;
  i32 rows;
  i32 columns;

  T& at(i64 row, i64 column) const {
    check_index(row, rows);
    check_index(column, columns);
    return data[row * columns + column];
  }
  Span<T> row(i64 row) const {
    check_index(row, rows);
    return {data + row * columns, columns};
  }
};

// Values by block, row and column.
template <class T> struct Cube {
  T* data;
  i32 blocks;
  i32 rows;
  i32 columns;

  T& at(i64 block, i64 row, i64 column) const { return data[offset(block, row) + checked(column)]; }
  Span<T> row(i64 block, i64 row) const { return {data + offset(block, row), columns}; }
  Table<T> block(i64 block) const { return {data + offset(block, 0), rows, columns}; }

 private:
  i64 offset(i64 block, i64 row) const {
    check_index(block, blocks);
    check_index(row, rows);
    return (block * rows + row) * columns;
  }
  i64 checked(i64 column) const {
    check_index(column, columns);
    return column;
  }
};

// Space in the arena for some values, not set to anything.
template <class T> Span<T> reserved(i32 size) { return {static_cast<T*>(arena::reserve(static_cast<i64>(size) * sizeof(T))), size}; }

// The same, all bytes 0.
template <class T> Span<T> zeroes(i32 size) { return {static_cast<T*>(arena::zeroed(static_cast<i64>(size) * sizeof(T))), size}; }

// The same for structs of 8-byte fields.
template <class T> Rows<T> reserved_rows(i64 count) {
  const Span<T> space = reserved<T>(static_cast<i32>(count));
  return {space.data, space.size, sizeof(T) / 8};
}
