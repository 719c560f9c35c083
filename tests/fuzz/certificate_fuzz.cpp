// Any bytes as a certificate: the verifier gives a verdict.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "tools/verify/verify.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto verdict = sightline::verifier::verify({reinterpret_cast<const char*>(data), size});
  if (sentence(verdict).empty()) std::abort();
  return 0;
}
