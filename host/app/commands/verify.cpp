// `sightline verify`: checks a certificate that `sightline draw exact --certificate` wrote.
#include "tools/verify/verify.hpp"

#include <fmt/core.h>

#include <memory>
#include <string>

#include "host/app/commands/commands.hpp"
#include "host/base/json.hpp"

namespace sightline::app {
namespace {

struct VerifyArguments {
  std::string certificate;
  bool json = false;
};

ExitCode run_verify(const VerifyArguments& arguments) {
  using verifier::Verdict;
  const Verdict verdict = verifier::verify(read_input_text(arguments.certificate));
  const bool proved = verdict.kind == Verdict::Kind::proved;
  const std::string name = display_name(arguments.certificate);
  if (arguments.json) {
    base::Json document{{"schema", "sightline/verify/1"}, {"certificate", name}, {"proved", proved}};
    if (proved) {
      document["edges"] = verdict.edges;
      document["visible"] = verdict.visible;
      document["hidden"] = verdict.hidden;
    } else {
      document["line"] = verdict.line;
      document["reason"] = verdict.reason;
    }
    print_json(document);
  } else if (proved) {
    write_stdout(fmt::format("{}: {}\n", name, sentence(verdict)));
  }
  if (verdict.kind == Verdict::Kind::malformed) throw base::bad_input(fmt::format("{}: {}", name, sentence(verdict)));
  if (!proved) throw base::difference(fmt::format("{}: not proved: {}", name, sentence(verdict)));
  return ExitCode::ok;
}

}  // namespace

void add_verify_command(const Command& program) {
  const auto arguments = std::make_shared<VerifyArguments>();
  const Command command = program.add_command("verify", help_page("verify"));
  command.option("CERTIFICATE", arguments->certificate, "The file that `sightline draw exact --certificate` wrote; - is standard input").required();
  command.flag("--json", arguments->json, "Print the verdict as one JSON document on standard output");
  command.run([arguments] { return run_verify(*arguments); });
}

}  // namespace sightline::app
