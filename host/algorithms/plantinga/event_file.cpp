#include "host/algorithms/plantinga/event_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/geometry/integer.hpp"

namespace sightline::algorithms::plantinga {

namespace {

// Shared by writer and reader, besides the layout (event_file.hpp).

constexpr std::string_view mark = "SIGHTLINE EVENTS\n";
constexpr std::uint8_t version = 1;
constexpr std::size_t checksum_size = 8;
constexpr std::size_t header_size = mark.size() + 1 + 8 + 8;
// Coefficients of events are below this (direction.hpp).
constexpr geometry::Int128 coefficient_limit = geometry::Int128{1} << 104U;

std::uint64_t checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (std::size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
  return hash;
}

using base::Bytes;

class Writer {
 public:
  void fixed(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void number(std::uint64_t value) {
    for (; value >= 128; value >>= 7U) bytes_.push_back(static_cast<std::uint8_t>(value | 128U));
    bytes_.push_back(static_cast<std::uint8_t>(value));
  }
  void coefficient(Int128 value) {
    const bool negative = value < 0;
    if (negative) value = -value;
    // The first byte has the sign and six bits.
    std::uint8_t byte = static_cast<std::uint8_t>((value & 63) | (negative ? 64 : 0));
    for (value >>= 6; value != 0; value >>= 7) {
      bytes_.push_back(static_cast<std::uint8_t>(byte | 128U));
      byte = static_cast<std::uint8_t>(value & 127);
    }
    bytes_.push_back(byte);
  }
  void pieces(std::span<const Piece> list) {
    number(list.size());
    for (const Piece& piece : list) {
      for (const End& end : {piece.low, piece.high}) {
        number((std::uint64_t{end.index()} << 2U) | static_cast<std::uint32_t>(end.kind()));
      }
    }
  }
  void direction(const Direction& d) {
    number(d.rational ? 0 : 1U + (d.root > 0 ? 1U : 0U) + (d.side > 0 ? 2U : 0U));
    coefficient(d.form.xx);
    if (!d.rational) coefficient(d.form.xz);
    coefficient(d.form.zz);
  }
  Bytes& bytes() { return bytes_; }

 private:
  Bytes bytes_;
};

// A file of at most this many bytes needs no larger run numbers.
constexpr std::size_t most_bytes = std::size_t{1} << 30U;

class Reader {
 public:
  Reader(const Bytes& bytes, std::string name, const RotationModel& model)
      : bytes_(bytes), name_(std::move(name)), model_(model), end_(bytes.size()) {}

  base::Result<EventList> read() {
    header();
    if (!error_) body();
    if (error_) return std::move(*error_);
    return std::move(list_);
  }

 private:
  void fail(std::size_t place, std::string found, std::string expected) {
    if (!error_)
      error_ = base::Error{name_, "byte " + std::to_string(place), std::move(found), std::move(expected)};
  }

  void header() {
    const std::size_t marked = std::min(mark.size(), bytes_.size());
    if (bytes_.size() < mark.size() || !std::equal(mark.begin(), mark.end(), bytes_.begin())) {
      return fail(0,
                  bytes_.empty() ? "an empty file"
                                 : "the first " + std::to_string(marked) + " bytes are not those of an event file",
                  "SIGHTLINE EVENTS");
    }
    if (bytes_.size() > mark.size() && bytes_[mark.size()] != version) {
      return fail(mark.size(), "version " + std::to_string(bytes_[mark.size()]),
                  "version " + std::to_string(version));
    }
    if (bytes_.size() < header_size + checksum_size) {
      return fail(bytes_.size(), "the end of the file",
                  "a header of " + std::to_string(header_size) + " bytes and a checksum");
    }
    end_ = bytes_.size() - checksum_size;
    at_ = end_;
    const std::uint64_t stored = fixed(bytes_.size());
    if (stored != checksum(bytes_.data(), end_)) {
      return fail(end_, "the checksum does not match the contents", "a complete and undamaged file");
    }
    at_ = mark.size() + 1;
    list_.fingerprint = fixed(end_);
    if (list_.fingerprint != model_.fingerprint()) {
      return fail(mark.size() + 1, "events of another model",
                  "those of a model of " + std::to_string(model_.edges().size()) +
                      " edges with the same vertices and faces");
    }
    list_.tolerance = std::bit_cast<double>(fixed(end_));
    if (!(list_.tolerance >= 0 && list_.tolerance < 7)) {
      fail(at_ - 8, "a tolerance out of range", "an angle in radians, at least 0 and below 7");
    }
  }

