// Every kind of error in a source, with the position and text of its message.
#include <gtest/gtest.h>

#include "tests/tools/asm/assemble.hpp"

namespace sightline::assembler {
namespace {

struct Mistake {
  const char* name;
  const char* source;
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class Pdp7Errors : public testing::TestWithParam<Mistake> {};

TEST_P(Pdp7Errors, HaveTheirMessageAndPosition) {
  const Assembly assembly = assemble(GetParam().source);
  EXPECT_EQ(messages(assembly), Texts{GetParam().message});
  EXPECT_EQ(assembly.ok(), std::string(GetParam().message).find("error:") == std::string::npos);
  EXPECT_EQ(assembly.image.words.empty(), !assembly.ok());
}

constexpr const char* skips_message =
    "t.s:1:5: warning: found skips of opposite sense in one word, expected sma sza snl together or spa sna "
    "szl together (bit 1000 inverts all of them)";

INSTANTIATE_TEST_SUITE_P(
    All, Pdp7Errors,
    testing::Values(
        Mistake{
            "undefined", "\n lac nowhere",
            "t.s:2:6: error: found undefined symbol 'nowhere', expected a tag, an assignment, or #nowhere"},
        Mistake{"octal_digit", " lac 18",
                "t.s:1:6: error: found '8' in number '18', expected octal digits (DECIMAL reads 8 and 9)"},
        Mistake{"decimal_digit", "decimal\n12a",
                "t.s:2:1: error: found 'a' in number '12a', expected decimal digits"},
        Mistake{"octal_size", "1000000",
                "t.s:1:1: error: found number '1000000', expected at most 777777, which is 18 bits"},
        Mistake{"decimal_size", "decimal; 262144",
                "t.s:1:10: error: found number '262144', expected at most 262143, which is 18 bits"},
        Mistake{"address", " lac 20000",
                "t.s:1:2: error: found address 020000, expected one from 00000 to 17777"},
        Mistake{"negative_address", " lac -1",
                "t.s:1:2: error: found address 777776, expected one from 00000 to 17777"},
        Mistake{"address_in_literal", " lac (dac 20000",
                "t.s:1:7: error: found address 020000, expected one from 00000 to 17777"},
        Mistake{"law", " law -3", "t.s:1:2: error: found LAW 777774, expected a number from 0 to 17777"},
        Mistake{"steps", " lrs 100",
                "t.s:1:2: error: found operand 000100, expected a step count that keeps bits 12-17 from 00 "
                "to 77"},
        Mistake{"opr_operand", " cla 40000",
                "t.s:1:2: error: found operand 040000, expected one that leaves the word an opr"},
        Mistake{"second_i", " lac i i x\nx, 0", "t.s:1:8: error: found a second i, expected one in a word"},
        Mistake{"two_instructions", " lac dac",
                "t.s:1:6: warning: found two instructions of different classes in one word, which are added, "
                "expected one instruction, or microinstructions of one class"},
        Mistake{"skips", "spa sza", skips_message},
        Mistake{"rotates", "ral rar",
                "t.s:1:5: warning: found left and right rotate in one word, expected one of them"},
        Mistake{"tag_twice", "a, 1\na, 2",
                "t.s:2:1: error: found symbol 'a', already defined at t.s:1, expected another name"},
        Mistake{"tag_permanent", "add, 1",
                "t.s:1:1: error: found permanent symbol 'add' as a tag, expected another name"},
        Mistake{"assign_tag", "a, 1\na=2",
                "t.s:2:1: error: found an assignment to 'a', which is a tag, expected another name"},
        Mistake{
            "assign_permanent", "add=2\n 1",
            "t.s:1:1: warning: found an assignment to permanent symbol 'add', expected another name"},
        Mistake{"mark_tag", "a, 1\nlac #a",
                "t.s:2:6: error: found '#' at symbol 'a', which is defined otherwise, expected another name "
                "for the variable"},
        Mistake{"mark_nothing", "lac # 5",
                "t.s:1:7: error: found '5', expected the name of a variable after '#'"},
        Mistake{"before_first", " a\na=1\na=2",
                "t.s:1:2: error: found symbol 'a' before its first assignment, expected an earlier "
                "assignment, because it is assigned several values"},
        Mistake{"missing_term", " lac 5+\n",
                "t.s:1:8: error: found the end of the line, expected a number, a name, '.' or '('"},
        Mistake{"foreign_byte", "lac \xc3\xa9",
                "t.s:1:5: error: found '\\303', expected an operator or the end of the statement"},
        Mistake{"foreign_character", " 5*3",
                "t.s:1:3: error: found '*', expected an operator or the end of the statement"},
        Mistake{"comment_at_word", "a, lac a/no blank before\n",
                "t.s:1:4: error: found a '/' straight after the word 200000, expected an address from 00000 "
                "to 77777 (a comment needs a blank before its '/')"},
        Mistake{"end_of_core", "77777/ 1\n2\n3",
                "t.s:2:1: error: found a word after address 77777, expected the end of the program"},
        Mistake{"end_of_bank", "17777/ 1\n2",
                "t.s:2:1: error: found a word at 20000 that runs over the end of its bank, expected an "
                "origin for the next bank"},
        Mistake{"other_bank", "20000/ lac 5",
                "t.s:1:8: warning: found address 00005 in a word of another bank, expected 20005, which is "
                "what the machine will use"},
        Mistake{"overlap", "10/ 1\n10/ 2",
                "t.s:2:5: warning: found a second word at 00010, which replaces that of t.s:1, expected one "
                "word per address"},
        Mistake{"no_bracket", "ifzero 0 5",
                "t.s:1:11: error: found the end of the file, expected '<' after the condition"},
        Mistake{"open_taken", "ifzero 0 <5",
                "t.s:1:10: error: found '<' that is never closed, expected '>' before the end of the file"},
        Mistake{"open_skipped", "ifzero 1 <5\n<>",
                "t.s:1:10: error: found '<' that is never closed, expected '>' before the end of the file"},
        Mistake{"stray_close", " 5 >",
                "t.s:1:4: error: found '>' without '<', expected the end of the statement"},
        Mistake{"late_condition", "ifzero a <1>\na=0",
                "t.s:1:8: error: found symbol 'a' in a condition before its definition, expected a symbol "
                "defined before, or by -D"},
        Mistake{"text_open", "text /abc\n",
                "t.s:1:6: error: found no text between two equal characters, expected TEXT /characters/ on "
                "one line"},
        Mistake{
            "text_character", "text /a|b/",
            "t.s:1:8: error: found character '|', expected one of trimmed ASCII: blank to '_', and letters"},
        Mistake{"after_start", " 1\n start\n 5",
                "t.s:3:2: warning: found '5' after START, which is not read, expected the end of the file"},
        Mistake{"start_range", " 1\n start 100000",
                "t.s:2:8: error: found start address 100000, expected an address from 00000 to 77777"},
        Mistake{"octal_operand", "octal 5",
                "t.s:1:7: error: found '5', expected an operator or the end of the statement"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(Pdp7ErrorsAtOnce, AllOfAFileInOneRunInTheirOrder) {
  const std::vector<SourceFile> sources{
      {"one", "lac x\n 9\na, a=5"}, {"two", "\tjmp 20000 / far\n)\n start 1"}, {"three", "start 2"}};
  const Assembly assembly = assemble_pdp7(sources);
  EXPECT_EQ(messages(assembly),
            (Texts{"one:1:5: error: found undefined symbol 'x', expected a tag, an assignment, or #x",
                   "one:2:2: error: found '9' in number '9', expected octal digits (DECIMAL reads 8 and 9)",
                   "one:3:4: error: found an assignment to 'a', which is a tag, expected another name",
                   "two:1:2: error: found address 020000, expected one from 00000 to 17777",
                   "two:2:1: error: found ')', expected a number, a name, '.' or '('",
                   "three:1:7: error: found a second start address, expected one START with an address"}));
}

TEST(Pdp7ErrorsAtOnce, DeepNestingIsAnError) {
  const auto repeated = [](char c) {  // then a 1
    std::string text(100000, c);
    text.push_back('1');
    return text;
  };
  EXPECT_FALSE(assemble(repeated('(')).ok());
  EXPECT_TRUE(assemble(repeated('-')).ok());
  std::string blocks;
  for (int i = 0; i < 100000; ++i) blocks += "ifzero 0 <";
  EXPECT_FALSE(assemble(blocks).ok());
  EXPECT_TRUE(assemble(blocks + std::string(100000, '>')).ok());
}

TEST(Pdp7ErrorsAtOnce, AddressesThatDependOnThemselves) {
  const Assembly assembly = assemble("a=b+1\nb=a+1\n lac a\n");
  EXPECT_FALSE(assembly.ok());
}

}  // namespace
}  // namespace sightline::assembler
