// Any bytes as 8080 source. If it assembles, its disassembly must assemble to the same bytes. The size selects the dialect.
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "tools/asm/i8080.hpp"
#include "tools/disasm/i8080.hpp"

namespace {

using namespace sightline;

void check_round_trip(const image::ByteImage& image, const assembler::I8080Options& read) {
  assembler::I8080Options options;
  options.dialect = read.dialect;
  const std::vector<assembler::SourceFile> again{{"again", disassembler::disassemble_i8080(image)}};
  if (assembler::assemble_i8080(again, options).image != image) std::abort();
}

}  // namespace

// A form feed at the start of a line separates the source from the text that every INCLUDE reads.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const std::size_t cut = text.find("\n\f");
  assembler::I8080Options options;
  options.defines = {{"DEFINED", 3}};
  options.most_lines = 3000;
  options.dialect = static_cast<assembler::I8080Dialect>(size % assembler::i8080_dialect_names.size());
  options.include = [&](const std::string& path) -> std::optional<std::string> {
    if (cut == std::string::npos || path.find('x') != std::string::npos) return std::nullopt;
    return text.substr(cut + 2);
  };
  const std::vector<assembler::SourceFile> sources{{"a", text.substr(0, cut)}};
  const assembler::I8080Assembly assembly = assembler::assemble_i8080(sources, options);
  static_cast<void>(assembler::write_listing(assembly.listing));
  static_cast<void>(assembler::write_i8080_symbols(assembly.symbols));
  for (const auto& diagnostic : assembly.diagnostics) static_cast<void>(assembler::to_string(diagnostic));
  if (assembly.ok()) check_round_trip(assembly.image, options);
  return 0;
}