  std::uint64_t fixed(std::size_t end) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < 8 && at_ < end; ++i) value |= std::uint64_t{bytes_[at_++]} << (8 * i);
    return value;
  }

  // Returns 0 after an error.
  std::uint64_t number(std::uint64_t limit, const char* what) {
    const std::size_t place = at_;
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      if (at_ == end_) break;
      const std::uint8_t byte = bytes_[at_++];
      value |= std::uint64_t{byte & 127U} << shift;
      if (byte >= 128) continue;
      if (value <= limit) return value;
      fail(place, std::to_string(value), std::string(what) + ", at most " + std::to_string(limit));
      return 0;
    }
    fail(place, at_ == end_ ? "the end of the file" : "a number of more than 63 bits", what);
    return 0;
  }

  Int128 coefficient() {
    const std::size_t place = at_;
    Int128 value = 0;
    bool negative = false;
    for (unsigned shift = 0; shift < 111;) {
      if (at_ == end_) break;
      const std::uint8_t byte = bytes_[at_++];
      const unsigned bits = shift == 0 ? 6 : 7;
      if (shift == 0) negative = (byte & 64U) != 0;
      value |= static_cast<Int128>(byte & ((1U << bits) - 1)) << shift;
      shift += bits;
      if (byte >= 128) continue;
      if (value < coefficient_limit) return negative ? -value : value;
      break;
    }
    fail(place, at_ == end_ ? "the end of the file" : "a coefficient of 2^104 or more", "a coefficient below 2^104");
    return 0;
  }

  End end_of(EdgeIndex edge, bool low) {
    const std::size_t place = at_;
    const std::uint64_t given = number(0xFFFFFFFF, "the end of a piece");
    const End end = End::of(static_cast<EndKind>(given & 3U), static_cast<std::uint32_t>(given >> 2U));
    const picture::LineEdge& own = model_.edges()[edge];
    const bool possible = [&] {
      switch (end.kind()) {
        case EndKind::vertex: return end.index() == (low ? own.from : own.to);
        case EndKind::contact: return end.index() < model_.vertices().size();
        case EndKind::junction: return end.index() < model_.edges().size() && end.index() != edge;
        case EndKind::passage: return end.index() < model_.faces().size();
      }
      return false;
    }();
    if (!possible)
      fail(place, "a piece of edge " + std::to_string(edge) + " ends at something that the model lacks",
           "one of its ends, another edge, a vertex or a face");
    return end;
  }

  void pieces(EdgeIndex edge, EdgeStructure& structure) {
    const std::uint64_t count = number((end_ - at_) / 2, "a number of pieces");
    structure.clear();
    for (std::uint64_t i = 0; i < count && !error_; ++i) {
      const End low = end_of(edge, true);
      const End high = end_of(edge, false);
      structure.push_back({low, high});
    }
  }

