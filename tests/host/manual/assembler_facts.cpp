#include "assembler_facts.hpp"

#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "table.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/asm/pdp7.hpp"

namespace sightline::manual {
namespace {

// A source of one or more lines, and the reason for its error. The manual shows each line as code.
struct Refused {
  std::string_view source;
  std::string_view why;
};

std::string shown(std::string_view source) {
  std::string text;
  while (!source.empty()) {
    const std::size_t end = std::min(source.find('\n'), source.size());
    const std::string_view line = source.substr(0, end);
    const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
    if (!text.empty()) text += " <br> ";
    text += code(line.substr(first));
    source.remove_prefix(std::min(end + 1, source.size()));
  }
  return text;
}

// The first message for each source; an error if the assembler accepts one.
template <class Assemble>
base::Result<std::string> refused(const auto& cases, Assemble assemble) {
  Table table{"source", "message", "because"};
  for (const Refused& row : cases) {
    const std::vector<assembler::SourceFile> files{{"program", std::string(row.source) + "\n"}};
    const auto assembly = assemble(files);
    if (assembly.diagnostics.empty()) {
      return base::Error{.found = "no message on " + std::string(row.source),
                         .expected = "an error or a warning: take the row out of the manual's table"};
    }
    const assembler::Diagnostic& first = assembly.diagnostics.front();
    const std::string kind = first.severity == assembler::Severity::error ? "error" : "warning";
    table.row({shown(row.source), kind + ": found " + first.found + ", expected " + first.expected,
               std::string(row.why)});
  }
  return table.text();
}

constexpr std::array pdp7_cases{
    Refused{"lac nowhere",
            "an undefined name is most often a typing error; `--undefined-are-variables` gives DEC's rule"},
    Refused{"lac 8", "numbers are octal; DECIMAL reads 8 and 9"},
    Refused{"1000000", "a word has 18 bits"},
    Refused{"law -3", "the sum would be no LAW: write `lam -2` or `law 17775`"},
    Refused{"lrs 100", "a step count has six bits"},
    Refused{"sma szl", "bit 1000 inverts all skips of the word"},
    Refused{"lac i 20000", "an address has 13 bits"},
    Refused{"a, 0\na, 0", "a tag has one place"},
    Refused{"lac, 0", "names of instructions are taken"},
    Refused{"text /abc", "TEXT ends on its line"},
    Refused{"text /{/", "trimmed ASCII has no braces"},
    Refused{"ifzero a <hlt>\na=0", "a condition is decided in the first pass"},
    Refused{"ifzero 0 <hlt", "every `<` is closed in its file"},
    Refused{"start 100\nstart 200", "what follows START is not read"},
    Refused{"hlt )", "a bracket that nothing opened"},
    Refused{"*200", "an origin is `200/`"},
    Refused{"external sqrt", "there is no linker"},
    Refused{"libfrm", "there is no linker"},
    Refused{"jmp 1f", "a construct of the other dialect"},
    Refused{"loop: lac x", "a construct of the other dialect"},
};

constexpr std::array bell_cases{
    Refused{"begin, lac 5", "a construct of DEC's language"},
    Refused{"lac (5", "a construct of DEC's language"},
    Refused{"lac 5 / five", "a construct of DEC's language"},
    Refused{"LAC 5", "case matters"},
    Refused{"sys open", "the sources define the names of system calls"},
    Refused{"a: 1\na: 2", "only a warning, as `as` takes the second place from there on"},
    Refused{"lac -1", "`as` makes 177777 of it: lac minus 1"},
    Refused{"law -3", "757775 is no LAW; -3 alone is one: 777775"},
    Refused{"08", "a leading 0 means octal"},
    Refused{"262144", "a word has 18 bits"},
    Refused{"jmp 1f", "no label 1: after it"},
    Refused{"10: 5", "relative labels are 0: to 9:"},
    Refused{"a: lac a+a", "`..` would have to be added twice"},
    Refused{"1+", "`as` adds 0"},
    Refused{"1\n..=0", "what was before would be elsewhere"},
    Refused{". = 020000", "core ends at 017777"},
    Refused{"iof: 0", "only a warning: the name is a label in all of the program"},
};

constexpr std::array i8080_cases{
    Refused{"        JMP     NOWHERE", "an undefined name"},
    Refused{"        MVI     A,300", "a byte is -128 to 255"},
    Refused{"        MVI     A,FFH", "a hexadecimal number begins with a digit: 0FFH"},
    Refused{"        MOV     M,M", "that opcode is HLT"},
    Refused{"        LD      A,5", "a Z80 instruction"},
    Refused{"        RST     8", "0 to 7"},
    Refused{"        ORG     LATER\nLATER:  NOP", "ORG, DS and REPT want a value known at their line"},
    Refused{"A1:     NOP\nA1:     NOP", "a label has one place"},
    Refused{"MOV     EQU     5", "names of instructions, registers and operators can be labels, with a colon, and nothing else"},
    Refused{"        DB      'AB", "a string ends on its line"},
    Refused{"        EXTRN   X\n        CALL    X", "there is no linker"},
    Refused{"        .Z80", "Intel's mnemonics only"},
    Refused{"        ENDM", "nothing to end"},
    Refused{"        IF      1", "every IF has its ENDIF"},
    Refused{"        DB      $ABE", "a number, or a name of MACRO-80"},
    Refused{"        NOP     ; STOP! RET", "in a comment of MAC a statement begins there"},
    Refused{"        DW      65536", "a word has 16 bits"},
    Refused{"        ELSE", "no IF before it"},
    Refused{"N       EQU     1\nN       EQU     2", "EQU is for ever; SET can change"},
    Refused{"        DW      1/0", "a division by zero"},
    Refused{"        ORG     0FFFFH\n        DW      1", "memory ends at FFFF"},
    Refused{"        ORG     5\n        NOP\n        ORG     5\n        NOP", "the second byte replaces the first"},
    Refused{"$INCLUDE(X.ASM)", "the directive is INCLUDE"},
};

// The words in double quotes between `begin` and the next "};" of a source, or an error.
base::Result<std::vector<std::string>> quoted_words(const std::string& source, std::string_view begin) {
  const std::size_t start = source.find(begin);
  const std::size_t end = start == std::string::npos ? start : source.find("};", start);
  if (end == std::string::npos)
    return base::Error{.found = "no \"" + std::string(begin) + "\" in the assembler's source",
                       .expected = "its table, as tests/host/manual/assembler_facts.cpp reads it"};
  std::vector<std::string> words;
  for (std::size_t at = source.find('"', start); at < end; at = source.find('"', at + 1)) {
    const std::size_t close = source.find('"', at + 1);
    words.push_back(source.substr(at + 1, close - at - 1));
    at = close;
  }
  return words;
}

using Meanings = std::map<std::string, std::string>;

base::Error missing_description(const std::string& word) {
  return {.found = "\"" + word + "\" of the assembler without a description",
          .expected = "one in tests/host/manual/assembler_facts.cpp"};
}

}  // namespace

base::Result<std::string> pdp7_refused() {
  return refused(pdp7_cases, [](const auto& files) { return assembler::assemble_pdp7(files); });
}

base::Result<std::string> bell_refused() {
  assembler::Options options;
  options.dialect = assembler::Dialect::bell;
  return refused(bell_cases, [&options](const auto& files) { return assembler::assemble_pdp7(files, options); });
}

base::Result<std::string> i8080_refused() {
  return refused(i8080_cases, [](const auto& files) { return assembler::assemble_i8080(files); });
}

std::string i8080_dialects() {
  Table table{"", "`common`", "`mac`", "`m80`", "`intel`", "source"};
  for (const assembler::I8080DialectRow& row : assembler::i8080_dialect_rows()) {
    using enum assembler::I8080Dialect;
    const auto says = [&row](assembler::I8080Dialect dialect) { return row.says(assembler::rules_of(dialect)); };
    table.row({std::string(row.what), says(common), says(mac), says(m80), says(intel), std::string(row.source)});
  }
  return table.text();
}

base::Result<std::string> pdp7_pseudo_operations(const std::string& source) {
  static const Meanings meanings{
      {"text", "`TEXT /ABC/`: three characters of trimmed ASCII to a word, filled up with 00"},
      {"title", "the rest of the line is a title"},
      {"ifzero", "`IFZERO a <...>`: assemble the part in brackets if a is +0 or -0"},
      {"ifnzro", "`IFNZRO a <...>`: if a is not zero"},
      {"start", "`START a`: the end of the source, and the start address a"},
      {"pause", "the end of a tape; what follows in the source is read as the next one"},
      {"decimal", "numbers are decimal from here to the end of the file"},
      {"octal", "numbers are octal again"},
      {"constants", "the literals used so far are placed here"},
      {"variables", "the variables used so far are placed here, in alphabetical order"},
      {"punch", "nothing: all words are written"},
      {"external", "`EXTERNAL a b`: names that another source of the program defines"},
      {"internal", "`INTERNAL a b`: names for other sources, defined in this one"},
      {"libfrm", "refused: the library must be among the sources"},
  };
  const auto words = quoted_words(source, "names{");
  if (!words) return words.error();
  Table table{"word", "what it does"};
  for (const std::string& word : words.value()) {
    const auto meaning = meanings.find(word);
    if (meaning == meanings.end()) return missing_description(word);
    std::string upper = word;
    for (char& c : upper) c = static_cast<char>(c - 'a' + 'A');
    table.row({code(upper), meaning->second});
  }
  return table.text();
}

base::Result<std::string> i8080_directives(const std::string& source) {
  // Keyed by the enumerator, in the order of the manual.
  static const std::vector<std::pair<std::string, std::string>> meanings{
      {"org", "the address of what follows"},
      {"equ", "`NAME EQU value`, for ever"},
      {"set", "`NAME SET value`, until the next SET"},
      {"db", "bytes and strings, separated by commas"},
      {"dw", "words, low byte first"},
      {"ds", "`DS n`: room for n bytes; `DS n,x` fills it with x"},
      {"dc", "as DB, with bit 7 set in the last character of a string"},
      {"end", "the end of the file; `END addr` is the start address"},
      {"if_", "assemble the lines to ELSE or ENDIF if the value is not 0"},
      {"if_zero", "if the value is 0"},
      {"if_defined", "if the name is defined"},
      {"if_not_defined", "if it is not"},
      {"if_blank", "if the argument `<...>` is empty"},
      {"if_not_blank", "if it is not"},
      {"if_same", "`IFIDN <a>,<b>`: if the texts are the same"},
      {"if_different", "if they differ"},
      {"if_first_pass", "only while the program is laid out, not when its bytes are made"},
      {"if_second_pass", "only when the bytes are made"},
      {"else_", "the other case"},
      {"endif", "the end of an IF"},
      {"macro", "`NAME MACRO p,q`: a macro to ENDM"},
      {"endm", "the end of a MACRO, REPT, IRP or IRPC"},
      {"local", "`LOCAL x`: a unique name in each expansion"},
      {"rept", "`REPT n`: the lines to ENDM n times"},
      {"irp", "`IRP p,<a,b>`: once for each argument"},
      {"irpc", "`IRPC p,text`: once for each character"},
      {"exitm", "leave the macro"},
      {"include", "read a file, from the folder of the file that includes it"},
      {"maclib", "the same; also with .LIB behind the name"},
      {"external", "declares names that other sources of the command define"},
      {"cpu", "`CPU 8080`; another processor is an error"},
      {"z80", "refused"},
      {"title", "a title; not used"},
      {"radix", "`.RADIX n`: numbers without a suffix are to the base n, 2 to 16; n itself is decimal"},
      {"phase", "`.PHASE addr`: labels and `$` have their values at addr, bytes stay where they are"},
      {"dephase", "the end of that"},
      {"comment", "`.COMMENT *text*`, over any number of lines; any sign will do"},
      {"common", "`COMMON /NAME/`: what follows lies where the first block of the name does, to the next segment"},
      {"segment", "the segment, which goes on where it was left; ORG is of this segment alone"},
      {"ignored", "nothing: controls of listings, NAME"},
      {"public_", "declares names for other sources of the command; `name::` does, too"},
  };
  const std::string_view begin = "constexpr std::array directives{";
  const auto words = quoted_words(source, begin);
  if (!words) return words.error();
  std::map<std::string, std::string> names;
  std::size_t at = source.find(begin);
  for (const std::string& word : words.value()) {
    at = source.find("\"" + word + "\"", at);
    const std::size_t enumerator = source.find("D::", at) + 3;
    std::string upper = word;
    for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    std::string& list = names[source.substr(enumerator, source.find('}', enumerator) - enumerator)];
    list += (list.empty() ? "" : " ") + code(upper);
  }
  Table table{"directive", "what it does"};
  for (const auto& [enumerator, meaning] : meanings) {
    const auto found = names.find(enumerator);
    if (found == names.end()) return missing_description(enumerator);
    table.row({found->second, meaning});
    names.erase(found);
  }
  if (!names.empty()) return missing_description(names.begin()->first);
  return table.text();
}

}  // namespace sightline::manual
