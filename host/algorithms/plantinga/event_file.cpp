// The writer of event files; see event_file.hpp.
#include "host/algorithms/plantinga/event_file.hpp"

#include <bit>
#include <cstddef>
#include <span>
#include <utility>

#include "host/algorithms/plantinga/event_file_format.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using namespace event_file;
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
    // Sign and six bits first.
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

}  // namespace sightline::algorithms::plantinga
