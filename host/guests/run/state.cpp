// See state.hpp.
#include "host/guests/run/state.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "host/guests/run/machine.hpp"

namespace sightline::guests::run {

base::Result<base::Done> Machine::restore(const MachineState&) {
  return base::Error{.found = "found a machine without snapshots", .expected = "another machine"};
}

void StateReader::input(std::string_view name, std::span<const std::uint8_t> bytes) {
  std::uint64_t length = 0;
  std::uint32_t checksum = 0;
  assign(name, length, std::numeric_limits<std::uint64_t>::max());
  assign(name, checksum, std::numeric_limits<std::uint32_t>::max());
  if (error_) return;
  const std::uint32_t here = base::crc32(bytes);
  if (length == bytes.size() && checksum == here) return;
  const auto described = [](std::uint64_t size, std::uint32_t crc) {
    return size == 0 ? std::string("none") : fmt::format("{} bytes with the CRC-32 {:08X}", size, crc);
  };
  error_ = base::Error{.place = place(name),
                       .found = "found another input: " + described(bytes.size(), here),
                       .expected = described(length, checksum),
                       .remedy = "name the file that the snapshot was made with"};
}

void StateReader::require(bool holds, std::string_view name, std::string_view expected) {
  if (error_ || holds) return;
  error_ = base::Error{.place = place(name),
                       .found = "found a value that contradicts others",
                       .expected = std::string(expected),
                       .remedy = "make the snapshot again with --save"};
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
  for (const std::string_view part : parts_) path += fmt::format("{}.", part);
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

}  // namespace sightline::guests::run
