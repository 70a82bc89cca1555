#include "furnish/furnish.hpp"

#include "furnish/furnisher.hpp"
#include "furnish/runs.hpp"

namespace furnish {

namespace {

// The answer's beginning; pieces, candidates, links and counts follow.
struct AnswerHeader {
  u64 stream;  // the stream's state at the end
  i32 counted, pieces, candidates, links;
};

struct CountRow {
  i32 spec;
  i32 copies;
};

}  // namespace

static Scope read_room(u8* data, i64 size, RoomHeader& header) {
  Reader reader(data, size);
  header = reader.take<RoomHeader>(1)[0];
  Scope scope{header.clear, header.gap, header.exterior, reader.take<Opened>(header.openings), reader.take<Zone>(header.zones)};
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
    for (i32 number = 1; number <= one.copies; number++) {
      const Preferences preferences(stream);
      if (!furnisher.add(one, number, preferences, planned ? &run[word] : nullptr)) break;
    }
  }
}

static Bytes answer(const Furnisher& furnisher, const List<CountedPiece>& counted, const Stream& stream) {
  const Span<PieceRow> pieces = furnisher.pieces.all();
  const Span<Candidate> candidates = furnisher.candidates.all();
  const Span<Link> links = furnisher.links.all();
  AnswerHeader header{stream.state(), counted.size(), pieces.size, candidates.size, links.size};
  List<CountRow> counts;
  for (const CountedPiece& one : counted) counts.add({one.spec, one.copies});
  Writer writer(sizeof(header) + bytes_of(counts.all()) + bytes_of(pieces) + bytes_of(candidates) + bytes_of(links));
  writer.put(Span<AnswerHeader>{&header, 1});
  writer.put(counts.all());
  writer.put(pieces);
  writer.put(candidates);
  writer.put(links);
  return writer.written();
}

Bytes furnish_room(Bytes type_rows, Bytes room_rows) {
  const RoomType type = read_room_type(type_rows.data, type_rows.size);
  RoomHeader room;
  const Scope scope = read_room(room_rows.data, room_rows.size, room);
  WallOccupancy walls(scope);
  Furnisher furnisher(scope, type, walls);
  Stream stream(room.stream);
  const List<CountedPiece> counted = counted_pieces(type, room.area, stream);
  if (!room.counts_only) {
    const Span<Candidate> run = type.has_run ? planned_run(scope, walls, type, counted, stream) : Span<Candidate>{};
    add_pieces(furnisher, type, counted, run, stream);
  }
  return answer(furnisher, counted, stream);
}

}  // namespace furnish
