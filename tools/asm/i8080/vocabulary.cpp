#include "tools/asm/i8080/vocabulary.hpp"

#include <array>
#include <unordered_map>
#include <utility>

namespace sightline::assembler {
namespace {

using D = Directive;
using O = Operator;

// Intel's names, then CP/M MAC's and MACRO-80's names for the same.
constexpr std::array directives{
    std::pair{"org", D::org},
    std::pair{"equ", D::equ},
    std::pair{"set", D::set},
    std::pair{"aset", D::set},
    std::pair{"defl", D::set},
    std::pair{"db", D::db},
    std::pair{"defb", D::db},
    std::pair{"defm", D::db},
    std::pair{"byte", D::db},
    std::pair{"dw", D::dw},
    std::pair{"defw", D::dw},
    std::pair{"word", D::dw},
    std::pair{"ds", D::ds},
    std::pair{"defs", D::ds},
    std::pair{"dc", D::dc},
    std::pair{"end", D::end},
    std::pair{"if", D::if_},
    std::pair{"ift", D::if_},
    std::pair{"cond", D::if_},
    std::pair{"ife", D::if_zero},
    std::pair{"iff", D::if_zero},
    std::pair{"ifdef", D::if_defined},
    std::pair{"ifndef", D::if_not_defined},
    std::pair{"ifb", D::if_blank},
    std::pair{"ifnb", D::if_not_blank},
    std::pair{"ifidn", D::if_same},
    std::pair{"ifdif", D::if_different},
    std::pair{"if1", D::if_first_pass},
    std::pair{"if2", D::if_second_pass},
    std::pair{"else", D::else_},
    std::pair{"endif", D::endif},
    std::pair{"endc", D::endif},
    std::pair{"macro", D::macro},
    std::pair{"endm", D::endm},
    std::pair{"local", D::local},
    std::pair{"rept", D::rept},
    std::pair{"irp", D::irp},
    std::pair{"irpc", D::irpc},
    std::pair{"exitm", D::exitm},
    std::pair{"include", D::include},
    std::pair{"maclib", D::maclib},
    std::pair{"extrn", D::external},
    std::pair{"extern", D::external},
    std::pair{"external", D::external},
    std::pair{"ext", D::external},
    std::pair{"cpu", D::cpu},
    std::pair{".radix", D::radix},
    std::pair{".phase", D::phase},
    std::pair{".dephase", D::dephase},
    std::pair{".comment", D::comment},
    std::pair{"common", D::common},
    std::pair{".8080", D::ignored},
    std::pair{".z80", D::z80},
    std::pair{".z180", D::z80},
    std::pair{"title", D::title},
    std::pair{"subttl", D::title},
    std::pair{"page", D::ignored},
    std::pair{"eject", D::ignored},
    std::pair{"name", D::ignored},
    std::pair{"aseg", D::segment},
    std::pair{"cseg", D::segment},
    std::pair{"dseg", D::segment},
    std::pair{"public", D::public_},
    std::pair{"entry", D::public_},
    std::pair{"global", D::public_},
    std::pair{"stkln", D::ignored},
    std::pair{".list", D::ignored},
    std::pair{".xlist", D::ignored},
    std::pair{".lall", D::ignored},
    std::pair{".sall", D::ignored},
    std::pair{".xall", D::ignored},
    std::pair{".cref", D::ignored},
    std::pair{".xcref", D::ignored},
    std::pair{".lfcond", D::ignored},
    std::pair{".sfcond", D::ignored},
    std::pair{".tfcond", D::ignored},
    std::pair{".printx", D::ignored},
};

constexpr std::array operators{
    std::pair{"mod", O::mod},  std::pair{"shl", O::shl},   std::pair{"shr", O::shr},
    std::pair{"eq", O::eq},    std::pair{"ne", O::ne},     std::pair{"lt", O::lt},
    std::pair{"le", O::le},    std::pair{"gt", O::gt},     std::pair{"ge", O::ge},
    std::pair{"not", O::not_}, std::pair{"and", O::and_},  std::pair{"or", O::or_},
    std::pair{"xor", O::xor_}, std::pair{"high", O::high}, std::pair{"low", O::low},
    std::pair{"nul", O::nul},
};

std::unordered_map<std::string, Word> make_vocabulary() {
  std::unordered_map<std::string, Word> words;
  for (const auto& [name, directive] : directives) words[name] = {WordKind::directive, {}, directive, {}, 0};
  for (const auto& [name, operation] : operators) words[name] = {WordKind::operation, {}, {}, operation, 0};
  const auto add_registers = [&words](const auto& names, unsigned step) {
    for (std::size_t i = 0; i < names.size(); ++i)
      words[std::string(names[i])] = {WordKind::register_name, {}, {}, {}, static_cast<std::uint8_t>(step * i)};
  };
  add_registers(i8080::pair_names, 2);
  add_registers(i8080::psw_pair_names, 2);
  add_registers(i8080::register_names, 1);
  for (const i8080::Instruction& row : i8080::instructions) {
    if (!row.duplicate) words[std::string(row.mnemonic)].rows.push_back(&row);
  }
  return words;
}

}  // namespace

const Word* find_word(const std::string& name) {
  static const std::unordered_map<std::string, Word> words = make_vocabulary();
  const auto found = words.find(name);
  return found == words.end() ? nullptr : &found->second;
}

}  // namespace sightline::assembler
