// Runs `sightline run i8080 --cpm` on programs in 8080 assembly language, with a folder `a` for a drive.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {

class CpmCommand : public CommandLine {
 protected:
  CpmCommand() { std::filesystem::create_directory(path("a")); }
  void assemble(std::string_view source, const std::string& program = "p.com") {
    write("p.asm", source);
    const Ran made = sightline({"asm", "i8080", "p.asm", "-o", program});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  Ran run(Arguments options) {
    Arguments words{"run", "i8080", "p.com", "--cpm"};
    words.insert(words.end(), options.begin(), options.end());
    const auto limited = std::find(words.begin(), words.end(), "--max-instructions");
    if (limited == words.end()) words.insert(words.end(), {"--max-instructions", "1000000"});
    return sightline(words);
  }
  // Bytes of a dump: a line of registers, then lines of 16 bytes.
  std::string memory_of(const std::string& dump, std::size_t address, std::size_t count) {
    std::istringstream text(read(dump));
    std::string line;
    std::getline(text, line);
    std::string bytes;
    for (std::size_t at = 0; at < address + count; ++at) {
      std::string byte;
      text >> byte;
      if (at >= address) bytes += (bytes.empty() ? "" : " ") + byte;
    }
    return bytes;
  }
};

}  // namespace sightline::test
