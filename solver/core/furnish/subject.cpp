#include "furnish/subject.hpp"

namespace furnish {

List<i32> Subject::pieces(const Rule& rule) const {
  List<i32> found;
  for (const Name& name : type.of(rule)) {
    found.add_all(earlier.by_word[name.word].all());
  }
  return found;
}

i32 Subject::first(const Rule& rule) const {
  for (const Name& name : type.of(rule)) {
    if (earlier.by_word[name.word].size() > 0) return earlier.by_word[name.word][0];
  }
  return -1;
}

List<Parent> Subject::parents(const Rule& rule) const {
  List<Parent> found;
  for (i32 piece : pieces(rule)) {
    for (i32 kind : earlier.kinds[piece]) found.add({piece, kind});
  }
  return found;
}

bool share_a_name(Span<Name> some, Span<Name> others) {
  for (const Name& one : some) {
    for (const Name& other : others) {
      if (one.word == other.word) return true;
    }
  }
  return false;
}

bool Subject::faces(Span<Name> names) const {
  for (const Rule& rule : rules) {
    if (rule.word == Word::facing && share_a_name(type.of(rule), names)) return true;
  }
  return false;
}

bool Subject::faces(Opening opening) const {
  for (const Rule& rule : rules) {
    if (rule.word != Word::facing) continue;
    for (const Name& name : type.of(rule)) {
      if (name.opening == opening) return true;
    }
  }
  return false;
}

}  // namespace furnish
