// See state.hpp.
#include "host/machines/state.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "host/base/crc32.hpp"
#include "host/machines/machine.hpp"

namespace sightline::machines {

base::Result<base::Done> Machine::restore(const MachineState&) {
  return base::Error{.found = "found a machine without snapshots", .expected = "another machine"};
}

std::uint8_t* StateWriter::grow(std::size_t by) {
  bytes_->resize(bytes_->size() + by);
  return bytes_->data() + (bytes_->size() - by);
}

void StateWriter::put(std::uint64_t number, unsigned bytes) {
  for (; bytes > 0; --bytes, number >>= 8) bytes_->push_back(static_cast<std::uint8_t>(number));
}

void StateWriter::words(std::string_view, std::span<core::Word18> words) {
  std::uint8_t* at = grow(4 * words.size());
  for (const core::Word18 word : words) {
    for (unsigned i = 0; i < 4; ++i) *at++ = static_cast<std::uint8_t>(word.value() >> (8 * i));
  }
}

void StateWriter::bytes(std::string_view, std::span<std::uint8_t> bytes, std::uint8_t) {
  bytes_->insert(bytes_->end(), bytes.begin(), bytes.end());
}

void StateWriter::input(std::string_view, std::span<const std::uint8_t> bytes) {
  put(bytes.size(), 8);
  put(base::crc32(bytes), 4);
}

void StateWriter::number(std::string_view, core::StoredNumber& number) { put(number.value, number.bytes); }

std::size_t StateWriter::begin(Group group, std::string_view name, std::size_t elements) {
  switch (group) {
    case Group::part: break;
    case Group::section:
      sections_.push_back({std::string(name), {}});
      bytes_ = &sections_.back().bytes;
      break;
    case Group::list: put(elements, 4); break;
    case Group::optional: put(elements, 1); break;
  }
  return elements;
}

void StateReader::words(std::string_view name, std::span<core::Word18> words) {
  for (core::Word18& word : words) {
    if (const auto number = take(name, 4, core::Word18::mask)) word = core::Word18(static_cast<std::uint32_t>(*number));
  }
}

void StateReader::bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most) {
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(take(name, 1, most).value_or(byte));
}

void StateReader::input(std::string_view name, std::span<const std::uint8_t> bytes) {
  const auto length = take(name, 8, ~std::uint64_t{0});
  const auto checksum = take(name, 4, ~std::uint32_t{0});
  if (!length || !checksum) return;
  const std::uint32_t here = base::crc32(bytes);
  if (*length == bytes.size() && *checksum == here) return;
  const auto describe = [](std::uint64_t size, std::uint64_t crc) {
    return size == 0 ? std::string("none") : fmt::format("{} bytes with the CRC-32 {:08X}", size, crc);
  };
  error_ = base::Error{.place = place(name),
                       .found = "found another input: " + describe(bytes.size(), here),
                       .expected = describe(*length, *checksum),
                       .remedy = "name the file that the snapshot was made with"};
}

void StateReader::number(std::string_view name, core::StoredNumber& number) {
  number.value = take(name, number.bytes, number.most, number.may_be_never).value_or(number.value);
}

std::size_t StateReader::begin(Group group, std::string_view name, std::size_t elements) {
  if (group == Group::section && !open(name)) return 0;
  groups_.push_back({group, name});
  switch (group) {
    case Group::part:
    case Group::section: break;
    // Bounded by the rest of the section, because an element has at least one byte.
    case Group::list: elements = static_cast<std::size_t>(take("number", 4, left()).value_or(elements)); break;
    case Group::optional: elements = static_cast<std::size_t>(take(name, 1, 1).value_or(elements)); break;
  }
  return elements;
}

void StateReader::end() {
  const bool section = groups_.back().group == Group::section;
  groups_.pop_back();
  if (section) close();
}

std::optional<std::uint64_t> StateReader::take(std::string_view name, unsigned bytes, std::uint64_t most, bool may_be_never) {
  constexpr std::uint64_t never = std::numeric_limits<std::int64_t>::max();
  if (error_) return std::nullopt;
  if (left() < bytes) {
    too_short(name, bytes);
    return std::nullopt;
  }
  std::uint64_t number = 0;
  for (unsigned i = 0; i < bytes; ++i) number |= std::uint64_t{bytes_[at_ + i]} << (8 * i);
  if (number > most && !(may_be_never && number == never)) {
    out_of_range(name, number, most);
    return std::nullopt;
  }
  at_ += bytes;
  return number;
}

void StateReader::require(bool holds, std::string_view name, std::string_view expected) {
  if (error_ || holds) return;
  error_ = base::Error{.place = place(name),
                       .found = "found a value that contradicts others",
                       .expected = std::string(expected),
                       .remedy = "make the snapshot again with --save"};
}

void StateReader::require_medium(bool holds, std::string_view name, std::string_view expected) {
  if (error_ || holds) return;
  error_ = base::Error{.place = place(name),
                       .found = "found another medium",
                       .expected = std::string(expected),
                       .remedy = "name that file, or a copy of it"};
}

std::optional<base::Error> StateReader::finish() {
  const auto unused = std::find(used_.begin(), used_.end(), false);
  if (!error_ && unused != used_.end()) {
    const StateSection& section = (*state_)[static_cast<std::size_t>(unused - used_.begin())];
    error_ = base::Error{.place = fmt::format("section \"{}\"", section.name),
                         .found = "found a section that this machine does not have",
                         .expected = "none of that name",
                         .remedy = "make the snapshot again with --save"};
  }
  return error_;
}

bool StateReader::open(std::string_view name) {
  if (error_) return false;
  const auto found = std::find_if(state_->begin(), state_->end(),
                                  [name](const StateSection& each) { return each.name == name; });
  if (found == state_->end()) {
    error_ = base::Error{.place = fmt::format("section \"{}\"", name),
                         .found = "found no such section",
                         .expected = "one, because this machine has that part",
                         .remedy = "make the snapshot again with --save"};
    return false;
  }
  used_[static_cast<std::size_t>(found - state_->begin())] = true;
  section_ = found->name;
  bytes_ = found->bytes;
  at_ = 0;
  return true;
}

void StateReader::close() {
  if (!error_ && left() != 0) {
    error_ = base::Error{.place = fmt::format("section \"{}\", byte {}", section_, at_),
                         .found = fmt::format("found {} bytes more", left()),
                         .expected = "the end of the section",
                         .remedy = "make the snapshot again with --save"};
  }
  section_ = {};
  bytes_ = {};
  at_ = 0;
}

std::string StateReader::place(std::string_view field) const {
  if (section_.empty()) return std::string(field);
  std::string path;
  for (const Open& each : groups_)
    if (each.group == Group::part || each.group == Group::list) path += fmt::format("{}.", each.name);
  return fmt::format("section \"{}\", byte {}, {}{}", section_, at_, path, field);
}

void StateReader::too_short(std::string_view name, unsigned bytes) {
  error_ = base::Error{.place = place(name),
                       .found = fmt::format("found {} bytes to the end of the section", left()),
                       .expected = fmt::format("{} at least", bytes),
                       .remedy = "make the snapshot again with --save"};
}

void StateReader::out_of_range(std::string_view name, std::uint64_t number, std::uint64_t most) {
  error_ = base::Error{.place = place(name),
                       .found = fmt::format("found {}", number),
                       .expected = fmt::format("0 to {}", most),
                       .remedy = "make the snapshot again with --save"};
}

}  // namespace sightline::machines