  Direction direction() {
    const std::size_t place = at_;
    const std::uint64_t kind = number(4, "a kind of direction");
    const Int128 xx = coefficient();
    const Int128 xz = kind == 0 ? 0 : coefficient();
    const Int128 zz = coefficient();
    if (error_) return {};
    std::optional<Direction> found;
    if (kind == 0 && (xx != 0 || zz != 0)) found = rational_direction(xx, zz);
    if (kind != 0) {
      for (const Direction& root : roots_of(QuadraticForm{xx, xz, zz})) {
        if (!root.rational && root.root == ((kind - 1) % 2 != 0 ? 1 : -1) && root.side == (kind > 2 ? 1 : -1))
          found = root;
      }
    }
    if (!found || !(found->form == QuadraticForm{xx, xz, zz})) {
      fail(place, "a direction that is not in lowest terms", "coprime numbers, or an irreducible form and its root");
      return {};
    }
    return *found;
  }

  void body() {
    const std::size_t edges = model_.edges().size();
    list_.first.resize(edges);
    for (EdgeIndex edge = 0; edge < edges && !error_; ++edge) pieces(edge, list_.first[edge]);
    std::vector<EdgeStructure> now = list_.first;
    const std::uint64_t count = number(end_ - at_, "a number of events");
    for (std::uint64_t i = 0; i < count && !error_; ++i) event(now);
    if (error_) return;
    if (at_ != end_) return fail(at_, std::to_string(end_ - at_) + " bytes between the events and the checksum", "none");
    if (now != list_.first)
      fail(at_, "the structures after the last event are not those before the first", "equal structures");
  }

  void event(std::vector<EdgeStructure>& now) {
    const std::size_t place = at_;
    const Direction here = direction();
    if (error_) return;
    if (!list_.events.empty() && compare(list_.events.back().direction, here) >= 0) {
      return fail(place, "an event that does not come after the preceding one", "events in ascending order");
    }
    list_.events.push_back({here, static_cast<std::uint32_t>(list_.changes.size()), 0});
    const std::uint64_t count = number(end_ - at_, "a number of changes");
    EdgeIndex least = 0;
    for (std::uint64_t i = 0; i < count && !error_; ++i) {
      const std::size_t change_place = at_;
      const auto edge = static_cast<EdgeIndex>(number(now.size() - 1, "an edge"));
      if (error_) return;
      if (edge < least)
        return fail(change_place, "edge " + std::to_string(edge),
                    "an edge of at least " + std::to_string(least));
      least = edge + 1;
      EdgeStructure after;
      pieces(edge, after);
      if (error_) return;
      // A change may remove far more than it adds, but only what earlier changes added.
      append_change(list_, edge, now[edge], after);
      now[edge] = std::move(after);
    }
  }

  const Bytes& bytes_;
  std::string name_;
  const RotationModel& model_;
  std::size_t at_ = 0;
  std::size_t end_;
  std::optional<base::Error> error_;
  EventList list_;
};

}  // namespace

Bytes encode_events(const EventList& list) {
  Writer writer;
  for (const char c : mark) writer.bytes().push_back(static_cast<std::uint8_t>(c));
  writer.bytes().push_back(version);
  writer.fixed(list.fingerprint);
  writer.fixed(std::bit_cast<std::uint64_t>(list.tolerance));
  for (const EdgeStructure& structure : list.first) writer.pieces(structure);
  writer.number(list.events.size());
  for (const Event& event : list.events) {
    writer.direction(event.direction);
    writer.number(event.change_count);
    for (const Change& change : list.changes_of(event)) {
      writer.number(change.edge);
      writer.pieces(list.added_by(change));
    }
  }
  writer.fixed(checksum(writer.bytes().data(), writer.bytes().size()));
  return std::move(writer.bytes());
}

base::Result<base::Done> write_events(const std::string& path, const EventList& list) {
  return base::write_file_atomically(path, encode_events(list));
}

base::Result<EventList> decode_events(const Bytes& bytes, const std::string& name,
                                      const RotationModel& model) {
  return Reader(bytes, name, model).read();
}

base::Result<EventList> read_events(const std::string& path, const RotationModel& model) {
  auto bytes = base::read_file(path, most_bytes);
  if (!bytes) return bytes.error();
  return decode_events(*bytes, path, model);
}

}  // namespace sightline::algorithms::plantinga
