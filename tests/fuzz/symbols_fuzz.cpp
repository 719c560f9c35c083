// Any bytes as a table of symbols, NAME VALUE or a .SYM file, of either machine: an error names a line; a table that is read gives
// every name its value, and reading it again changes nothing.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "host/live/symbols.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using sightline::live::Symbols;
  const std::string text(data, data + size);
  for (const int radix : {8, 16}) {
    Symbols symbols(radix);
    const auto done = symbols.add_table(text);
    if (!done) {
      if (!done.error().place.starts_with("line ")) std::abort();
      continue;
    }
    const auto all = symbols.all();
    for (const auto& [name, value] : all) {
      if (name.empty()) std::abort();
      const auto found = symbols.value(name);
      if (found && radix == 16 && *found != value) std::abort();
      static_cast<void>(symbols.near(value));
    }
    if (!symbols.add_table(text) || symbols.all() != all) std::abort();
  }
  return 0;
}
