// sightline-verify: checks one certificate and prints the verdict.
// Exit codes: 0 proved, 1 refuted, 2 wrong usage, 4 malformed certificate, 5 the file cannot be read.
#include <fstream>
#include <iostream>
#include <iterator>

#include "tools/verify/verify.hpp"

int main(int argc, char** argv) {
  const std::string_view name = argc == 2 ? argv[1] : "";
  if (name.empty() || (name.size() > 1 && name[0] == '-')) {
    std::cerr << "usage: sightline-verify CERTIFICATE (- is standard input)\n";
    return name == "--help" ? 0 : 2;
  }
  std::ifstream file;
  if (name != "-") file.open(argv[1], std::ios::binary);
  std::istream& in = name == "-" ? std::cin : file;
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad() || (name != "-" && !file.is_open())) {
    std::cerr << "sightline-verify: " << name << ": cannot be read\n";
    return 5;
  }
  using sightline::verifier::Verdict;
  const Verdict verdict = sightline::verifier::verify(text);
  const bool proved = verdict.kind == Verdict::Kind::proved;
  (proved ? std::cout : std::cerr) << name << ": " << sentence(verdict) << '\n';
  return proved ? 0 : verdict.kind == Verdict::Kind::refuted ? 1 : 4;
}
