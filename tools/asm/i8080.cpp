#include "tools/asm/i8080.hpp"

#include <algorithm>
#include <utility>

#include "host/base/result.hpp"
#include "tools/asm/i8080/lexer.hpp"
#include "tools/asm/i8080/pass.hpp"

namespace sightline::assembler {
namespace {

using image::hexadecimal;

constexpr std::size_t symbols_a_row = 4;  // of the listing's table
constexpr std::size_t symbol_width = 20;

void add_symbol_table(std::vector<ListingLine>& listing, std::span<const ProgramSymbol> symbols) {
  if (!symbols.empty()) listing.push_back({"", "", ""});
  for (std::size_t i = 0; i < symbols.size(); i += symbols_a_row) {
    std::string row;
    for (const ProgramSymbol& symbol : symbols.subspan(i, std::min(symbols_a_row, symbols.size() - i))) {
      std::string cell = hexadecimal(symbol.value, 4) + " " + symbol.name;
      cell.resize(std::max(cell.size() + 2, symbol_width), ' ');
      row += cell;
    }
    listing.push_back({"", "", std::move(row)});
  }
}

}  // namespace

base::Result<Define> parse_i8080_define(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  if (name.empty() || end_of_name(name, 0) != name.size())
    return base::bad_input("found " + quoted(name) + ", expected a name");
  if (equals == std::string_view::npos) return base::bad_input("found no '=', expected NAME=VALUE");
  const bool reserved = find_word(folded(name)) != nullptr;
  if (reserved) return base::bad_input("found " + quoted(name) + ", expected a name that is not reserved");
  const bool negative = text.substr(equals + 1).starts_with('-');
  I8080Lexer lexer(text, equals + (negative ? 2 : 1));
  const I8080Token number = lexer.next();
  if (number.kind != I8080TokenKind::number || number.wrapped || lexer.next().kind != I8080TokenKind::end) {
    return base::bad_input(
        "found " + quoted(text.substr(equals + 1)) + ", expected " +
        (number.kind == I8080TokenKind::bad ? number.value : "a number such as 10, 0AH or 0x0A, up to 65535"));
  }
  return Define{std::string(name), (negative ? 0U - number.number : number.number) & 0xFFFFU};
}

I8080Assembly assemble_i8080(std::span<const SourceFile> sources, const I8080Options& options) {
  I8080Program program(sources, {.dollar_counts = rules_of(options.dialect).dollar_in_names});
  program.engine.run(
      [&] {
        for (const Define& define : options.defines) program.engine.enter(define.name, define.value, SymbolKind::define);
      },
      [&] { I8080Pass(options, program).run(); });
  I8080Assembly assembly;
  program.engine.finish(assembly, false);
  if (assembly.ok()) {
    program.engine.for_each_cell([&](std::uint32_t address, std::uint32_t byte) {
      assembly.image.put(static_cast<std::uint16_t>(address), static_cast<std::uint8_t>(byte));
    });
    assembly.image.start = program.start;
  }
  if (options.listing) add_symbol_table(assembly.listing, assembly.symbols);
  return assembly;
}

std::string write_i8080_symbols(std::span<const ProgramSymbol> symbols) { return write_symbols(symbols, hexadecimal_bytes); }

}  // namespace sightline::assembler
