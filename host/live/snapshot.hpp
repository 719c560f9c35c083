// A snapshot: the whole state of a machine at an instruction boundary, from which a run continues bit for bit.
//
//   8 bytes   89 53 4C 53 4E 41 50 0A, the signature
//   4         version of the format
//   4         length of the file
//   text      name of the machine
//   4         number of lines of the configuration, then each a text
//   4         number of sections, then each: a text, its name; 4 bytes, its length; its bytes
//   4         CRC-32 of all bytes before
//
// Integers are little-endian; a text is its length in 2 bytes, then ASCII. host/machines/state.hpp describes the sections;
// host/manual/formats.md lists all fields. A snapshot does not contain outputs (printed, punched or drawn), only their
// lengths; inputs of the configuration (a tape in the reader, the data of a link) are identified by length and checksum.
//
// A change of any field is a new version; other versions are rejected.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/machines/machine.hpp"

namespace sightline::live {

using base::Bytes;

inline constexpr std::uint32_t snapshot_version = 6;

struct Snapshot {
  std::string machine;                     // "pdp7"
  std::vector<std::string> configuration;  // "--memory 8k"
  machines::MachineState state;
};

[[nodiscard]] Bytes encode_snapshot(const Snapshot& snapshot);
// `file`: its name, for errors.
[[nodiscard]] base::Result<Snapshot> decode_snapshot(std::span<const std::uint8_t> bytes,
                                                     const std::string& file);

// Called between two calls of Machine::run; `name`: the name of the machine.
[[nodiscard]] Bytes save_snapshot(std::string_view name, machines::Machine& machine);
// Restores a machine of the same name and configuration. After an error the machine is unchanged.
[[nodiscard]] base::Result<base::Done> restore_snapshot(std::string_view name, machines::Machine& machine,
                                                        std::span<const std::uint8_t> bytes,
                                                        const std::string& file);

}  // namespace sightline::live
