// Any bytes as a dump of each machine: rejected as bad input with the file name, or registers and words within their widths, at
// ascending addresses. Input that begins like a dump is read at least up to its first line of words.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "host/machines/engine.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const machines::Input input{"fuzz", {data, data + size}};
  for (const machines::MachineDescription* const machine : machines::machines()) {
    const bool begins = machines::is_dump(*machine, input.bytes);
    const auto program = machines::read_dump(*machine, input);
    if (!program) {
      const base::Error& refusal = program.error();
      if (refusal.kind != base::ErrorKind::bad_input || !refusal.message().starts_with("fuzz: line ")) std::abort();
      continue;
    }
    if (begins && program->words.size() < machine->words_per_line) std::abort();
    for (const auto& [number, value] : program->registers)
      if (number >= machine->registers.size() || value >> machine->registers[number].bits != 0) std::abort();
    for (std::size_t n = 0; n < program->words.size(); ++n) {
      const auto& [address, word] = program->words[n];
      if (address != n || address >> machine->address_bits != 0 || word >> machine->word_bits != 0) std::abort();
    }
  }
  return 0;
}
