#include "tools/asm/pdp7.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "tools/asm/pdp7/bell.hpp"
#include "tools/asm/pdp7/pass.hpp"

namespace sightline::assembler {
namespace {

void enter(SymbolTable& symbols, std::string_view name, std::uint32_t value, Form form, SymbolKind kind) {
  Symbol& symbol = symbols[name];
  symbol.kind = kind;
  symbol.value = value;
  symbol.form = static_cast<int>(form);
}

SymbolTable make_symbol_table(Dialect dialect) {
  return dialect == Dialect::bell ? SymbolTable(8, false) : SymbolTable(6);
}

void enter_permanent_symbols(SymbolTable& symbols) {
  for (const auto& row : pdp7::instructions) {
    enter(symbols, row.mnemonic, row.value, form_of_instruction(row.value), SymbolKind::permanent);
  }
  for (const auto& micro : pdp7::microinstructions) {
    enter(symbols, micro.name, micro.value, form_of_instruction(micro.value), SymbolKind::permanent);
  }
  for (const auto& device : pdp7::device_infos) {
    for (const core::IotName& iot : device.iots)
      enter(symbols, iot.mnemonic, iot.word, form_of_instruction(iot.word), SymbolKind::permanent);
  }
  enter(symbols, "i", pdp7::indirect_bit, Form::indirect, SymbolKind::permanent);
}

// Everything that must be the same in two successive passes before words are made.
auto layout(const Pdp7Program& program) {
  std::map<std::string, std::optional<std::uint32_t>> values;
  for (const auto& [key, symbol] : program.symbols) values.emplace(key, symbol.value);
  return std::tuple(std::move(values), program.pool_bases, program.relative_labels);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

ListingLine line_of(const EmittedWord& word, std::string source) {
  return {base::octal(word.address, 5), base::octal(word.word, 6), std::move(source)};
}

std::vector<ListingLine> make_listing(std::span<const SourceFile> sources,
                                      std::span<const EmittedWord> words) {
  std::vector<ListingLine> listing;
  std::size_t next = 0;
  for (std::size_t file = 0; file < sources.size(); ++file) {
    if (sources.size() > 1) listing.push_back({"", "", "/ " + sources[file].name});
    std::size_t number = 0;
    for (const std::string_view line : lines_of(sources[file].text)) {
      ++number;
      bool shown = false;
      for (; next < words.size() && words[next].at.file == file && words[next].at.line == number; ++next) {
        const EmittedWord& word = words[next];
        if (!shown && !word.generated_source.empty()) listing.push_back({"", "", std::string(line)});
        listing.push_back(
            line_of(word, shown || !word.generated_source.empty() ? word.generated_source : std::string(line)));
        listing.back().file = sources[file].name;
        listing.back().line_number = number;
        shown = true;
      }
      if (!shown) listing.push_back({"", "", std::string(line)});
    }
  }
  for (; next < words.size(); ++next) listing.push_back(line_of(words[next], words[next].generated_source));
  return listing;
}

std::vector<ProgramSymbol> program_symbols(std::span<const SourceFile> sources, const SymbolTable& table) {
  std::vector<ProgramSymbol> symbols;
  for (const auto& [key, symbol] : table) {
    if (symbol.kind == SymbolKind::permanent || !symbol.value) continue;
    const bool in_source = symbol.defined.line != 0;
    symbols.push_back({symbol.name, core::Word18(*symbol.value), symbol.kind,
                       in_source ? sources[symbol.defined.file].name : std::string(), symbol.defined.line,
                       symbol.defined.column});
  }
  return symbols;
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
  const core::Word18 word(value);
  return Define{std::string(name), negative ? ~word : word};
}

std::optional<core::Word18> Assembly::value_of(std::string_view name) const {
  const SymbolTable rule = make_symbol_table(dialect);
  const std::string key = rule.key(name);
  for (const ProgramSymbol& symbol : symbols) {
    if (rule.key(symbol.name) == key) return symbol.value;
  }
  return std::nullopt;
}

Assembly assemble_pdp7(std::span<const SourceFile> sources, const Options& options) {
  Assembly assembly;
  assembly.dialect = options.dialect;
  if (sources.empty()) return assembly;
  const bool bell = options.dialect == Dialect::bell;
  Pdp7Program program;
  program.modules.resize(sources.size());
  const auto begin = [&] {
    program.symbols = make_symbol_table(options.dialect);
    enter_permanent_symbols(program.symbols);
    if (bell) enter_bell_symbols(program.symbols);
    for (const Define& define : options.defines) {
      enter(program.symbols, define.name, define.value.value(), Form::plain, SymbolKind::define);
      program.symbols[define.name].name = define.name;
    }
  };
  begin();
  // Enough for a chain of forward references in literals that move each other. A longer chain is an error.
  constexpr int most_layout_passes = 12;
  int pass = 0;
  const auto read = [&](bool final = false) {
    if (bell) return BellPass(sources, program, pass, final).run();
    Pdp7Pass(sources, options, program, pass, final).run();
  };
  for (auto before = layout(program); ++pass <= most_layout_passes;) {
    read();
    const bool declares = sources.size() > 1 && std::any_of(program.modules.begin(), program.modules.end(),
                                                            [](const auto& module) { return module.declares; });
    if (declares && !program.modules_known) {
      program.modules_known = true;
      begin();
      program.pool_bases.clear();
      continue;
    }
    auto after = layout(program);
    if (after == before) break;
    before = std::move(after);
  }
  ++pass;
  read(true);
  if (bell) relocate_bell_symbols(program);

  std::stable_sort(program.diagnostics.begin(), program.diagnostics.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [at, diagnostic] : program.diagnostics) assembly.diagnostics.push_back(std::move(diagnostic));
  assembly.listing = make_listing(sources, program.words);
  assembly.symbols = program_symbols(sources, program.symbols);
  if (!assembly.ok()) return assembly;
  for (const EmittedWord& word : program.words) {
    assembly.image.words.insert_or_assign(word.address, core::Word18(word.word));
  }
  assembly.image.start = program.start;
  return assembly;
}

std::string write_symbols(std::span<const ProgramSymbol> symbols) {
  std::string text;
  for (const ProgramSymbol& symbol : symbols)
    text += symbol.name + " " + base::octal(symbol.value.value(), 6) + "\n";
  return text;
}

}  // namespace sightline::assembler
