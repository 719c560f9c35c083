// Any bytes as PDP-7 source. If it assembles, its disassembly must assemble to the same words.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tools/asm/pdp7.hpp"
#include "tools/disasm/disasm.hpp"

namespace {

using namespace sightline;

void check_round_trip(const image::CoreImage& image) {
  const std::vector<assembler::SourceFile> again{{"again", disassembler::disassemble_pdp7(image)}};
  if (assembler::assemble_pdp7(again).image != image) std::abort();
}

}  // namespace

// The first byte selects options; a form feed at the start of a line separates two sources.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  assembler::Options options;
  options.twos_complement = (data[0] & 1U) != 0;
  options.undefined_are_variables = (data[0] & 2U) != 0;
  options.first_line_is_title = (data[0] & 4U) != 0;
  const std::string text(data + 1, data + size);
  const std::size_t cut = text.find("\n\f");
  std::vector<assembler::SourceFile> sources{{"a", text.substr(0, cut)}};
  if (cut != std::string::npos) sources.push_back({"b", text.substr(cut + 2)});
  const assembler::Assembly assembly = assembler::assemble_pdp7(sources, options);
  static_cast<void>(assembler::write_listing(assembly.listing));
  static_cast<void>(assembler::write_symbols(assembly.symbols));
  for (const auto& diagnostic : assembly.diagnostics) static_cast<void>(assembler::to_string(diagnostic));
  if (assembly.ok()) check_round_trip(assembly.image);
  return 0;
}
