// See cpm_memory.hpp.
#include "host/machines/cpm_memory.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

namespace sightline::machines::cpm {

namespace {

constexpr Byte jump_code = 0xC3, return_code = 0xC9, out_code = 0xD3;
static_assert(out_code == fill_port);

using Entries = std::vector<std::pair<Address, Byte>>;

void put(Entries& entries, unsigned at, std::initializer_list<Byte> bytes) {
  for (const Byte byte : bytes) entries.emplace_back(static_cast<Address>(at++), byte);
}

void put_jump(Entries& entries, unsigned at, unsigned to) {
  put(entries, at, {jump_code, i8080::low(static_cast<Address>(to)), i8080::high(static_cast<Address>(to))});
}

}  // namespace

std::vector<std::pair<Address, Byte>> entries(bool whole) {
  Entries entries;
  if (!whole) {
    put(entries, boot, {out_code, exit_port});
    put(entries, bdos, {out_code, bdos_port, return_code});
    put(entries, returned, {out_code, exit_port});
    return entries;
  }
  put_jump(entries, boot, bios_table + 3);  // WBOOT
  put_jump(entries, bdos, bdos_entry);
  put(entries, bdos_entry, {out_code, bdos_port, return_code});
  for (unsigned n = 0; n < bios_functions; ++n) {
    put_jump(entries, bios_table + 3 * n, bios_entries + 3 * n);
    put(entries, bios_entries + 3 * n, {out_code, bios_port, return_code});
  }
  return entries;
}

void fill_system(std::span<Byte> memory) {
  const auto at = [&memory](std::size_t address) { return memory.begin() + static_cast<std::ptrdiff_t>(address); };
  std::fill(at(first_stack), at(bdos_entry), Byte{0});
  std::fill(at(bdos_entry), memory.end(), out_code);
  for (const auto& [address, byte] : entries(true))
    if (address >= bdos_base) memory[address] = byte;
}

void put_disk_tables(std::span<Byte> memory) {
  // Sectors of a track; shift, mask and extents of a block; the last block, the last directory entry, the directory's blocks,
  // checked directory records, reserved tracks.
  constexpr std::array<Byte, 15> parameters{26, 0, 3, 7, 0, 242, 0, 63, 0, 0xC0, 0, 16, 0, 2, 0};
  constexpr std::size_t allocation_bytes = 243 / 8 + 1;
  const auto at = [&memory](std::size_t address) { return memory.begin() + static_cast<std::ptrdiff_t>(address); };
  std::copy(parameters.begin(), parameters.end(), at(disk_parameters));
  std::fill_n(at(allocation), allocation_bytes, Byte{0});
  memory[allocation] = 0xC0;
}

void put_arguments(std::string_view tail, std::span<Byte> memory) {
  std::string text;
  for (const char c : tail.substr(0, longest_tail)) text += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  memory[transfer] = static_cast<Byte>(text.size());
  std::copy(text.begin(), text.end(), memory.begin() + transfer + 1);
  memory[transfer + 1 + text.size()] = 0;

  constexpr std::size_t current_record = 0x5C + 32;
  memory[current_record] = 0;
  std::size_t at = 0;
  for (const std::size_t block : {0x5CU, 0x6CU}) {
    const auto next = [&]() -> Byte {
      constexpr std::string_view ends = " =_.:;<>";
      return at < text.size() && ends.find(text[at]) == std::string_view::npos ? static_cast<Byte>(text[at++]) : 0;
    };
    while (at < text.size() && text[at] == ' ') ++at;
    std::fill_n(memory.begin() + static_cast<std::ptrdiff_t>(block), 16, Byte{0});
    std::fill_n(memory.begin() + static_cast<std::ptrdiff_t>(block) + 1, 11, Byte{' '});
    if (at + 1 < text.size() && text[at + 1] == ':' && text[at] >= 'A' && text[at] <= 'P') {
      memory[block] = static_cast<Byte>(text[at] - 'A' + 1);
      at += 2;
    }
    const auto field = [&](std::size_t first, std::size_t last) {
      std::size_t n = first;
      while (const Byte c = next()) {
        if (c == '*') {
          while (n < last) memory[block + n++] = '?';
        } else if (n < last) {
          memory[block + n++] = c;
        }
      }
    };
    field(1, 9);
    if (at < text.size() && text[at] == '.') {
      ++at;
      field(9, 12);
    }
    while (at < text.size() && text[at] != ' ') ++at;
  }
}

}  // namespace sightline::machines::cpm
