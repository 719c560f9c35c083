#include "tools/asm/i8080.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "host/base/result.hpp"
#include "tools/asm/i8080/lexer.hpp"
#include "tools/asm/i8080/pass.hpp"
#include "tools/asm/symbol_table.hpp"

namespace sightline::assembler {
namespace {

using image::hexadecimal;

constexpr std::size_t symbols_a_row = 4;  // of the listing's table
constexpr std::size_t symbol_width = 20;

void enter_defines(I8080Program& program, const I8080Options& options) {
  for (const I8080Define& define : options.defines) {
    I8080Entry& entry = program.symbols[folded(define.name)];
    entry.name = define.name;
    entry.kind = I8080SymbolKind::define;
    entry.value = define.value;
  }
}

void lay_out(I8080Program& program, const I8080Options& options, std::size_t sources, int& number) {
  // Enough for chains of EQUs that refer forward. A longer chain is an error.
  constexpr int most_layout_passes = 16;
  std::size_t unknown = 0;
  program.modules.resize(sources);
  const auto declares = [](const I8080Module& module) { return module.declares; };
  if (sources > 1) {
    I8080Pass(options, program, number, false).run(sources);
    program.modules_known = std::any_of(program.modules.begin(), program.modules.end(), declares);
    if (program.modules_known) {
      program.symbols.clear();
      program.unknown_values = 0;
      enter_defines(program, options);
    } else {
      ++number;
    }
  }
  do {
    unknown = program.unknown_values;
    I8080Pass(options, program, number++, false).run(sources);
  } while (number <= most_layout_passes &&
           (program.values_changed ||
            (program.unknown_values > 0 && (number == 2 || program.unknown_values < unknown))));
}

std::vector<I8080Symbol> symbols_of(const I8080Program& program) {
  std::vector<I8080Symbol> symbols;
  for (const auto& [key, entry] : program.symbols) {
    if (!entry.value) continue;
    const bool in_file = entry.kind != I8080SymbolKind::define;
    symbols.push_back({entry.name, *entry.value, entry.kind,
                       in_file ? program.files[entry.defined.file].name : "", entry.defined.line,
                       entry.defined.column});
  }
  std::sort(symbols.begin(), symbols.end(),
            [](const I8080Symbol& a, const I8080Symbol& b) {
              return std::tuple(folded(a.name), a.value, a.file, a.line) < std::tuple(folded(b.name), b.value, b.file, b.line);
            });
  return symbols;
}

void add_symbol_table(std::vector<ListingLine>& listing, std::span<const I8080Symbol> symbols) {
  if (!symbols.empty()) listing.push_back({"", "", ""});
  for (std::size_t i = 0; i < symbols.size(); i += symbols_a_row) {
    std::string row;
    for (const I8080Symbol& symbol : symbols.subspan(i, std::min(symbols_a_row, symbols.size() - i))) {
      std::string cell = hexadecimal(symbol.value, 4) + " " + symbol.name;
      cell.resize(std::max(cell.size() + 2, symbol_width), ' ');
      row += cell;
    }
    listing.push_back({"", "", std::move(row)});
  }
}

}  // namespace

base::Result<I8080Define> parse_i8080_define(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  if (name.empty() || end_of_name(name, 0) != name.size())
    return base::bad_input("found " + quoted(name) + ", expected a name");
  if (equals == std::string_view::npos) return base::bad_input("found no '=', expected NAME=VALUE");
  const bool reserved = Vocabulary().find(folded(name)) != nullptr;
  if (reserved) return base::bad_input("found " + quoted(name) + ", expected a name that is not reserved");
  const bool negative = text.substr(equals + 1).starts_with('-');
  I8080Lexer lexer(text, equals + (negative ? 2 : 1));
  const I8080Token number = lexer.next();
  if (number.kind != I8080TokenKind::number || number.wrapped || lexer.next().kind != I8080TokenKind::end) {
    return base::bad_input(
        "found " + quoted(text.substr(equals + 1)) + ", expected " +
        (number.kind == I8080TokenKind::bad ? number.value : "a number such as 10, 0AH or 0x0A, up to 65535"));
  }
  return I8080Define{std::string(name),
                     static_cast<std::uint16_t>(negative ? 0U - number.number : number.number)};
}

I8080Assembly assemble_i8080(std::span<const SourceFile> sources, const I8080Options& options) {
  I8080Program program;
  program.files.assign(sources.begin(), sources.end());
  enter_defines(program, options);
  int number = 1;
  lay_out(program, options, sources.size(), number);
  I8080Pass(options, program, number, true).run(sources.size());

  I8080Assembly assembly;
  assembly.diagnostics = std::move(program.diagnostics);
  if (assembly.ok()) assembly.image = std::move(program.image);
  assembly.symbols = symbols_of(program);
  assembly.listing = std::move(program.listing);
  if (options.listing) add_symbol_table(assembly.listing, assembly.symbols);
  return assembly;
}

std::optional<std::uint16_t> I8080Assembly::value_of(std::string_view name) const {
  const std::string key = folded(name);
  const auto at = std::lower_bound(
      symbols.begin(), symbols.end(), key,
      [](const I8080Symbol& symbol, const std::string& k) { return folded(symbol.name) < k; });
  if (at == symbols.end() || folded(at->name) != key) return std::nullopt;
  return at->value;
}

std::string write_i8080_symbols(std::span<const I8080Symbol> symbols) {
  std::string text;
  for (const I8080Symbol& symbol : symbols) text += symbol.name + " " + hexadecimal(symbol.value, 4) + "\n";
  return text;
}

}  // namespace sightline::assembler
