// See asm_i8080.hpp.
#include "host/app/commands/asm_i8080.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/app/byte_image_argument.hpp"
#include "host/app/commands/asm_files.hpp"
#include "host/base/file.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/image/binary.hpp"
#include "tools/image/intel_hex.hpp"

namespace sightline::app {

namespace {

struct AsmI8080Arguments {
  AsmFiles files;
  std::vector<std::string> defines;
  std::string format;
};

constexpr const char* asm_i8080_examples =
    "Examples:\n"
    "  sightline asm i8080 hello.asm -o hello.com --listing hello.prn\n"
    "      a CP/M program for `sightline run i8080 --cpm --load hello.com`, and a listing to read beside it\n"
    "  sightline asm i8080 -D SERIAL=0 -D BASE=0E000H main.asm tables.asm -o monitor.hex\n"
    "      two sources of one program as Intel HEX, which carries addresses and the start address of END\n\n"
    "The language is that of Intel's ASM80, CP/M's ASM and MAC and Microsoft's MACRO-80. The sources are "
    "read "
    "one after\n"
    "the other; `-` is standard input. INCLUDE and MACLIB look beside the file they stand in.\n"
    "com: bytes from 0100H, nothing below. bin: bytes from the lowest to the highest address, gaps as 00. "
    "hex: "
    "Intel HEX.\n"
    "Without --format the ending of -o decides: .com, .bin, anything else is hex.\n"
    "Errors name file:line:column; when there is one nothing is written.\n";

assembler::I8080Options options_from(const AsmI8080Arguments& arguments) {
  assembler::I8080Options options;
  options.defines = read_defines(arguments.defines, &assembler::parse_i8080_define);
  options.listing = !arguments.files.listing.empty();
  // The assembler tries several names and says itself that none of them could be read. A source says nothing
  // about standard input: `-` is a name like any other, and no such file is there.
  options.include = [](const std::string& path) -> std::optional<std::string> {
    if (path == "-") return std::nullopt;
    try {
      return read_input_text(path);
    } catch (const Failure&) {
      return std::nullopt;
    }
  };
  return options;
}

base::Bytes encoded(const image::ByteImage& memory, const AsmI8080Arguments& arguments) {
  const ByteFormat format = arguments.format.empty()
                                ? byte_format_of_name(arguments.files.output).value_or(ByteFormat::hex)
                                : byte_format_named(arguments.format);
  if (format == ByteFormat::hex) {
    const std::string text = image::write_intel_hex(memory);
    return {text.begin(), text.end()};
  }
  const std::string file = arguments.files.output == "-" ? "standard output" : arguments.files.output;
  const auto bytes =
      format == ByteFormat::com ? image::write_com(memory, file) : image::write_binary(memory, file);
  if (!bytes) throw Failure(ExitCode::bad_input, bytes.error().message(base::MessageStyle::compiler));
  return bytes.value();
}

std::string summary(const assembler::I8080Assembly& assembly, const AsmI8080Arguments& arguments) {
  const image::ByteImage& memory = assembly.image;
  std::string text = fmt::format("{} bytes", memory.count());
  if (!memory.empty()) text += fmt::format(" in {:04X}-{:04X}", memory.lowest(), memory.highest());
  text += memory.start ? fmt::format(", start {:04X}", *memory.start) : ", no start address";
  text += fmt::format(", {} symbols", assembly.symbols.size());
  return arguments.files.output.empty() ? text + "; checked only, -o FILE writes it" : text;
}

void assemble(const AsmI8080Arguments& arguments) {
  refuse_clashing_files(arguments.files);
  const auto options = options_from(arguments);
  const auto assembly = assembler::assemble_i8080(read_sources(arguments.files), options);
  report_diagnostics(assembly.diagnostics);
  const base::Bytes program =
      arguments.files.output.empty() ? base::Bytes{} : encoded(assembly.image, arguments);
  write_asm_files(arguments.files, program, assembler::write_listing(assembly.listing),
                  assembler::write_i8080_symbols(assembly.symbols));
  complain(summary(assembly, arguments));
}

}  // namespace

void add_asm_i8080_command(CLI::App& parent, ExitCode& exit_code) {
  CLI::App* const command =
      parent.add_subcommand("i8080", "Assemble 8080 source (Intel ASM80, CP/M ASM and MAC, MACRO-80)");
  const auto arguments = std::make_shared<AsmI8080Arguments>();
  command->add_option("SOURCE", arguments->files.sources, "Source files, in order; - is standard input")
      ->required();
  command
      ->add_option(
          "-D", arguments->defines,
          "Define a symbol, NAME=VALUE, VALUE as in a source (10, 0AH, 0x0A); wins over the source's own")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  command->add_option("-o,--output", arguments->files.output, "Where the program goes; - is standard output")
      ->type_name("FILE");
  command->add_option("--format", arguments->format, "Form of the program")
      ->check(CLI::IsMember({"com", "bin", "hex"}))
      ->default_str("by the ending of -o")
      ->type_name("FORMAT");
  command
      ->add_option("--listing", arguments->files.listing,
                   "Write address, bytes and source, line by line, and the symbols")
      ->type_name("FILE");
  command->add_option("--symbols", arguments->files.symbols, "Write the symbols, one `name value` a line")
      ->type_name("FILE");
  command->footer(asm_i8080_examples);
  command->callback([arguments, &exit_code] {
    assemble(*arguments);
    exit_code = ExitCode::ok;
  });
}

}  // namespace sightline::app
