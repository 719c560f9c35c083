// All commands of `sightline`. Each function adds one command, with its subcommands, to the program.
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
void add_verify_command(const Command& program);

// `report` runs the separate program sightline-report, which need not be built and installed.
void add_report_command(const Command& program);
// The path of that program, beside `sightline` or in the folder of an installation; empty if there is none.
[[nodiscard]] std::optional<std::string> report_program();
// Replaces this process by sightline-report. Returns only if it is not found: prints an error and returns io.
[[nodiscard]] ExitCode run_report_program(char** argv);

}  // namespace sightline::app
