// The listing: address, code and source side by side, and the table of symbols.
//
// Addresses and code are already text, in the radix of the machine: the columns are as wide as the widest entry.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace sightline::assembler {

struct ListingLine {
  std::string address;  // empty if the line assembles to no word
  std::string code;
  std::string source;  // the source line, or the literal or variable for which the assembler adds a word
  std::string file = {};     // the source file; empty if the word comes from no source line
  std::size_t line_number = 0;  // the line in that file, from 1

  friend bool operator==(const ListingLine&, const ListingLine&) = default;
};

[[nodiscard]] std::string write_listing(std::span<const ListingLine> lines);

}  // namespace sightline::assembler
