// Rows that grow, in the arena, and their stable sorting.
#pragma once

#include "spans.hpp"

// A row that grows: room is doubled where it is full; what it had is given back with the arena.
template <class T> class List {
 public:
  T& add(const T& value) {
    if (size_ == room_) grow(most(8, 2 * room_));
    return data_[size_++] = value;
  }
  void add_all(Span<T> values) {
    while (room_ - size_ < values.size) grow(most(8, 2 * room_));
    copy(values.data, data_ + size_, values.size);
    size_ += values.size;
  }
  // Makes room for so many in all.
  void reserve(i32 room) {
    if (room > room_) grow(room);
  }
  void cut(i32 size) { size_ = least(size, size_); }
  T& operator[](i64 at) const {
    check_index(at, size_);
    return data_[at];
  }
  i32 size() const { return size_; }
  Span<T> all() const { return {data_, size_}; }
  T* begin() const { return data_; }
  T* end() const { return data_ + size_; }

 private:
  void grow(i32 room) {
    if (room_ > (1 << 24)) fail(Failure::memory_full);
    room_ = room;
    T* wider = reserved<T>(room_).data;
    copy(data_, wider, size_);
    data_ = wider;
  }
  static void copy(const T* from, T* to, i32 count) {
    static_assert(__is_trivially_copyable(T));
    if (count > 0) __builtin_memcpy(to, from, static_cast<unsigned long>(count) * sizeof(T));
  }

  T* data_ = nullptr;
  i32 size_ = 0;
  i32 room_ = 0;
};

// Keeps, in their order, the values that are wanted.
template <class T, class Wanted> void keep_where(List<T>& values, Wanted is_wanted) {
  i32 kept = 0;
  for (const T& one : values) {
    if (is_wanted(one)) values[kept++] = one;
  }
  values.cut(kept);
}

// Keeps of equal values side by side the first.
template <class T> void keep_once(List<T>& values) {
  const T* last = nullptr;
  keep_where(values, [&](const T& one) {
    const bool is_new = last == nullptr || !(one == *last);
    last = &one;
    return is_new;
  });
}

template <class T> bool has(const Span<T>& values, const T& value) {
  for (const T& one : values) {
    if (one == value) return true;
  }
  return false;
}

template <class T> void add_new(List<T>& values, const T& value) {
  if (!has(values.all(), value)) values.add(value);
}

// How many values, of a row that begins with those that are before something, are.
template <class T, class Before> i32 count_before(const Span<T>& values, Before is_before) {
  i32 low = 0, high = values.size;
  while (low < high) {
    const i32 middle = (low + high) / 2;
    if (is_before(values[middle])) low = middle + 1;
    else high = middle;
  }
  return low;
}

// Sorts so that equals keep their order; `before(a, b)` tells whether a goes before b.
template <class T, class Before> void stable_sort(Span<T> values, Before before) {
  constexpr i32 FEW = 16;
  if (values.size <= FEW) {
    for (i32 i = 1; i < values.size; i++) {
      const T value = values[i];
      i32 at = i;
      for (; at > 0 && before(value, values.data[at - 1]); at--) values.data[at] = values.data[at - 1];
      values.data[at] = value;
    }
    return;
  }
  const i32 half = values.size / 2;
  const Span<T> low{values.data, half}, high{values.data + half, values.size - half};
  stable_sort(low, before);
  stable_sort(high, before);
  arena::Scope scope;
  const Span<T> kept = reserved<T>(half);
  for (i32 i = 0; i < half; i++) kept.data[i] = low.data[i];
  i32 i = 0, j = 0;
  for (i32 at = 0; i < half; at++) {
    const bool from_high = j < high.size && before(high.data[j], kept.data[i]);
    values.data[at] = from_high ? high.data[j++] : kept.data[i++];
  }
}
