#include "host/live/snapshot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "host/base/crc32.hpp"

namespace sightline::live {

namespace {

using machines::Machine;
using machines::StateSection;

constexpr auto& signature = machines::snapshot_signature;
constexpr std::size_t length_at = 12;
constexpr std::size_t shortest = 16;  // signature, version, length
constexpr std::size_t checksum_bytes = 4;
constexpr std::string_view make_again = "make the snapshot again with --save";

void put(Bytes& bytes, std::uint64_t number, unsigned width) {
  for (unsigned i = 0; i < width; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

void put_text(Bytes& bytes, std::string_view text) {
  put(bytes, text.size(), 2);
  bytes.insert(bytes.end(), text.begin(), text.end());
}

std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t at, unsigned width = 4) {
  std::uint32_t number = 0;
  for (unsigned i = 0; i < width; ++i) number |= std::uint32_t{bytes[at + i]} << (8 * i);
  return number;
}

// Reads the fields between the header and the checksum.
class Parser {
 public:
  Parser(std::span<const std::uint8_t> bytes, const std::string& file) : bytes_(bytes), file_(&file) {}

  [[nodiscard]] base::Result<Snapshot> snapshot() {
    Snapshot snapshot;
    snapshot.machine = text("the machine's name");
    for (std::uint32_t left = count("lines of the configuration"); left > 0 && !error_; --left)
      snapshot.configuration.push_back(text("a line of the configuration"));
    for (std::uint32_t left = count("sections"); left > 0 && !error_; --left) {
      StateSection section{text("a section's name"), {}};
      const auto taken =
          std::find_if(snapshot.state.begin(), snapshot.state.end(),
                       [&section](const StateSection& each) { return each.name == section.name; });
      if (taken != snapshot.state.end())
        fail(fmt::format("found section \"{}\" again", section.name), "another name");
      const auto content = take(number("a section's length"), "a section");
      section.bytes.assign(content.begin(), content.end());
      snapshot.state.push_back(std::move(section));
    }
    if (at_ != bytes_.size()) fail(fmt::format("found {} bytes more", bytes_.size() - at_), "the checksum");
    if (error_) return *error_;
    return snapshot;
  }

 private:
  void fail(std::string found, std::string expected) {
    if (error_) return;
    error_ = base::Error{.file = *file_,
                         .place = fmt::format("byte {}", at_),
                         .found = std::move(found),
                         .expected = std::move(expected),
                         .remedy = std::string(make_again)};
  }
  std::span<const std::uint8_t> take(std::size_t length, std::string_view what) {
    if (!error_ && length > bytes_.size() - at_)
      fail(fmt::format("found {} bytes to the checksum", bytes_.size() - at_),
           fmt::format("{} for {}", length, what));
    if (error_) return {};
    at_ += length;
    return bytes_.subspan(at_ - length, length);
  }
  std::uint32_t number(std::string_view what, unsigned width = 4) {
    const auto taken = take(width, what);
    return taken.empty() ? 0 : number_at(taken, 0, width);
  }
  // Each item takes at least two bytes.
  std::uint32_t count(std::string_view what) {
    const std::uint32_t count = number(what);
    const std::size_t most = (bytes_.size() - at_) / 2;
    if (count > most) fail(fmt::format("found {} {}", count, what), fmt::format("{} at most", most));
    return error_ ? 0 : count;
  }
  std::string text(std::string_view what) {
    const auto taken = take(number(what, 2), what);
    std::string text(taken.begin(), taken.end());
    const auto bad = std::find_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; });
    if (bad != text.end()) fail("found a character that is not ASCII", std::string(what));
    return text;
  }

