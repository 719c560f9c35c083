// Any bytes as an expression: it is sampled, or rejected with a message.
#include <cstddef>
#include <cstdint>
#include <string>

#include "host/scene/heights/expression.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto result = scene::sample_expression(text, {{-2, 2}, {-1, 3}}, {4, 3});
  if (!result) static_cast<void>(result.error().message());
  return 0;
}
