// The command `sightline`: its subcommands, in the order in which its help lists them.
#include <array>
#include <string_view>

#include "host/app/command_line.hpp"
#include "host/app/commands/commands.hpp"

namespace sightline::app {
namespace {

void add_commands(const Command& program) {
  add_demo_command(program);
  add_report_command(program);
  add_jones_command(program);
  add_skala_command(program);
  add_stripes_command(program);
  add_draw_command(program);
  add_compare_command(program);
  add_explain_command(program);
  add_spin_command(program);
  add_turn_command(program);
  add_flight_command(program);
  add_sweep_command(program);
  add_asm_command(program);
  add_disasm_command(program);
  add_run_command(program);
  add_monitor_command(program);
  add_dap_command(program);
  add_page_command(program);
  add_scene_command(program);
}

}  // namespace
}  // namespace sightline::app

int main(int argc, char** argv) {
  const auto is = [&](int n, std::string_view word) { return n < argc && argv[n] == word; };
  if (is(1, "report")) return static_cast<int>(sightline::app::run_report_program(argv));
  if (is(1, "help") && is(2, "report")) {
    std::array<char*, 4> words{argv[0], argv[2], const_cast<char*>("--help"), nullptr};
    return static_cast<int>(sightline::app::run_report_program(words.data()));
  }
  return sightline::app::run_command_line(argc, argv, sightline::app::help_page("sightline"),
                                          sightline::app::add_commands, sightline::app::help_page("greeting").text);
}
