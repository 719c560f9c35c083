#include "tools/asm/symbol_table.hpp"

namespace sightline::assembler {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string SymbolTable::key(std::string_view name) const {
  const std::string_view part = name.substr(0, significant_);
  return any_case_ ? lower_case(part) : std::string(part);
}

Symbol& SymbolTable::operator[](std::string_view name) {
  Symbol& symbol = symbols_[key(name)];
  if (symbol.name.empty()) symbol.name = std::string(name);
  return symbol;
}

// The separator is a line break, which no name contains.
std::string SymbolTable::own_key(std::string_view name, std::size_t source) const {
  return key(name) + "\n" + std::to_string(source);
}

Symbol& SymbolTable::own(std::string_view name, std::size_t source) {
  Symbol& symbol = symbols_[own_key(name, source)];
  if (symbol.name.empty()) symbol.name = std::string(name);
  return symbol;
}

const Symbol* SymbolTable::find(std::string_view name) const {
  const auto found = symbols_.find(key(name));
  return found == symbols_.end() ? nullptr : &found->second;
}

}  // namespace sightline::assembler
