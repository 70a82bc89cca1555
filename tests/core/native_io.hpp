// What the native program reads: the length of some bytes (8 bytes), and these.
#pragma once

#include <stdio.h>

#include "plain/tables.hpp"

// The next bytes of a file; none, at its end.
inline Bytes read_bytes(FILE* file) {
  i64 size;
  if (fread(&size, sizeof size, 1, file) != 1) return {nullptr, 0};
  u8* data = static_cast<u8*>(arena::reserve(size));
  if (static_cast<i64>(fread(data, 1, static_cast<unsigned long>(size), file)) != size) fail(Failure::bad_request);
  return {data, size};
}

// The next bytes of a file as one row.
template <class T> const T& read_row(FILE* file) {
  const Bytes row = read_bytes(file);
  if (row.size != sizeof(T)) fail(Failure::bad_request);
  return *reinterpret_cast<const T*>(row.data);
}