  std::span<const std::uint8_t> bytes_;
  const std::string* file_;
  std::size_t at_ = shortest;
  std::optional<base::Error> error_;
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// The words of `a` that are not in `b`.
std::vector<std::string> without(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::string> left;
  for (const std::string& word : a)
    if (std::find(b.begin(), b.end(), word) == b.end()) left.push_back(word);
  return left;
}

// nullopt for equal configurations.
std::optional<base::Error> difference(const std::vector<std::string>& saved,
                                      const std::vector<std::string>& here) {
  const std::vector<std::string> missing = without(saved, here);
  const std::vector<std::string> extra = without(here, saved);
  if (missing.empty() && extra.empty()) return std::nullopt;
  std::string remedy;
  if (!missing.empty()) remedy = "add " + joined(missing);
  std::vector<std::string> leave_out;
  for (const std::string& word : extra) {
    const std::string option = word.substr(0, word.find_first_of(" ="));
    const bool replaced = std::any_of(missing.begin(), missing.end(), [&option](const std::string& each) {
      return each.starts_with(option);
    });
    if (!replaced) leave_out.push_back(word);
  }
  if (!leave_out.empty()) remedy += (remedy.empty() ? "leave out " : ", leave out ") + joined(leave_out);
  std::string found = "found a machine";
  if (!extra.empty()) found += " with " + joined(extra);
  if (!missing.empty()) found += (extra.empty() ? " without " : " and without ") + joined(missing);
  return base::Error{
      .place = "configuration", .found = found, .expected = "that of the snapshot", .remedy = remedy};
}

}  // namespace

Bytes encode_snapshot(const Snapshot& snapshot) {
  std::size_t size = 1024;
  for (const StateSection& section : snapshot.state) size += section.bytes.size() + 64;
  Bytes bytes;
  bytes.reserve(size);
  bytes.assign(signature.begin(), signature.end());
  put(bytes, snapshot_version, 4);
  put(bytes, 0, 4);
  put_text(bytes, snapshot.machine);
  put(bytes, snapshot.configuration.size(), 4);
  for (const std::string& word : snapshot.configuration) put_text(bytes, word);
  put(bytes, snapshot.state.size(), 4);
  for (const StateSection& section : snapshot.state) {
    put_text(bytes, section.name);
    put(bytes, section.bytes.size(), 4);
    bytes.insert(bytes.end(), section.bytes.begin(), section.bytes.end());
  }
  const std::size_t length = bytes.size() + checksum_bytes;
  for (unsigned i = 0; i < 4; ++i) bytes[length_at + i] = static_cast<std::uint8_t>(length >> (8 * i));
  put(bytes, base::crc32(bytes), checksum_bytes);
  return bytes;
}

base::Result<Snapshot> decode_snapshot(std::span<const std::uint8_t> bytes, const std::string& file) {
  const auto rejection = [&file](std::string_view place, std::string found, std::string expected,
                               std::string_view remedy = make_again) {
    return base::Error{.file = file,
                       .place = std::string(place),
                       .found = std::move(found),
                       .expected = std::move(expected),
                       .remedy = std::string(remedy)};
  };
  if (bytes.size() < signature.size() || !std::equal(signature.begin(), signature.end(), bytes.begin()))
    return rejection("byte 0", "found no signature of a snapshot", "a file that --save has written", {});
  if (bytes.size() < shortest + checksum_bytes)
    return rejection("byte 8", fmt::format("found {} bytes", bytes.size()), "a whole snapshot");
  if (const std::uint32_t version = number_at(bytes, 8); version != snapshot_version)
    return rejection("byte 8", fmt::format("found version {}", version),
                   fmt::format("version {}", snapshot_version),
                   "make the snapshot again with the --save of this version");
  if (const std::uint32_t length = number_at(bytes, length_at); length != bytes.size())
    return rejection("byte 12", fmt::format("found a file of {} bytes", bytes.size()),
                   fmt::format("{} bytes", length));
  const auto content = bytes.first(bytes.size() - checksum_bytes);
  if (const std::uint32_t checksum = number_at(bytes, content.size()); checksum != base::crc32(content))
    return rejection(fmt::format("byte {}", content.size()), fmt::format("found the checksum {:08X}", checksum),
                   fmt::format("{:08X}: the file is damaged", base::crc32(content)));
  return Parser(content, file).snapshot();
}

Bytes save_snapshot(std::string_view name, Machine& machine) {
  return encode_snapshot({std::string(name), machine.configuration(), machine.save()});
}

base::Result<base::Done> restore_snapshot(std::string_view name, Machine& machine,
                                          std::span<const std::uint8_t> bytes, const std::string& file) {
  const auto snapshot = decode_snapshot(bytes, file);
  if (!snapshot) return snapshot.error();
  if (snapshot->machine != name) {
    return base::Error{.file = file,
                       .place = "the machine's name",
                       .found = fmt::format("found a snapshot of {}", snapshot->machine),
                       .expected = fmt::format("one of {}", name),
                       .remedy = fmt::format("use sightline run {}", snapshot->machine)};
  }
  if (auto differs = difference(snapshot->configuration, machine.configuration_in(snapshot->state))) {
    differs->file = file;
    return *differs;
  }
  const auto done = machine.restore(snapshot->state);
  if (done) return done;
  base::Error error = done.error();
  error.file = file;
  return error;
}

}  // namespace sightline::live
