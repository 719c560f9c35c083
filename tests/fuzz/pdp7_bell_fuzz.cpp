// Any bytes as PDP-7 source in the dialect of Bell Laboratories. If it assembles, the disassemblies in this dialect and in
// DEC's language must assemble to the same words.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tools/asm/pdp7.hpp"
#include "tools/disasm/disasm.hpp"

namespace {

using namespace sightline;

assembler::Assembly assemble(const std::vector<assembler::SourceFile>& sources, assembler::Dialect dialect) {
  assembler::Options options;
  options.dialect = dialect;
  return assembler::assemble_pdp7(sources, options);
}

void check_round_trips(const image::CoreImage& image) {
  const auto text = disassembler::disassemble_pdp7_bell(image);
  if (!text) std::abort();  // the dialect can express all words that it makes
  if (assemble({{"again", *text}}, assembler::Dialect::bell).image != image) std::abort();
  if (assemble({{"dec", disassembler::disassemble_pdp7(image)}}, assembler::Dialect::dec).image != image)
    std::abort();
}

}  // namespace

// A form feed at the start of a line separates two sources.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const std::size_t cut = text.find("\n\f");
  std::vector<assembler::SourceFile> sources{{"a", text.substr(0, cut)}};
  if (cut != std::string::npos) sources.push_back({"b", text.substr(cut + 2)});
  const assembler::Assembly assembly = assemble(sources, assembler::Dialect::bell);
  static_cast<void>(assembler::write_listing(assembly.listing));
  static_cast<void>(assembler::write_symbols(assembly.symbols));
  for (const auto& diagnostic : assembly.diagnostics) static_cast<void>(assembler::to_string(diagnostic));
  if (assembly.ok()) check_round_trips(assembly.image);
  return 0;
}
