#include "tools/asm/pdp7.hpp"

#include <algorithm>
#include <utility>

#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "tools/asm/pdp7/bell.hpp"
#include "tools/asm/pdp7/dec.hpp"

namespace sightline::assembler {
namespace {

void enter_names(Engine& engine, const Options& options) {
  const auto enter = [&engine](std::string_view name, std::uint32_t word) {
    engine.enter(name, word, SymbolKind::permanent, static_cast<int>(form_of_instruction(word)));
  };
  for (const auto& row : pdp7::instructions) enter(row.mnemonic, row.value);
  for (const auto& micro : pdp7::microinstructions) enter(micro.name, micro.value);
  for (const auto& device : pdp7::device_infos) {
    for (const core::IotName& iot : device.iots) enter(iot.mnemonic, iot.word);
  }
  engine.enter("i", pdp7::indirect_bit, SymbolKind::permanent, static_cast<int>(Form::indirect));
  if (options.dialect == Dialect::bell) enter("sys", pdp7::indirect_bit);  // cal i
  for (const Define& define : options.defines) engine.enter(define.name, define.value, SymbolKind::define);
}

}  // namespace

base::Result<Define> parse_define(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::string found = "found '" + std::string(text) + "', expected ";
  if (equals == std::string_view::npos || name.empty() || !letter(name[0]) ||
      !std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); })) {
    return base::bad_input(found + "NAME=VALUE with a name of letters and digits");
  }
  std::string_view digits = text.substr(equals + 1);
  const bool negative = !digits.empty() && digits[0] == '-';
  if (negative) digits.remove_prefix(1);
  const bool octal = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '7'; });
  if (digits.empty() || digits.size() > 6 || !octal)
    return base::bad_input(found + "a value of one to six octal digits");
  std::uint32_t value = 0;
  for (const char c : digits) value = value << 3 | static_cast<std::uint32_t>(c - '0');
  return Define{std::string(name), negative ? ~value & core::Word18::mask : value};
}

Assembly assemble_pdp7(std::span<const SourceFile> sources, const Options& options) {
  Assembly assembly;
  const bool bell = options.dialect == Dialect::bell;
  Pdp7Program program(sources, bell ? bell_naming : Naming{.significant = 6, .in_words = "six"});
  if (sources.empty()) return assembly;
  program.engine.run([&] { enter_names(program.engine, options); },
                     [&] {
                       if (bell) return BellPass(program).run();
                       DecPass(options, program).run();
                     });
  if (bell) relocate_bell_symbols(program);
  program.engine.finish(assembly, true);
  if (!assembly.ok()) return assembly;
  program.engine.for_each_cell([&](std::uint32_t address, std::uint32_t word) {
    assembly.image.words.emplace_hint(assembly.image.words.end(), address, core::Word18(word));
  });
  assembly.image.start = program.start;
  return assembly;
}

std::string write_symbols(std::span<const ProgramSymbol> symbols) { return write_symbols(symbols, octal_words); }

}  // namespace sightline::assembler
