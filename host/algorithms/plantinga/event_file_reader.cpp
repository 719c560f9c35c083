// The reader of event files, which believes nothing; see event_file.hpp.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/event_file_format.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using namespace event_file;
using base::Bytes;
using base::Error;

// Nothing in a file of this many bytes needs larger run numbers.
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
                                 : "something else in the first " + std::to_string(marked) + " bytes",
                  "an event file, which begins with SIGHTLINE EVENTS");
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
      return fail(end_, "a checksum of other contents", "a complete and undamaged file");
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
      fail(at_ - 8, "an impossible tolerance", "an angle in radians, 0 or more");
    }
  }

  std::uint64_t fixed(std::size_t end) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < 8 && at_ < end; ++i) value |= std::uint64_t{bytes_[at_++]} << (8 * i);
    return value;
  }

  // 0 after an error.
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
    fail(place, at_ == end_ ? "the end of the file" : "a number too long", what);
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
    fail(place, at_ == end_ ? "the end of the file" : "a coefficient too long", "a coefficient below 2^104");
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
      fail(place, "an end of a piece of edge " + std::to_string(edge) + " at what the model has not",
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
      fail(place, "no direction in lowest terms", "coprime numbers, or an irreducible form and its root");
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
    if (at_ != end_) return fail(at_, std::to_string(end_ - at_) + " bytes more", "the checksum");
    if (now != list_.first)
      fail(at_, "a turn that does not end where it began", "the structures of the beginning");
  }

  void event(std::vector<EdgeStructure>& now) {
    const std::size_t place = at_;
    const Direction here = direction();
    if (error_) return;
    if (!list_.events.empty() && compare(list_.events.back().direction, here) >= 0) {
      return fail(place, "an event before the one it follows", "events in ascending order");
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
                    "an edge not below " + std::to_string(least));
      least = edge + 1;
      EdgeStructure after;
      pieces(edge, after);
      if (error_) return;
      // A change may take away far more than it brings, but not more than was brought before.
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
