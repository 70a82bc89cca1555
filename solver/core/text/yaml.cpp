#include "text/yaml.hpp"

#include "text/growing.hpp"

namespace text {

namespace {

constexpr i32 DEEPEST = 128;  // levels; documents have at most 64
constexpr i64 LONG_KEY = 1000;  // a longer key is marked by a question mark: without it YAML ends keys after 1,024 letters

bool is_one_of(u8 letter, const char* letters) {
  for (; *letters != 0; letters++) {
    if (letter == static_cast<u8>(*letters)) return true;
  }
  return false;
}

u8 lower(u8 letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<u8>(letter + ('a' - 'A')) : letter; }

bool begins_word(u8 letter) { return (lower(letter) >= 'a' && lower(letter) <= 'z') || letter == '_'; }

// Letters by whether words that need no quotes go on with them, in bits of 64.
struct WordLetters {
  u64 bits[4] = {};

  constexpr WordLetters() {
    for (const char* letter = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./|@+-"; *letter != 0; letter++) {
      bits[*letter / 64] |= u64{1} << *letter % 64;
    }
  }
};

constexpr WordLetters WORD_LETTERS;

bool is_in_word(u8 letter) { return WORD_LETTERS.bits[letter >> 6] >> (letter & 63) & 1; }

// Words that YAML 1.1 or 1.2 takes for something else than a text.
bool is_reserved(Bytes text) {
  constexpr const char* WORDS[] = {"null", "true", "false", "yes", "no", "on", "off"};
  constexpr i64 LONGEST = 5;
  if (text.size > LONGEST) return false;
  for (const char* one : WORDS) {
    const Bytes reserved = word(one);
    i64 same = 0;
    while (same < text.size && same < reserved.size && lower(text.data[same]) == reserved.data[same]) same++;
    if (same == text.size && same == reserved.size) return true;
  }
  return false;
}

// Plain words with single spaces between them, which need no quotes.
bool is_plain(Bytes text) {
  if (text.size == 0 || !begins_word(text.data[0])) return false;
  for (i64 i = 1; i < text.size; i++) {
    const bool is_gap = text.data[i] == ' ' && text.data[i - 1] != ' ' && i + 1 < text.size;
    if (!is_gap && !is_in_word(text.data[i])) return false;
  }
  return !is_reserved(text);
}

// A letter that takes more than one byte, or one: which it is, and how many bytes.
struct Letter {
  i32 code;
  i64 size;
};

Letter letter_at(const u8* at, const u8* end) {
  const i64 size = *at < 0x80 ? 1 : *at < 0xe0 ? 2 : *at < 0xf0 ? 3 : 4;
  if (end - at < size) fail(Failure::bad_request);
  i32 code = size == 1 ? *at : *at & (0xff >> (size + 1));
  for (i64 i = 1; i < size; i++) code = code << 6 | (at[i] & 0x3f);
  return {code, size};
}

// Letters that do not stand for themselves between quotes.
bool is_escaped(i32 code) {
  return code < 0x20 || code == '"' || code == '\\' || (code >= 0x7f && code <= 0x9f) || code == 0x2028 || code == 0x2029 ||
         code == 0xfeff || code >= 0xfffe;
}

void put_hex(Text& to, i32 code, i32 digits) {
  for (i32 i = digits - 1; i >= 0; i--) to.put(static_cast<u8>("0123456789ABCDEF"[code >> (4 * i) & 15]));
}

void put_escaped(Text& to, i32 code) {
  to.put('\\');
  if (code == '"' || code == '\\') return to.put(static_cast<u8>(code));
  if (code == '\n' || code == '\t') return to.put(code == '\n' ? 'n' : 't');
  to.put(code < 0x100 ? 'x' : code < 0x10000 ? 'u' : 'U');
  put_hex(to, code, code < 0x100 ? 2 : code < 0x10000 ? 4 : 8);
}

void put_text(Text& to, Bytes text) {
  if (is_plain(text)) return to.put(text);
  to.put('"');
  const u8* end = text.data + text.size;
  for (u8* at = text.data; at < end;) {
    const Letter letter = letter_at(at, end);
    is_escaped(letter.code) ? put_escaped(to, letter.code) : to.put({at, letter.size});
    at += letter.size;
  }
  to.put('"');
}

void put_utf8(Text& to, i32 code) {
  const i32 more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  const i32 marks[] = {0, 0xc0, 0xe0, 0xf0};
  to.put(static_cast<u8>(marks[more] | code >> (6 * more)));
  for (i32 i = more - 1; i >= 0; i--) to.put(static_cast<u8>(0x80 | (code >> (6 * i) & 0x3f)));
}

// JSON as it is read.
class Json {
 public:
  explicit Json(Bytes text) : at_(text.data), end_(text.data + text.size) {}

