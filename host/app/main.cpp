// The program `sightline` and its subcommands, in the order of its help.
#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "host/app/command_line.hpp"
#include "host/app/commands/commands.hpp"

namespace sightline::app {
namespace {

struct Entry {
  std::string_view name;
  void (*add)(const Command& program);
};

constexpr auto commands = std::to_array<Entry>({
    {"demo", add_demo_command},
    {"report", add_report_command},
    {"jones", add_jones_command},
    {"skala", add_skala_command},
    {"stripes", add_stripes_command},
    {"draw", add_draw_command},
    {"verify", add_verify_command},
    {"compare", add_compare_command},
    {"hard", add_hard_command},
    {"explain", add_explain_command},
    {"spin", add_spin_command},
    {"turn", add_turn_command},
    {"flight", add_flight_command},
    {"sweep", add_sweep_command},
    {"atlas", add_atlas_command},
    {"asm", add_asm_command},
    {"disasm", add_disasm_command},
    {"run", add_run_command},
    {"monitor", add_monitor_command},
    {"dap", add_dap_command},
    {"page", add_page_command},
    {"scene", add_scene_command},
});

// To set up the options of all commands takes longer than most commands take to run. If the first word names a command, only that
// command is added; for any other first word, `help` included, all are.
void add_commands(const Command& program, std::string_view first_word) {
  const auto* const named = std::find_if(commands.begin(), commands.end(), [&](const Entry& entry) { return entry.name == first_word; });
  if (named != commands.end()) return named->add(program);
  for (const Entry& entry : commands) entry.add(program);
}

// The arrays of a mesh are tens of megabytes long, and there are many, one after the other. Memory that is freed is kept for the next
// one: otherwise the kernel clears new pages each time, which is a tenth of the time of a drawing.
void keep_freed_memory() {
#if defined(__GLIBC__)
  // Before glibc 2.35 the threshold cannot be so high; then nothing is changed.
  if (mallopt(M_MMAP_THRESHOLD, 1 << 30) == 0) return;
  static_cast<void>(mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max()));
#endif
}

}  // namespace
}  // namespace sightline::app

int main(int argc, char** argv) {
  sightline::app::keep_freed_memory();
  const auto is = [&](int n, std::string_view word) { return n < argc && argv[n] == word; };
  if (is(1, "report")) return static_cast<int>(sightline::app::run_report_program(argv));
  if (is(1, "help") && is(2, "report")) {
    std::array<char*, 4> words{argv[0], argv[2], const_cast<char*>("--help"), nullptr};
    return static_cast<int>(sightline::app::run_report_program(words.data()));
  }
  return sightline::app::run_command_line(argc, argv, sightline::app::help_page("sightline"),
                                          [&](const sightline::app::Command& program) { sightline::app::add_commands(program, argc > 1 ? argv[1] : ""); },
                                          sightline::app::help_page("greeting").text);
}
