// See run_report.hpp.
#include "host/app/commands/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "emulators/pdp7/cpu.hpp"
#include "host/app/commands/run_timing.hpp"
#include "host/base/json.hpp"

namespace sightline::app {

namespace {

using base::Json;

// A program that has run into its data can meet thousands of codes.
constexpr std::size_t most_warnings = 100;

std::string word_text(core::Word18 word) {
  return fmt::format("{:06o}", word.value());
}

std::string seconds_text(core::Instant t) {
  constexpr std::int64_t second = 1'000'000'000;
  const std::int64_t ns = core::nanoseconds_of(t);
  return fmt::format("{}.{:09}", ns / second, ns % second);
}

std::string why_unanswered(std::uint32_t word) {
  constexpr std::uint32_t iot = 0700000;
  if ((word & iot) != iot) return "there is no EAE in this machine";
  return fmt::format("no device {:02o} in this machine obeys it", (word >> 6) & 077U);
}

// Where the instruction of the stop stands: PC has gone on.
pdp7::Address before(pdp7::Address pc) {
  return (pc & pdp7::bank_mask) | ((pc - 1) & pdp7::in_bank_mask);
}

Json registers_of(const harness::Pdp7Report& report) {
  const pdp7::State& r = report.registers;
  return {{"pc", fmt::format("{:05o}", r.pc)},
          {"ac", word_text(r.ac)},
          {"l", r.link ? 1 : 0},
          {"mq", word_text(r.mq)},
          {"sc", fmt::format("{:02o}", r.sc.value())},
          {"sr", word_text(report.switches)},
          {"ion", r.interrupts_on ? 1 : 0}};
}

}  // namespace

std::string json_report(const RunArguments& arguments, const harness::Pdp7Job& job,
                        const harness::Pdp7Report& report) {
  const machines::Configuration& machine = job.machine.configuration;
  Json document{{"schema", "sightline/run-pdp7/1"},
                {"stop_reason", harness::name_of(report.stop)},
                {"pc", fmt::format("{:05o}", report.registers.pc)},
                {"instructions", report.counts.instructions},
                {"machine_cycles", report.counts.machine_cycles},
                {"emulated_ns", core::nanoseconds_of(report.end)},
                {"emulated_seconds", static_cast<double>(core::nanoseconds_of(report.end)) / 1e9},
                {"stolen_cycles", report.counts.stolen_cycles},
                {"display_words", report.display_words},
                {"passes", report.passes},
                {"passes_started", report.passes_started}};
  document["registers"] = registers_of(report);
  document["machine"] = {{"core_words", machine.core_words},
                         {"eae", machine.model.eae},
                         {"extend_mode", machine.core_words > 8192},
                         {"display", job.machine.display.has_value()}};
  document["timing"] = Json::object();
  for (const TimingSetting& setting : timing_settings(arguments.timings)) {
    document["timing"][setting.name] = setting.value;
  }
  document["reader_out_of_tape"] = report.reader_out_of_tape;
  document["unanswered"] = Json::array();
  for (const machines::Unanswered& entry : report.unanswered) {
    document["unanswered"].push_back({{"word", fmt::format("{:06o}", entry.word)},
                                      {"count", entry.count},
                                      {"first_pc", fmt::format("{:05o}", entry.first_pc)}});
  }
  return document.dump(2) + "\n";
}

std::string table_report(const harness::Pdp7Job& job, const harness::Pdp7Report& report) {
  const pdp7::State& r = report.registers;
  std::string reason(harness::name_of(report.stop));
  std::replace(reason.begin(), reason.end(), '_', ' ');
  std::string text = fmt::format("stopped by      {}, PC {:05o}\n", reason, r.pc);
  text += fmt::format("emulated time   {} s\n", seconds_text(report.end));
  text += fmt::format("instructions    {}\n", report.counts.instructions);
  text += fmt::format("machine cycles  {}, {} of them stolen\n", report.counts.machine_cycles,
                      report.counts.stolen_cycles);
  if (job.machine.display) {
    text += fmt::format("display         {} words, {} passes complete of {} started\n", report.display_words,
                        report.passes, report.passes_started);
  }
  text += fmt::format("registers       AC {}  L {:o}  MQ {}  SC {:02o}  SR {}  ION {:o}\n", word_text(r.ac),
                      r.link ? 1 : 0, word_text(r.mq), r.sc.value(), word_text(report.switches),
                      r.interrupts_on ? 1 : 0);
  return text;
}

void warn_about(const harness::Pdp7Report& report) {
  std::size_t shown = 0;
  for (const machines::Unanswered& entry : report.unanswered) {
    if (shown++ == most_warnings) {
      warn(fmt::format("and {} more such codes", report.unanswered.size() - most_warnings));
      break;
    }
    warn(fmt::format("PC {:05o}: {:06o} does nothing, {} ({})", entry.first_pc, entry.word,
                     why_unanswered(entry.word),
                     entry.count == 1 ? "once" : fmt::format("{} times", entry.count)));
  }
  if (report.reader_out_of_tape) warn("the program waits for the paper-tape reader, which has no more tape");
}

ExitCode judge(const harness::Pdp7Report& report) {
  const pdp7::Address at = before(report.registers.pc);
  switch (report.stop) {
    case harness::Stop::interrupted:
      complain("stopped by Ctrl-C; all outputs hold what was done so far");
      return ExitCode::interrupted;
    case harness::Stop::xct_chain:
      complain(fmt::format("PC {:05o}: stopped: a chain of more than {} XCT instructions", at,
                           pdp7::longest_xct_chain));
      return ExitCode::guest_failed;
    case harness::Stop::unanswered:
      complain(fmt::format("PC {:05o}: stopped by --strict: nothing obeys the instruction", at));
      return ExitCode::guest_failed;
    default: return ExitCode::ok;
  }
}

}  // namespace sightline::app
