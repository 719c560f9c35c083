// See disasm_i8080.hpp.
#include "host/app/commands/disasm_i8080.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "host/app/byte_image_argument.hpp"
#include "tools/disasm/i8080.hpp"

namespace sightline::app {

namespace {

struct DisasmI8080Arguments {
  std::string file;
  std::string format;
  std::string output = "-";
};

constexpr const char* disasm_i8080_examples =
    "Examples:\n"
    "  sightline disasm i8080 hello.com\n"
    "      the program as source; `sightline asm i8080` makes the same bytes of it again\n"
    "  sightline disasm i8080 rom.bin@E000 -o rom.asm\n"
    "      raw bytes have no address of their own; without @ADDRESS they go to 0000\n\n"
    "Without --format the ending decides (.com .bin .hex), and for another ending the content: a text that "
    "begins with\n"
    "`:` is Intel HEX, all else raw bytes. An undocumented opcode comes out as DB, with what it does in the "
    "comment.\n";

}  // namespace

void add_disasm_i8080_command(CLI::App& parent, ExitCode& exit_code) {
  CLI::App* const command = parent.add_subcommand("i8080", "8080 instructions");
  const auto arguments = std::make_shared<DisasmI8080Arguments>();
  command
      ->add_option("FILE", arguments->file,
                   "Program, FILE[@ADDRESS], ADDRESS in hexadecimal; - is standard input")
      ->required();
  command->add_option("--format", arguments->format, "Form of the file")
      ->check(CLI::IsMember({"com", "bin", "hex"}))
      ->default_str("by its ending or content")
      ->type_name("FORMAT");
  command->add_option("-o,--output", arguments->output, "Where the source goes; - is standard output")
      ->capture_default_str()
      ->type_name("FILE");
  command->footer(disasm_i8080_examples);
  command->callback([arguments, &exit_code] {
    const auto format =
        arguments->format.empty() ? std::nullopt : std::optional(byte_format_named(arguments->format));
    const image::ByteImage memory = load_byte_image(byte_image_argument("FILE", arguments->file), format);
    Output output(arguments->output);
    output.write(disassembler::disassemble_i8080(memory));
    output.commit();
    exit_code = ExitCode::ok;
  });
}

}  // namespace sightline::app
