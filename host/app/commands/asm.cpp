// See asm.hpp.
#include "host/app/commands/asm.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/app/commands/asm_files.hpp"
#include "host/app/commands/asm_i8080.hpp"
#include "host/base/file.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/image/octal.hpp"
#include "tools/image/tape.hpp"

namespace sightline::app {

namespace {

struct AsmArguments {
  AsmFiles files;
  std::vector<std::string> defines;
  std::string format = "rim";
  bool twos_complement = false;
  bool undefined_are_variables = false;
  bool first_line_is_title = false;
};

constexpr const char* asm_examples =
    "Examples:\n"
    "  sightline asm pdp7 hello.s -o hello.rim --listing hello.lst\n"
    "      a tape for `sightline run pdp7 --load hello.rim`, and a listing to read beside it\n"
    "  sightline asm pdp7 -D EAE=0 program.s data.s --format octal -o program.oct\n"
    "      two source tapes of one program, for a machine without the EAE, as an octal core image\n\n"
    "The sources are read one after the other, as the tapes of one program; `-` is standard input. Numbers "
    "are octal.\n"
    "rim: paper tape in read-in mode, carries addresses below 20000 and the start address. hri: tape for the "
    "READ IN\n"
    "key, carries no address: load it with FILE@ADDRESS. octal: text, six-digit words, `NNNNN:` sets the "
    "address, no\n"
    "start address. Errors name file:line:column; when there is one nothing is written.\n";

assembler::Options options_from(const AsmArguments& arguments) {
  assembler::Options options;
  options.defines = read_defines(arguments.defines, &assembler::parse_define);
  options.twos_complement = arguments.twos_complement;
  options.undefined_are_variables = arguments.undefined_are_variables;
  options.first_line_is_title = arguments.first_line_is_title;
  return options;
}

base::Bytes encoded(const image::CoreImage& core, const AsmArguments& arguments) {
  if (arguments.format == "octal") {
    const std::string text = image::write_octal(core);
    return {text.begin(), text.end()};
  }
  const std::string file = arguments.files.output == "-" ? "standard output" : arguments.files.output;
  const auto tape = arguments.format == "hri" ? image::write_hri(core, file) : image::write_rim(core, file);
  if (!tape) throw Failure(ExitCode::bad_input, tape.error().message(base::MessageStyle::compiler));
  return tape.value();
}

std::string summary(const assembler::Assembly& assembly, const AsmArguments& arguments) {
  const auto& words = assembly.image.words;
  std::string text = fmt::format("{} words", words.size());
  if (!words.empty()) text += fmt::format(" in {:05o}-{:05o}", words.begin()->first, words.rbegin()->first);
  if (assembly.image.start) {
    text += fmt::format(", start {:05o}", *assembly.image.start);
  } else {
    text += ", no start address";
  }
  text += fmt::format(", {} symbols", assembly.symbols.size());
  if (arguments.files.output.empty()) return text + "; checked only, -o FILE writes it";
  if (arguments.format == "hri" && !words.empty())
    text += fmt::format("; load it @{:o}", words.begin()->first);
  return text;
}

void assemble(const AsmArguments& arguments) {
  refuse_clashing_files(arguments.files);
  const auto options = options_from(arguments);
  const auto assembly = assembler::assemble_pdp7(read_sources(arguments.files), options);
  report_diagnostics(assembly.diagnostics);
  const base::Bytes program =
      arguments.files.output.empty() ? base::Bytes{} : encoded(assembly.image, arguments);
  write_asm_files(arguments.files, program, assembler::write_listing(assembly.listing),
                  assembler::write_symbols(assembly.symbols));
  complain(summary(assembly, arguments));
}

}  // namespace

void add_asm_command(CLI::App& app, ExitCode& exit_code) {
  CLI::App* const command = app.add_subcommand("asm", "Assemble source for the PDP-7 or the 8080");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  sightline asm pdp7 hello.s -o hello.rim\n"
      "  sightline asm i8080 hello.asm -o hello.com\n");
  CLI::App* const pdp7 =
      command->add_subcommand("pdp7", "Assemble PDP-7 symbolic source (DEC syntax, DIGITAL-7-3-S)");
  const auto arguments = std::make_shared<AsmArguments>();
  pdp7->add_option("SOURCE", arguments->files.sources, "Source files, in order; - is standard input")
      ->required();
  pdp7->add_option("-D", arguments->defines,
                   "Define a symbol, NAME=VALUE, VALUE in octal; wins over the source's own")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  pdp7->add_option("-o,--output", arguments->files.output, "Where the program goes; - is standard output")
      ->type_name("FILE");
  pdp7->add_option("--format", arguments->format, "Form of the program")
      ->check(CLI::IsMember({"rim", "hri", "octal"}))
      ->capture_default_str()
      ->type_name("FORMAT");
  pdp7->add_option("--listing", arguments->files.listing,
                   "Write address, octal word and source, line by line")
      ->type_name("FILE");
  pdp7->add_option("--symbols", arguments->files.symbols, "Write the symbols, one `name value` a line")
      ->type_name("FILE");
  pdp7->add_flag("--twos-complement", arguments->twos_complement,
                 "-1 is 777777 (default: one's complement, 777776)");
  pdp7->add_flag("--undefined-are-variables", arguments->undefined_are_variables,
                 "DEC's rule: an undefined symbol is a variable (default: an error)");
  pdp7->add_flag("--title", arguments->first_line_is_title,
                 "The first line of each source is a title, not assembled");
  pdp7->footer(asm_examples);
  pdp7->callback([arguments, &exit_code] {
    assemble(*arguments);
    exit_code = ExitCode::ok;
  });
  add_asm_i8080_command(*command, exit_code);
}

}  // namespace sightline::app
