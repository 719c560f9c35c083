// The resident Skala program on its machine, for tests: assembled from the source tree, fed over the parallel
// link.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/machines/i8080_machine.hpp"
#include "emulators/machines/skala_ports.hpp"
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
  return value.value_or(0);
}

struct Strokes {
  static constexpr bool consumes = true;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) { strokes.push_back(stroke); }
  void end_pass(core::Instant) {}
  std::vector<core::Stroke> strokes;
};

class SkalaMachine {
 public:
  using Ports = machines::SkalaPorts<Strokes>;

  // All devices, unless the configuration says otherwise.
  explicit SkalaMachine(std::vector<std::uint8_t> commands)
      : SkalaMachine(std::move(commands), everything()) {}
  SkalaMachine(std::vector<std::uint8_t> commands, machines::SkalaConfiguration configuration)
      : commands_(std::move(commands)) {
    if (configuration.serial) configuration.serial = commands_;
    if (configuration.parallel) configuration.parallel = commands_;
    ports_ = std::make_unique<Ports>(configuration, strokes_);
    machine_ = std::make_unique<machines::I8080Machine<Ports>>(*ports_, observer_);
    const auto bytes = program().image.bytes();
    std::copy(bytes.begin(), bytes.end(), machine_->memory().begin());
  }

  static machines::SkalaConfiguration everything() {
    machines::SkalaConfiguration configuration;
    configuration.ef9365 = configuration.alt256 = configuration.calcomp565 = configuration.minigraf0507 =
        true;
    configuration.parallel.emplace();
    return configuration;
  }

  // Runs to the halt; the status; empty if it does not end.
  std::optional<std::uint8_t> run() {
    machines::I8080Limits limits;
    limits.until = core::at_t_state(100'000'000'000);
    if (machine_->run(limits) != machines::I8080StopReason::halt) return std::nullopt;
    return machine_->peek(label("STATUS"));
  }
  // Runs until an instruction at `label` is about to be executed, at most n instructions.
  bool run_to(std::string_view name, std::uint64_t n) {
    const std::uint16_t address = label(name);
    while (n-- > 0) {
      if (machine_->registers().pc == address) return true;
      machines::I8080Limits limits;
      limits.instructions = 1;
      if (machine_->run(limits) == machines::I8080StopReason::halt) return false;
    }
    return false;
  }

  [[nodiscard]] machines::I8080Machine<Ports>& machine() { return *machine_; }
  [[nodiscard]] Ports& ports() { return *ports_; }
  [[nodiscard]] const std::vector<core::Stroke>& strokes() const { return strokes_.strokes; }
  [[nodiscard]] std::span<const std::uint8_t> page(std::string_view name) {
    return machine_->memory().subspan(label(name), 256);
  }

 private:
  std::vector<std::uint8_t> commands_;
  Strokes strokes_;
  machines::NoI8080Observer observer_;
  std::unique_ptr<Ports> ports_;
  std::unique_ptr<machines::I8080Machine<Ports>> machine_;
};

}  // namespace sightline::skala_test
