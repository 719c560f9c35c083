// Approved files: the output of a program is compared byte for byte with a file that a person has checked and committed
// under tests/data/approved. With SIGHTLINE_APPROVE=1 in the environment the approved files are rewritten instead.
//
// On a mismatch the received bytes are written below `received/` in the working directory of the test (the build tree),
// and the failure names the file. Pictures: see approve_png.hpp.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::tests {

inline std::filesystem::path approved_path(const std::string& name) {
  return std::filesystem::path(SIGHTLINE_TEST_DATA) / "approved" / name;
}

inline std::filesystem::path received_path(const std::string& name) {
  return std::filesystem::current_path() / "received" / name;
}

inline bool approving() {
  const char* const value = std::getenv("SIGHTLINE_APPROVE");
  return value != nullptr && std::string_view(value) == "1";
}

inline std::string read_whole(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// False if writing failed.
inline bool write_whole(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code failed;
  std::filesystem::create_directories(path.parent_path(), failed);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(file.flush());
}

inline std::string first_difference(std::string_view approved, std::string_view received) {
  const auto [a, r] = std::mismatch(approved.begin(), approved.end(), received.begin(), received.end());
  const auto line = 1 + std::count(approved.begin(), a, '\n');
  return "approved " + std::to_string(approved.size()) + " bytes, received " +
         std::to_string(received.size()) + ", first difference at byte " +
         std::to_string(a - approved.begin()) + " (line " + std::to_string(line) + ")";
}

// `name` is a path below tests/data/approved, e.g. "pdp7/roberts.lst".
inline testing::AssertionResult matches_approved(std::string_view received, const std::string& name) {
  const auto approved = approved_path(name);
  if (approving()) {
    if (write_whole(approved, received)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "cannot write " << approved.string();
  }
  const bool exists = std::filesystem::exists(approved);
  if (exists && read_whole(approved) == received) return testing::AssertionSuccess();
  const auto kept = received_path(name);
  const bool written = write_whole(kept, received);
  return testing::AssertionFailure() << (exists ? first_difference(read_whole(approved), received)
                                                : "nothing is approved yet")
                                     << "\n  approved: " << approved.string() << "\n  received: "
                                     << (written ? kept.string() : "(could not be written)")
                                     << "\n  look at it; SIGHTLINE_APPROVE=1 makes it the approved one";
}

inline testing::AssertionResult matches_approved(std::span<const unsigned char> received,
                                                 const std::string& name) {
  return matches_approved(std::string_view(reinterpret_cast<const char*>(received.data()), received.size()),
                          name);
}

}  // namespace sightline::tests
