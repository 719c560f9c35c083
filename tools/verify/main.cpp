// sightline-verify: checks one certificate and prints the verdict.
// Exit codes: 0 proved, 1 refuted, 2 wrong usage, 4 malformed certificate, 5 the file cannot be read.
#include <fstream>
#include <iostream>
#include <sstream>

#include "tools/verify/verify.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: sightline-verify CERTIFICATE\n";
    return 2;
  }
  std::ifstream file(argv[1], std::ios::binary);
  std::ostringstream text;
  if (!(text << file.rdbuf())) {
    std::cerr << argv[1] << ": cannot be read, or is empty\n";
    return 5;
  }
  const auto verdict = sightline::verifier::verify(text.str());
  std::cout << argv[1] << ": " << sentence(verdict) << '\n';
  using Kind = sightline::verifier::Verdict::Kind;
  return verdict.kind == Kind::proved ? 0 : verdict.kind == Kind::refuted ? 1 : 4;
}
