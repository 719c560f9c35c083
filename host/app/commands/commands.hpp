// Every command of `sightline`. Each function adds one, with its subcommands, to the program.
#pragma once

#include <optional>
#include <string>

#include "host/app/command_line.hpp"

namespace sightline::app {

void add_asm_command(const Command& program);
void add_atlas_command(const Command& program);
void add_compare_command(const Command& program);
void add_demo_command(const Command& program);
void add_disasm_command(const Command& program);
void add_draw_command(const Command& program);
void add_flight_command(const Command& program);
void add_hard_command(const Command& program);
void add_jones_command(const Command& program);
void add_page_command(const Command& program);
void add_run_command(const Command& program);
void add_monitor_command(const Command& program);
void add_dap_command(const Command& program);
void add_explain_command(const Command& program);
void add_scene_command(const Command& program);
void add_skala_command(const Command& program);
void add_spin_command(const Command& program);
void add_stripes_command(const Command& program);
void add_sweep_command(const Command& program);
void add_turn_command(const Command& program);

// `report` is a program of its own, sightline-report, so that only those who want it build and install it.
// The command stands in the list and runs that program.
void add_report_command(const Command& program);
// Where that program is: beside `sightline`, or where an installation has it.
[[nodiscard]] std::optional<std::string> report_program();
// Becomes sightline-report, found beside `sightline` or where an installation has it. Returns only if there
// is none: io, said.
[[nodiscard]] ExitCode run_report_program(char** argv);

}  // namespace sightline::app
