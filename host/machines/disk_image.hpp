// The image of an RB09 disk in a file: each word of 18 bits in four bytes, the lowest first, in address order;
// 1,024,000 words, 4,096,000 bytes. Other simulators of the PDP-7 read and write the same.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "emulators/core/word.hpp"
#include "emulators/pdp7/rb09.hpp"
#include "host/machines/machine.hpp"

namespace sightline::machines {

// Error bad_input: a file of another length, or a word of more than 18 bits.
[[nodiscard]] Result<std::vector<core::Word18>> read_disk_image(const Input& input);
// The current content of the disk; empty if none is attached.
[[nodiscard]] Bytes disk_image(const pdp7::Rb09& disk);

}  // namespace sightline::machines