  // The next letter that is no space.
  u8 next() {
    while (at_ < end_ && *at_ <= ' ' && is_one_of(*at_, " \n\r\t")) at_++;
    return at_ < end_ ? *at_ : 0;
  }
  bool is_at_end() { return next() == 0 && at_ == end_; }
  bool takes(u8 letter) {
    const bool is_there = next() == letter && at_ < end_;
    at_ += is_there;
    return is_there;
  }
  void take(u8 letter) {
    if (!takes(letter)) fail(Failure::bad_request);
  }
  // Takes a comma, or what ends a list or mapping; tells whether more follows.
  bool goes_on(u8 last) {
    if (takes(',')) return true;
    take(last);
    return false;
  }
  // A number, true, false or null.
  Bytes scalar() {
    next();
    u8* from = at_;
    while (at_ < end_ && (is_in_word(*at_))) at_++;
    if (at_ == from) fail(Failure::bad_request);
    return {from, at_ - from};
  }
  // A text; good until the next is read.
  Bytes text() {
    take('"');
    u8* from = at_;
    while (here() != '"' && *at_ != '\\') at_++;
    if (*at_ == '"') return {from, at_++ - from};
    unescaped_.clear();
    unescaped_.put({from, at_ - from});
    while (here() != '"') {
      if (*at_ == '\\') {
        at_++;
        unescape();
      } else {
        unescaped_.put(*at_++);
      }
    }
    at_++;
    return unescaped_.all();
  }
  // Whether what comes next reads well on one line: a scalar, or a mapping or list of scalars and lists of scalars.
  bool is_flat() {
    const u8 first = next();
    if (first != '{' && first != '[') return true;
    i32 depth = 1;
    for (const u8* at = at_ + 1; at < end_; at++) {
      if (*at == '"') {
        for (at++; at < end_ && *at != '"'; at++) at += *at == '\\';
      } else if (*at == '{' || (*at == '[' && ++depth > 2)) {
        return false;
      } else if ((*at == ']' || *at == '}') && --depth == 0) {
        return true;
      }
    }
    fail(Failure::bad_request);
  }

 private:
  u8 here() const {
    if (at_ >= end_) fail(Failure::bad_request);
    return *at_;
  }
  i32 four_digits() {
    i32 code = 0;
    for (i32 i = 0; i < 4; i++) {
      const u8 digit = lower(here());
      if (!(digit >= '0' && digit <= '9') && !(digit >= 'a' && digit <= 'f')) fail(Failure::bad_request);
      code = code << 4 | static_cast<i32>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
      at_++;
    }
    return code;
  }
  void unescape() {
    constexpr char LETTERS[] = "bfnrt", MEANT[] = "\b\f\n\r\t";
    const u8 letter = here();
    at_++;
    for (i32 i = 0; i < 5; i++) {
      if (letter == static_cast<u8>(LETTERS[i])) return unescaped_.put(static_cast<u8>(MEANT[i]));
    }
    if (is_one_of(letter, "\"\\/")) return unescaped_.put(letter);
    if (letter != 'u') fail(Failure::bad_request);
    i32 code = four_digits();
    if (code >= 0xd800 && code < 0xe000) {  // a letter in two halves
      if (code >= 0xdc00 || here() != '\\' || *++at_ != 'u') fail(Failure::bad_request);
      at_++;
      const i32 low = four_digits();
      if (low < 0xdc00 || low >= 0xe000) fail(Failure::bad_request);
      code = 0x10000 + ((code - 0xd800) << 10 | (low - 0xdc00));
    }
    put_utf8(unescaped_, code);
  }

  u8* at_;
  u8* end_;
  Text unescaped_;
};

class Yaml {
 public:
  explicit Yaml(Bytes json) : json_(json) {}

  Bytes answer() {
    value(0);
    if (!json_.is_at_end()) fail(Failure::bad_request);
    written_.put('\n');
    return written_.all();
  }

 private:
  void value(i32 indent) { json_.is_flat() ? flow() : block(indent); }

  // What is not flat, its first line where the text is now, its further ones indented.
  void block(i32 indent) {
    if (indent > 2 * DEEPEST) fail(Failure::bad_request);
    if (json_.takes('[')) {
      do {
        written_.put(word("- "));
        value(indent + 2);
      } while (json_.goes_on(']') && line(indent));
    } else {
      json_.take('{');
      do {
        key(indent);
        under_key(indent);
      } while (json_.goes_on('}') && line(indent));
    }
  }

  void under_key(i32 indent) {
    if (json_.is_flat()) {
      written_.put(' ');
      return flow();
    }
    const i32 inner = json_.next() == '[' ? indent : indent + 2;
    line(inner);
    block(inner);
  }

  // Writes a value on one line.
  void flow() {
    const u8 first = json_.next();
    if (first == '"') return put_text(written_, json_.text());
    if (first != '[' && first != '{') return scalar(json_.scalar());
    const u8 last = first == '[' ? ']' : '}';
    json_.take(first);
    written_.put(first);
    if (!json_.takes(last)) {
      do {
        if (first == '{') key(-1), written_.put(' ');
        flow();
      } while (json_.goes_on(last) && comma());
    }
    written_.put(last);
  }

  // A number of YAML 1.1 has a point.
  void scalar(Bytes text) {
    i64 at = 0;
    while (at < text.size && text.data[at] != 'e' && text.data[at] != '.') at++;
    const bool needs_point = at < text.size && text.data[at] == 'e' && !begins_word(text.data[0]);
    written_.put({text.data, at});
    if (needs_point) written_.put(word(".0"));
    written_.put({text.data + at, text.size - at});
  }

  // Writes a key and its colon; `indent`: of the line that a long one's colon gets, below 0 where all is on one line.
  void key(i32 indent) {
    const Bytes text = json_.text();
    i64 letters = 0;
    for (i64 i = 0; i < text.size; i++) letters += (text.data[i] & 0xc0) != 0x80;
    if (letters > LONG_KEY) written_.put(word("? "));
    put_text(written_, text);
    if (letters > LONG_KEY) indent < 0 ? written_.put(' ') : static_cast<void>(line(indent));
    written_.put(':');
    json_.take(':');
  }

  bool line(i32 indent) {
    written_.put('\n');
    for (i32 i = 0; i < indent; i++) written_.put(' ');
    return true;
  }
  bool comma() {
    written_.put(word(", "));
    return true;
  }

  Json json_;
  Text written_;
};

}  // namespace

Bytes yaml_text(Bytes json) { return Yaml(json).answer(); }

}  // namespace text
