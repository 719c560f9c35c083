// CP/M 2.2 in memory: page zero, the entries of BDOS and BIOS, the tables of a disk, and the arguments of a program.
//
// An entry is an OUT to a port, at which the host does the work. Without a console and drives there are only the entries at
// 0000 and 0005 (i8080.hpp). With one of them memory is that of a 64K system: BDOS at EC00, the BIOS at FA00. The rest of
// both is filled with an OUT that is no entry, so that a jump to any other address there is noticed.
// Sources: Digital Research, "CP/M 2.2 Interface Guide" and "CP/M 2.2 Alteration Guide" (1979).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/state.hpp"

namespace sightline::machines::cpm {

using i8080::Address;
using i8080::Byte;

// Ports of the entries.
inline constexpr Byte exit_port = 0, bdos_port = 1, bios_port = 2;
// The port of the fill, and its opcode: the bytes D3 D3 are OUT D3 at even and at odd addresses.
inline constexpr Byte fill_port = 0xD3;
inline constexpr Byte fill_port_at_end = 0xC3;  // of the OUT at FFFF: the byte at 0000, a JMP

inline constexpr Address boot = 0x0000, io_byte = 0x0003, user_and_disk = 0x0004, bdos = 0x0005, transfer = 0x0080, program = 0x0100;
// Without a console and drives: a RET with SP=0000 goes to the address formed by the bytes at 0000.
inline constexpr Address returned = 0x00D3;
// With them: CP/M's serial number is the six bytes before the entry of BDOS; below it is the stack of a program that sets
// none.
inline constexpr Address bdos_base = 0xEC00, bdos_entry = bdos_base + 6, first_stack = bdos_base - 2;
inline constexpr Address bios_table = 0xFA00;
// The low and high bytes of these addresses are instructions that only change A and the flags, so that a jump into the middle
// of the table's JMPs runs through it to the fill behind it.
inline constexpr Address bios_entries = 0xFE80;
inline constexpr unsigned bios_functions = 17;

// Where function 31 finds the parameters of a disk, and function 27 the allocation of its blocks.
inline constexpr Address disk_parameters = 0xFF20, allocation = 0xFF00;

// The bytes that must be in memory. whole: with a console or drives.
[[nodiscard]] std::vector<std::pair<Address, Byte>> entries(bool whole);
// Stores the whole system but page zero, as a warm boot does.
void fill_system(std::span<Byte> memory);

// Stores the tables of an empty disk: 243 blocks of 1K, of which the directory occupies two, as on CP/M's standard disk.
void put_disk_tables(std::span<Byte> memory);

// The longest text after a program's name that fits at 0080, with the blank before it.
inline constexpr std::size_t longest_tail = 126;
// Stores the arguments of a program: the tail at 0080, and file control blocks at 005C and 006C. `tail` begins with the blank.
void put_arguments(std::string_view tail, std::span<Byte> memory);

}  // namespace sightline::machines::cpm
