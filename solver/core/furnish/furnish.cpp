#include "furnish/furnish.hpp"

#include "furnish/demanded.hpp"
#include "furnish/runs.hpp"

namespace furnish {

namespace {

// The answer's beginning; counts, pieces, candidates and links follow.
struct AnswerHeader {
  u64 first;  // of a room type, the stream's state at the end
  i32 counted, pieces, candidates, links;
};

}  // namespace

Scope read_room(Reader& reader, RoomHeader& header) {
  header = reader.take<RoomHeader>(1)[0];
  Scope scope{header.clear, header.gap, header.exterior, reader.take<Opened>(header.openings), reader.take<Zone>(header.zones)};
  scope.approaches = reader.take<Rect>(header.approaches);
  for (const Opened& one : scope.openings) {
    const i32 wall = static_cast<i32>(one.wall);
    if (wall < 0 || wall > 3) fail(Failure::bad_request);
  }
  return scope;
}

static void add_pieces(Furnisher& furnisher, const RoomType& type, const List<CountedPiece>& counted, Span<Candidate> run, Stream& stream) {
  for (const CountedPiece& one : counted) {
    const i32 word = type.pieces[one.spec].word;
    const bool planned = run.size > 0 && run[word].kind >= 0;
    if (!planned && run.size > 0 && !type.pieces[one.spec].required && has(type.words, word)) continue;  // the run has no room for it
    for (i32 number = 1; number <= one.copies; number++) {
      const Preferences preferences(stream);
      if (!furnisher.add(one, number, preferences, planned ? &run[word] : nullptr)) break;
    }
  }
}

// A room type as it is in a room of that area: what is required from some area on is optional below it.
static RoomType of_area(const RoomType& type, f64 area) {
  RoomType own = type;
  own.pieces = reserved<PieceSpec>(type.pieces.size);
  for (i32 k = 0; k < own.pieces.size; k++) {
    PieceSpec& piece = own.pieces[k] = type.pieces[k];
    if (!piece.required) continue;
    piece.required = area >= piece.min_area;
    piece.min_area = 0.0;
  }
  return own;
}

static WantedRows with_insisted(const RoomHeader& room, const WantedRows& wanted) {
  for (i32 k = 0; k < wanted.pieces.size; k++) {
    const PieceRow& row = wanted.pieces[k];
    const bool is_asked = row.spec == room.insisted_spec && row.number == room.insisted_number;
    if (row.floor_side < 0 && is_asked) return demanded(wanted, k);
  }
  return wanted;
}

Wanted wanted_in(const RoomType& any, const RoomHeader& room, const Scope& scope) {
  const RoomType type = of_area(any, room.area);
  WallOccupancy walls(scope);
  Furnisher furnisher(scope, type, walls);
  Stream stream(room.stream);
  const List<CountedPiece> counted = counted_pieces(type, room.area, stream);
  const Span<Candidate> run = type.has_run ? planned_run(scope, walls, type, counted, stream) : Span<Candidate>{};
  add_pieces(furnisher, type, counted, run, stream);
  const WantedRows wanted = with_comfort(scope, type, {furnisher.pieces.all(), furnisher.candidates.all(), furnisher.links.all()});
  return {stream.state(), counted, with_insisted(room, wanted)};
}

Bytes answer_rows(u64 first, Span<CountRow> counts, const WantedRows& rows) {
  AnswerHeader header{first, counts.size, rows.pieces.size, rows.candidates.size, rows.links.size};
  Writer writer(sizeof(header) + bytes_of(counts) + bytes_of(rows.pieces) + bytes_of(rows.candidates) + bytes_of(rows.links));
  writer.put(Span<AnswerHeader>{&header, 1});
  writer.put(counts);
  writer.put(rows.pieces);
  writer.put(rows.candidates);
  writer.put(rows.links);
  return writer.written();
}

Bytes furnish_room(Bytes type_rows, Bytes room_rows) {
  const RoomType type = read_room_type(type_rows.data, type_rows.size);
  RoomHeader room;
  Reader reader(room_rows.data, room_rows.size);
  const Scope scope = read_room(reader, room);
  const Wanted wanted = wanted_in(type, room, scope);
  List<CountRow> counts;
  for (const CountedPiece& one : wanted.counted) counts.add({one.spec, one.copies});
  return answer_rows(wanted.stream, counts.all(), wanted.rows);
}

}  // namespace furnish
