#include "tools/asm/listing.hpp"

#include <algorithm>

namespace sightline::assembler {

std::string write_listing(std::span<const ListingLine> lines) {
  std::size_t address_width = 0;
  std::size_t code_width = 0;
  for (const ListingLine& line : lines) {
    address_width = std::max(address_width, line.address.size());
    code_width = std::max(code_width, line.code.size());
  }
  std::string text;
  for (const ListingLine& line : lines) {
    std::string row = line.address + std::string(address_width - line.address.size() + 1, ' ');
    row += line.code + std::string(code_width - line.code.size() + 2, ' ');
    row += line.source;
    row.erase(row.find_last_not_of(" \t") + 1);
    text += row + '\n';
  }
  return text;
}

}  // namespace sightline::assembler
