// The listing: address, code and source side by side, and the table of symbols.
//
// Addresses and code are already text, in the radix of the machine: the columns are as wide as the widest entry.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace sightline::assembler {

struct ListingLine {
  std::string address;  // empty if the line makes no word
  std::string code;
  std::string source;  // the source line, or what an extra word of it stands for
  std::string file = {};     // of a line that makes words: where it was written; empty for what no line of a source made
  std::size_t line_number = 0;  // there, from 1

  friend bool operator==(const ListingLine&, const ListingLine&) = default;
};

[[nodiscard]] std::string write_listing(std::span<const ListingLine> lines);

}  // namespace sightline::assembler
