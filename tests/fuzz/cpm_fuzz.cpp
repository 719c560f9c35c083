// Any calls of CP/M's file functions with any file control blocks: no call writes outside the 64K of memory, and the calls change
// neither a folder next to the drive's nor the target of a link in it. Three bytes of input are a call, 16 more the block.
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "host/machines/cpm_files.hpp"

namespace {

using namespace sightline;
namespace fs = std::filesystem;

class Folders {
 public:
  Folders() : base_(fs::temp_directory_path() / ("sightline-cpm-fuzz-" + std::to_string(::getpid()))) {
    fs::create_directories(base_ / "outside");
    std::ofstream(canary()) << "canary";
  }
  ~Folders() {
    std::error_code ignored;
    fs::remove_all(base_, ignored);
  }
  [[nodiscard]] fs::path drive() const { return base_ / "a"; }
  [[nodiscard]] fs::path canary() const { return base_ / "outside" / "CANARY"; }
  void fill() const {
    fs::remove_all(drive());
    fs::create_directory(drive());
    fs::create_symlink(canary(), drive() / "CANARY");
    fs::create_directory_symlink(base_ / "outside", drive() / "OUTSIDE");
    std::ofstream(drive() / "TEXT") << std::string(300, 'x');
  }
  [[nodiscard]] bool sound() const {
    std::ifstream in(canary());
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const auto entries = [](const fs::path& folder) { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); };
    return text == "canary" && entries(base_ / "outside") == 1 && entries(base_) == 2;
  }

 private:
  fs::path base_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folders folders;
  folders.fill();
  machines::CpmFiles files({{0, folders.drive(), false}});
  std::vector<std::uint8_t> memory(65536);
  std::span<const std::uint8_t> rest(data, size);
  constexpr std::size_t call = 3, block = 16;
  for (int calls = 0; rest.size() >= call && calls < 64; ++calls) {
    const auto at = static_cast<std::uint16_t>(rest[1] | rest[2] << 8);
    const std::uint8_t function = rest[0] % 41;
    rest = rest.subspan(call);
    const std::size_t given = std::min(block, rest.size());
    for (std::size_t n = 0; n < given; ++n) memory[static_cast<std::uint16_t>(at + n)] = rest[n];
    rest = rest.subspan(given);
    if (machines::CpmFiles::answers(function)) static_cast<void>(files.call(function, at, memory));
  }
  if (!folders.sound()) std::abort();
  return 0;
}
