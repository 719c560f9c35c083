// Changes certificates at random for a long time and judges each change that the verifier accepts with the oracle.
//
//   certificate_changes [COUNT [SEED]]
//
// Prints how many changes were refuted, malformed, and accepted because they are true. Ends with 1 at the first false one that was
// accepted, and prints it.
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "tests/tools/verify/certificate_scenes.hpp"
#include "tests/tools/verify/certificate_truth.hpp"
#include "tools/verify/verify.hpp"

int main(int argc, char** argv) {
  using namespace sightline::tests;
  using Kind = sightline::verifier::Verdict::Kind;
  const long count = argc > 1 ? std::atol(argv[1]) : 100'000;
  Dice dice(argc > 2 ? static_cast<std::uint32_t>(std::atol(argv[2])) : 1);
  const std::vector<std::string> certificates = certificates_to_change();
  long unchanged = 0;
  long refuted = 0;
  long malformed = 0;
  long accepted = 0;
  for (long i = 0; i < count; ++i) {
    const std::string& certificate = certificates[static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(certificates.size()) - 1))];
    const std::string other = changed(certificate, dice);
    if (other == certificate) {
      ++unchanged;
      continue;
    }
    const auto verdict = sightline::verifier::verify(other);
    if (verdict.kind == Kind::refuted) ++refuted;
    else if (verdict.kind == Kind::malformed) ++malformed;
    else ++accepted;
    if (verdict.kind != Kind::proved) continue;
    if (const std::string falsehood = falsehood_in(other); !falsehood.empty()) {
      std::cout << other << "accepted, but false: " << falsehood << '\n';
      return 1;
    }
  }
  std::cout << refuted << " refuted, " << malformed << " malformed, " << accepted << " accepted and true, " << unchanged << " unchanged\n";
  return 0;
}
