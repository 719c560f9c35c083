// sightline-vectors: writes test vectors of the 8080 into a folder. Exit codes: 0 written, 2 wrong usage, 5 a file cannot be written.
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "host/base/file.hpp"
#include "host/base/number.hpp"
#include "tools/vectors/vectors.hpp"

namespace {

using sightline::base::Json;

constexpr std::string_view usage =
    "usage: sightline-vectors FOLDER [--cases N] [--seed N]\n"
    "Writes FOLDER/00.json to ff.json, N cases (100) of each opcode of the 8080, int.json, ready.json, hold.json and\n"
    "pins.json, 10 N cases with changes of these pins, and metadata.json. The same seed (1) gives the same bytes.\n"
    "tools/vectors/README.md explains the form.\n";
constexpr std::uint64_t most_cases = 10'000;

struct Arguments {
  std::string folder;
  std::uint64_t cases = 100;
  std::uint64_t seed = 1;
};

std::optional<Arguments> arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int n = 1; n < argc; ++n) {
    const std::string_view word = argv[n];
    if (word == "--cases" || word == "--seed") {
      const auto number = n + 1 < argc ? sightline::base::count_number(argv[n + 1]) : std::nullopt;
      if (!number || (word == "--cases" && (*number == 0 || *number > most_cases))) {
        std::cerr << "sightline-vectors: " << word << ": found " << (n + 1 < argc ? argv[n + 1] : "nothing") << ", expected a number"
                  << (word == "--cases" ? ", 1 to 10000" : "") << '\n';
        return std::nullopt;
      }
      (word == "--cases" ? arguments.cases : arguments.seed) = *number;
      ++n;
    } else if (word.starts_with('-') || !arguments.folder.empty() || word.empty()) {
      std::cerr << "sightline-vectors: found \"" << word << "\", expected one folder, --cases N or --seed N\n";
      return std::nullopt;
    } else {
      arguments.folder = word;
    }
  }
  if (arguments.folder.empty()) {
    std::cerr << "sightline-vectors: found no folder\n" << usage;
    return std::nullopt;
  }
  return arguments;
}

bool write(const std::filesystem::path& path, const std::string& text) {
  const auto done = sightline::base::write_file_atomically(path.string(), text);
  if (!done) std::cerr << done.error().message() << '\n';
  return done.has_value();
}

}  // namespace

int main(int argc, char** argv) {
  namespace vectors = sightline::vectors;
  if (argc == 2 && (std::string_view(argv[1]) == "--help" || std::string_view(argv[1]) == "-h")) {
    std::cout << usage;
    return 0;
  }
  const auto arguments = arguments_of(argc, argv);
  if (!arguments) return 2;
  const std::filesystem::path folder = arguments->folder;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    std::cerr << arguments->folder << ": the folder cannot be made: " << failed.message() << '\n';
    return 5;
  }
  for (unsigned opcode = 0; opcode < 256; ++opcode) {
    const auto cases = vectors::opcode_cases(static_cast<sightline::i8080::Byte>(opcode), arguments->cases, arguments->seed);
    if (!write(folder / fmt::format("{:02x}.json", opcode), vectors::text_of(cases))) return 5;
  }
  for (const vectors::PinSet& set : vectors::pin_sets()) {
    if (!write(folder / (set.name + ".json"), vectors::text_of(vectors::pin_cases(set, 10 * arguments->cases, arguments->seed)))) return 5;
  }
  const Json metadata{{"processor", "8080"},
                      {"generator", "sightline-vectors"},
                      {"seed", arguments->seed},
                      {"cases", arguments->cases},
                      {"computed_by", "emulators/i8080/pin_bus.hpp"},
                      {"authority", "tests/data/i8080/single-step.txt and pins.txt: a gate-level model of the KR580VM80A"}};
  return write(folder / "metadata.json", metadata.dump(2) + "\n") ? 0 : 5;
}
