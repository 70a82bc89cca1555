#include "text/bodies.hpp"

#include "plain/lists.hpp"
#include "text/growing.hpp"

namespace text {

namespace {

struct Look {
  Span<Piece> pieces;
  u8* text;
  Bytes name;
};

// Bodies of one sort in a room.
struct Told {
  Bytes room;  // its id without the closing quote
  Span<ToldBody> bodies;
  Span<i64> looks, colours;
};

class Writing {
 public:
  explicit Writing(Bytes rows) : reader_(rows.data, rows.size), header_(reader_.take<TextsRow>(1)[0]) {
    const Span<i64> sizes = reader_.take<i64>(header_.texts);
    i64 all = 0;
    for (const i64 size : sizes) all += checked(size);
    u8* at = bytes(all);
    for (const i64 size : sizes) texts_.add({at, size}), at += size;
    for (i32 i = 0; i < header_.looks; i++) read_look();
    worn_looks_ = reader_.take<i64>(header_.bodies), colours_ = reader_.take<i64>(header_.bodies);
    for (const i64 look : worn_looks_) {
      if (look < 0 || look >= looks_.size()) fail(Failure::bad_request);
    }
  }

  Bytes answer() {
    const Span<i64> sizes = reserved<i64>(header_.sorts);
    for (i64& size : sizes) {
      const i64 before = written_.all().size;
      write_sort();
      size = written_.all().size - before;
    }
    const Bytes text = written_.all();
    Writer writer(bytes_of(sizes) + text.size);
    writer.put(sizes);
    writer.put(Span<u8>{text.data, static_cast<i32>(text.size)});
    return writer.written();
  }

 private:
  static i64 checked(i64 size) {
    if (size < 0 || size > 1 << 28) fail(Failure::bad_request);
    return size;
  }
  u8* bytes(i64 size) { return reader_.take<u8>(static_cast<i32>(checked(size))).data; }
  Bytes text(i64 number) const {
    if (number < 0 || number >= texts_.size()) fail(Failure::bad_request);
    return texts_[number];
  }

  void read_look() {
    const LookRow& row = reader_.take<LookRow>(1)[0];
    const Span<Piece> pieces = reader_.take<Piece>(static_cast<i32>(checked(row.pieces)));
    i64 size = 0;
    for (const Piece& piece : pieces) size += checked(piece.size);
    if (size != row.size) fail(Failure::bad_request);
    u8* text = bytes(row.size);
    looks_.add({pieces, text, {bytes(row.name_size), row.name_size}});
  }

  void write_sort() {
    const BodiesRow& row = reader_.take<BodiesRow>(1)[0];
    const Bytes room = text(row.room);
    if (room.size < 1) fail(Failure::bad_request);
    const Range worn{begun_, row.bodies};
    begun_ += row.bodies;
    const Told told{{room.data, room.size - 1}, reader_.take<ToldBody>(row.bodies), part_of(worn_looks_, worn), part_of(colours_, worn)};
    is_before_ = row.carriers < 0;
    carriers_ = reader_.take<i64>(is_before_ ? 0 : row.carriers);
    write(told);
    before_ = told;
  }

  void write(const Told& told) {
    written_.put('[');
    for (i32 i = 0; i < told.bodies.size; i++) {
      if (i > 0) written_.put(',');
      const Look& look = looks_[told.looks[i]];
      u8* at = look.text;
      for (const Piece& piece : look.pieces) {
        written_.put({at, piece.size});
        at += piece.size;
        fill(told, i, piece.gap);
      }
    }
    written_.put(']');
  }

  void fill(const Told& told, i32 number, Gap gap) {
    const ToldBody& body = told.bodies[number];
    switch (gap) {
      case Gap::id: return own_id(told, number);
      case Gap::on: return id(told, body.on);
      case Gap::under: return id(told, body.under);
      case Gap::wall: return wall(body.wall);
      case Gap::x: return written_.metres(body.rect.x0 + body.rect.x1);
      case Gap::y: return written_.metres(2 * body.low);
      case Gap::z: return written_.metres(body.rect.z0 + body.rect.z1);
      case Gap::rotation: return written_.whole(body.rotation);
      case Gap::colour: return written_.put(text(told.colours[number]));
      case Gap::none: return;
    }
    fail(Failure::bad_request);
  }

  void own_id(const Told& told, i32 number) {
    written_.put(told.room);
    written_.put('/');
    written_.put(looks_[told.looks[number]].name);
    written_.put('_');
    written_.whole(told.bodies[number].number);
    written_.put('"');
  }

  void id(const Told& told, i32 number) {
    const i32 carriers = is_before_ ? before_.bodies.size : carriers_.size, own = number - carriers;
    if (number < 0) return written_.put(word("null"));
    if (own >= told.bodies.size) fail(Failure::bad_request);
    if (own >= 0) return own_id(told, own);
    return is_before_ ? own_id(before_, number) : written_.put(text(carriers_[number]));
  }

  void wall(i32 number) {
    constexpr const char* NAMES[] = {"\"north\"", "\"south\"", "\"east\"", "\"west\""};
    written_.put(word(number >= 0 && number < 4 ? NAMES[number] : "null"));
  }

  Reader reader_;
  const TextsRow& header_;
  List<Bytes> texts_;
  List<Look> looks_;
  Span<i64> worn_looks_ = {}, colours_ = {};  // of the bodies of all sorts
  i32 begun_ = 0;                             // the first body of the sort that is read
  Told before_ = {};                          // the sort before
  bool is_before_ = false;                    // that carries what is written
  Span<i64> carriers_ = {};                   // the ids of what carries it otherwise
  Text written_;
};

}  // namespace

Bytes bodies_text(Bytes rows) { return Writing(rows).answer(); }

}  // namespace text
