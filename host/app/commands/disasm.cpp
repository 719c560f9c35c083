// See disasm.hpp.
#include "host/app/commands/disasm.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "host/app/commands/disasm_i8080.hpp"
#include "host/app/image_argument.hpp"
#include "tools/disasm/disasm.hpp"

namespace sightline::app {

namespace {

struct DisasmArguments {
  std::string file;
  std::string output = "-";
};

constexpr const char* pdp7_examples =
    "Examples:\n"
    "  sightline disasm pdp7 hello.rim\n"
    "      the tape as source; `sightline asm pdp7` makes the same words of it again\n"
    "  sightline disasm pdp7 words.hri@200 -o words.s\n"
    "      a tape for the READ IN key has no address of its own\n\n"
    "The kind of file (RIM tape, HRI tape, octal core image) is recognised by its content; - is standard "
    "input.\n"
    "A word that is no named instruction comes out in octal.\n";

constexpr const char* type340_examples =
    "Examples:\n"
    "  sightline disasm type340 picture.oct\n"
    "      every display word in octal, with its meaning in a comment\n"
    "  sightline run pdp7 --load a.rim --dump - --max-time 1 | tail -n +2 | sightline disasm type340 -\n"
    "      look for display files in core after a run\n\n"
    "The first word is read in mode 0 (parameter), the following ones as each word says, until a stop; after "
    "a stop or\n"
    "a gap mode 0 begins again. The output is source that assembles to the same words.\n";

using Disassembler = std::string (*)(const image::CoreImage&);

void add_target(CLI::App& parent, const char* name, const char* what, const char* examples,
                Disassembler disassemble, ExitCode& exit_code) {
  CLI::App* const command = parent.add_subcommand(name, what);
  const auto arguments = std::make_shared<DisasmArguments>();
  command->add_option("FILE", arguments->file, "Tape or octal core image, FILE[@ADDRESS], ADDRESS in octal")
      ->required();
  command->add_option("-o,--output", arguments->output, "Where the source goes; - is standard output")
      ->capture_default_str()
      ->type_name("FILE");
  command->footer(examples);
  command->callback([arguments, disassemble, &exit_code] {
    const image::CoreImage core = load_image(image_argument("FILE", arguments->file));
    Output output(arguments->output);
    output.write(disassemble(core));
    output.commit();
    exit_code = ExitCode::ok;
  });
}

}  // namespace

void add_disasm_command(CLI::App& app, ExitCode& exit_code) {
  CLI::App* const command =
      app.add_subcommand("disasm", "Disassemble a tape, a core image or an 8080 program");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  sightline disasm pdp7 hello.rim\n"
      "  sightline disasm type340 picture.oct\n"
      "  sightline disasm i8080 hello.com\n");
  add_target(*command, "pdp7", "PDP-7 instructions", pdp7_examples, &disassembler::disassemble_pdp7,
             exit_code);
  add_target(*command, "type340", "Display words of the Type 340", type340_examples,
             &disassembler::disassemble_type340, exit_code);
  add_disasm_i8080_command(*command, exit_code);
}

}  // namespace sightline::app
