// The resident Skala program on its machine: assembled from the source tree, receiving commands over the parallel link.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/devices/alt256.hpp"
#include "emulators/devices/ef9365.hpp"
#include "emulators/machines/i8080.hpp"
#include "tests/firmware/skala_reference.hpp"
#include "tools/asm/i8080.hpp"

namespace sightline::skala_test {

inline std::optional<std::string> source_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

// Assembled once.
inline const assembler::I8080Assembly& program() {
  static const assembler::I8080Assembly assembly = [] {
    const std::string path = SIGHTLINE_SOURCE_DIR "/firmware/i8080/skala/skala.asm";
    assembler::I8080Options options;
    options.listing = false;
    options.include = source_text;
    const std::vector<assembler::SourceFile> sources{{path, source_text(path).value_or("")}};
    auto result = assembler::assemble_i8080(sources, options);
    for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
    return result;
  }();
  return assembly;
}

inline std::uint16_t label(std::string_view name) {
  const auto value = program().value_of(name);
  if (!value) ADD_FAILURE() << "the program has no label " << name;
  return static_cast<std::uint16_t>(value.value_or(0));
}

struct Strokes final : core::StrokeTaker {
  void strokes(std::span<const core::Stroke> strokes) override { all.insert(all.end(), strokes.begin(), strokes.end()); }
  std::vector<core::Stroke> all;
};

struct Attachment {
  std::string_view device;
  std::vector<core::Setting> settings = {};
};

class SkalaMachine {
 public:
  static std::vector<Attachment> everything() {
    return {{"ef9365"}, {"alt256"}, {"calcomp565"}, {"minigraf0507"}, {"parallel"}};
  }

  // The commands are sent over each attached link.
  explicit SkalaMachine(std::vector<std::uint8_t> commands, const std::vector<Attachment>& attachments = everything())
      : commands_(std::move(commands)) {
    machine_.strokes().hand_to(&strokes_);
    for (const Attachment& each : attachments) {
      EXPECT_EQ(machine_.attach(each.device, each.settings), "");
      if (core::LinkHost* const host = machine_.device(each.device)->link_host(); host != nullptr) host->send(commands_);
    }
    machine_.load(0, program().image.bytes());
  }

  // Runs to the halt and returns the status; nothing if the program does not halt.
  std::optional<std::uint8_t> run() {
    i8080::Limits limits;
    limits.until = core::at_t_state(100'000'000'000);
    if (machine_.run(limits) != i8080::StopReason::halt) return std::nullopt;
    return machine_.peek(label("STATUS"));
  }
  // Runs until an instruction at `label` is about to be executed, at most n instructions.
  bool run_to(std::string_view name, std::uint64_t n) {
    const std::uint16_t address = label(name);
    while (n-- > 0) {
      if (machine_.registers().pc == address) return true;
      i8080::Limits limits;
      limits.instructions = 1;
      if (machine_.run(limits) == i8080::StopReason::halt) return false;
    }
    return false;
  }

  [[nodiscard]] i8080::Machine& machine() { return machine_; }
  [[nodiscard]] const devices::Ef9365& ef9365() const { return *machine_.find<devices::Ef9365>(); }
  [[nodiscard]] const devices::Alt256& alt256() const { return *machine_.find<devices::Alt256>(); }
  [[nodiscard]] const std::vector<core::Stroke>& strokes() const { return strokes_.all; }
  [[nodiscard]] std::span<const std::uint8_t> page(std::string_view name) {
    return machine_.memory().subspan(label(name), 256);
  }

 private:
  std::vector<std::uint8_t> commands_;
  Strokes strokes_;
  i8080::Machine machine_;
};

}  // namespace sightline::skala_test
