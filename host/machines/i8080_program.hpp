// An assembled 8080 program whose sources are embedded. All 8080 guests are such programs. They are part of this
// executable, so an error in one ends the process.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "tools/asm/i8080.hpp"

namespace sightline::machines {

class I8080Program {
 public:
  // `sources`: pairs of name without folder and text. `called`: the program's name for messages.
  template <class Sources>
  I8080Program(const Sources& sources, const std::string& main_source, std::string_view called) : called_(called) {
    const auto text_of = [&sources](const std::string& path) -> std::optional<std::string> {
      const std::string name = path.substr(path.rfind('/') + 1);
      const auto found = std::find_if(sources.begin(), sources.end(), [&](const auto& source) { return source.first == name; });
      if (found == sources.end()) return std::nullopt;
      return std::string(found->second);
    };
    assembler::I8080Options options;
    options.listing = false;
    options.include = text_of;
    const std::vector<assembler::SourceFile> files{{main_source, text_of(main_source).value_or("")}};
    assembly_ = assembler::assemble_i8080(files, options);
    if (assembly_.ok()) return;
    std::string text = fmt::format("{} does not assemble:\n", called_);
    for (const auto& diagnostic : assembly_.diagnostics) text += assembler::to_string(diagnostic) + "\n";
    base::give_up(text);
  }

  [[nodiscard]] const assembler::I8080Assembly& assembly() const { return assembly_; }
  // From address 0 to the last byte.
  [[nodiscard]] std::vector<std::uint8_t> memory() const {
    const auto bytes = assembly_.image.bytes().first(assembly_.image.highest() + std::size_t{1});
    return {bytes.begin(), bytes.end()};
  }
  [[nodiscard]] std::uint16_t at(std::string_view label) const {
    const auto value = assembly_.value_of(label);
    if (!value) base::give_up(fmt::format("{} has no label {}", called_, label));
    return static_cast<std::uint16_t>(*value);
  }

 private:
  std::string called_;
  assembler::I8080Assembly assembly_;
};

}  // namespace sightline::machines
