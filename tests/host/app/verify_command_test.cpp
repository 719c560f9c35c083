// `sightline draw exact --certificate` and `sightline verify`: verdicts, exit codes, standard streams and usage errors.
#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class VerifyCommand : public sightline::test::CommandLine {
 protected:
  // What `verify` says of a certificate.
  Ran verdict_of(const std::string& certificate) { return sightline({"verify", "-"}, certificate); }
};

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

TEST_F(VerifyCommand, ProvesADrawingAndPrintsItsFigures) {
  const Ran drawn = sightline({"draw", "exact", "boxes-5", "--json", "--certificate", "boxes.proof", "-o", "boxes.svg"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  const Ran ran = sightline({"verify", "boxes.proof"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "boxes.proof: proved: 60 edges, ")) << ran.out;
  const json verdict = json::parse(sightline({"verify", "boxes.proof", "--json"}).out);
  EXPECT_EQ(verdict["proved"], true);
  EXPECT_EQ(verdict["edges"], 60);
  EXPECT_EQ(verdict["visible"], json::parse(drawn.out)["pieces"]);
  // The drawing is the same without a proof.
  ASSERT_EQ(sightline({"draw", "exact", "boxes-5", "-o", "plain.svg"}).exit_code, 0);
  EXPECT_EQ(read("boxes.svg"), read("plain.svg"));
}

TEST_F(VerifyCommand, TheExitCodeTellsAFalseCertificateFromAMalformedOne) {
  const Ran drawn = sightline({"draw", "exact", "boxes-5", "--certificate", "-", "-o", "boxes.svg"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  const std::string certificate = drawn.out;
  EXPECT_EQ(verdict_of(certificate).exit_code, 0);
  const Ran refuted = verdict_of(with(certificate, "\nturned\n", "\n"));
  EXPECT_EQ(refuted.exit_code, 1);
  EXPECT_TRUE(has(refuted.err, "standard input: not proved: line ")) << refuted.err;
  const Ran malformed = verdict_of(with(certificate, "\nend\n", "\nfinish\n"));
  EXPECT_EQ(malformed.exit_code, 4);
  EXPECT_TRUE(has(malformed.err, "expected an edge, a wire, an intersection or the end")) << malformed.err;
  const Ran as_json = sightline({"verify", "-", "--json"}, with(certificate, "\nturned\n", "\n"));
  EXPECT_EQ(as_json.exit_code, 1);
  EXPECT_EQ(json::parse(as_json.out)["proved"], false);
  EXPECT_EQ(sightline({"verify", "missing.proof"}).exit_code, 5);
}

TEST_F(VerifyCommand, OneViewOfOneMethod) {
  const auto expect_usage = [&](std::vector<std::string> words, const std::string& what) {
    words.insert(words.end(), {"--certificate", "x.proof", "-o", "x.svg"});
    const Ran ran = sightline(words);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
  };
  expect_usage({"draw", "exact", "house", "--turntable", "3"}, "--turntable excludes --certificate");
  expect_usage({"draw", "exact", "house", "--views", "front,top"}, "--views excludes --certificate");
  expect_usage({"draw", "oracle", "house"}, "--certificate");
  const Ran twice = sightline({"draw", "exact", "house", "--certificate", "-", "-o", "-"});
  EXPECT_EQ(twice.exit_code, 2);
}

}  // namespace
