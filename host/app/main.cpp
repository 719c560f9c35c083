// The command `sightline`: its subcommands, in the order in which its help lists them.
#include <string_view>

#include "host/app/command_line.hpp"
#include "host/app/commands/commands.hpp"

namespace sightline::app {
namespace {

constexpr const char* sightline_examples =
    "Examples:\n"
    "  sightline jones house -o out\n"
    "      run Jones's program on a scene: pictures in out/, times on the terminal\n"
    "  sightline skala lines sinc -o out\n"
    "      run Skala's program on the 8080: a function of two variables with its hidden lines removed\n"
    "  sightline draw exact part.off -o part.svg\n"
    "      a solid drawn by a program of today\n"
    "  sightline draw skala sinc -o sinc.svg\n"
    "      the same function drawn today, as vectors\n"
    "  sightline asm pdp7 hello.s -o hello.rim && sightline run pdp7 --load hello.rim\n"
    "      assemble a program of your own and run it on the PDP-7\n\n"
    "`sightline jones` and `sightline skala` run the old programs themselves on emulated machines, with "
    "their "
    "limits and in their time. `sightline draw jones` and `sightline draw skala` draw by the same methods, "
    "written for today's machines: any scene, any grid.\n\n"
    "Words:\n"
    "  guest   the old program on its emulated machine: Jones's on the PDP-7, Skala's on the 8080\n"
    "  twin    what a guest computes, bit for bit, written again for this computer without the emulator\n"
    "  native  a method of 1971 to 1990, or an exact one of today, written for this computer\n"
    "  oracle  the slow and simple program that all are checked by; it shares no visibility code with "
    "them\n\n"
    "`sightline COMMAND --help` explains a command and its options. Numbers of the PDP-7 are octal.\n"
    "Data goes to standard output, messages to standard error.\n";

void add_commands(const Command& program) {
  add_demo_command(program);
  add_report_command(program);
  add_jones_command(program);
  add_skala_command(program);
  add_draw_command(program);
  add_compare_command(program);
  add_spin_command(program);
  add_sweep_command(program);
  add_asm_command(program);
  add_disasm_command(program);
  add_run_command(program);
  add_scene_command(program);
}

}  // namespace
}  // namespace sightline::app

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "report")
    return static_cast<int>(sightline::app::run_report_program(argv));
  return sightline::app::run_command_line(argc, argv, sightline::app::sightline_examples,
                                          sightline::app::add_commands);
}
