// The dialect of Bell Laboratories' `as` of 1970. The words are worked out by hand from the instruction formats (P4-17 to P4-23,
// P4-58) and from as.s, the assembler's own source (pdp7-unix, scans/as.s), whose labels each test names.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/asm/assemble.hpp"

namespace sightline::assembler {
namespace {

Options bell_options() {
  Options options;
  options.dialect = Dialect::bell;
  return options;
}

Assembly bell(std::string text) {
  return assemble(std::move(text), bell_options());
}

// The words of a source from location 0 on.
Words words_at_0(const std::string& text) {
  const Assembly a = bell(".. = 0\n" + text);
  EXPECT_EQ(messages(a), Texts{}) << text;
  return words(a);
}

std::string first_message(const std::string& text) {
  const auto all = messages(bell(text));
  return all.empty() ? "no message" : all.front();
}

// gs3: radix 8 after a leading 0, else 10. d80 and o17 are ordinary names.
TEST(BellLanguage, NumbersAreDecimalOrOctalWithALeading0) {
  EXPECT_EQ(words_at_0("10\n010\n0\n262143\n0777777\nd80: 80\no17: 017; lac d80; lac o17"),
            (Words{012, 010, 0, 0777777, 0777777, 0120, 017, 0200005, 0200006}));
}

// ominus, in two's complement: cma and tad of minus one. A leading operator has 0 before it (gpair).
TEST(BellLanguage, MinusIsTwosComplement) {
  EXPECT_EQ(words_at_0("-1\n-129\n5-5\n3-5\n-1+2\n+7"), (Words{0777777, 0777577, 0, 0777776, 1, 7}));
}

// expr: r accumulates the sum until a blank ORs it into srand. 9+7 is 16, 020.
TEST(BellLanguage, PlusAndMinusBindMoreTightlyThanBlanks) {
  EXPECT_EQ(words_at_0("1 2 4\n5 4\n1 9+7\n9+7 1\n1 + 2 4\n6 -2 1"), (Words{7, 5, 021, 021, 7, 5}));
}

// The indirect bit is ORed at any position: a trailing i as in the kernel, a leading one as in as.s itself.
TEST(BellLanguage, InstructionsAndTheTrailingI) {
  EXPECT_EQ(
      words_at_0("x: lac x\ndac x+1 i\ndac i 8\njmp .-1\njms x i\nspa cla\ncla cma\nlrss 9\nalss 9\nllss 27\n"
                 "law 017\nxct x"),
      (Words{0200000, 0060001, 0060010, 0600002, 0120000, 0751100, 0750001, 0660511, 0660711, 0660633,
             0760017, 0400000}));
}

// lactab: `;` has the class of the end of a line (5), `"` ends the line (gchar).
TEST(BellLanguage, SemicolonsAndComments) {
  EXPECT_EQ(words_at_0("1;2 ; 3\" 4; 5\n\" 6\n  ;;7\n\n8\""), (Words{1, 2, 3, 7, 010}));
}

// lqot shifts a character nine bits left, rqot takes it as it is; a is 0141, b 0142, blank 040.
TEST(BellLanguage, Characters) {
  EXPECT_EQ(words_at_0("<a\n<ab>\nb>\n<a 012\n<a b>\n>>\n<;1\n<  012\n<a>b\n1>"),
            (Words{0141000, 0141142, 0142, 0141012, 0141142, 076, 073001, 040012, 0141142, 061}));
}

// Strings as printed sources of 1970 write them: >x for the right half, blanks and any other character, a label before `..`.
TEST(BellLanguage, CharactersAsInPrintedSources) {
  EXPECT_EQ(
      words_at_0(
          "<g>o;< > ;< > \" end\n<*z>\n<;;<:;<? 012\n.>;->;:>;=>\njms 7; 3:..; ..\nlac 3b\na:b:4:5\nlac b"),
      (Words{0147157, 040040, 040040, 052172, 073000, 072000, 077012, 056, 055, 072, 075, 0100007, 0, 0,
             0200014, 5, 0200017}));
}

// assm4: a label has the value of `.`; several can precede one word.
TEST(BellLanguage, Labels) {
  EXPECT_EQ(words_at_0("a: b: c : 5\nlac b\nd:\ne: lac d; lac e; Lac: 0\nlac Lac"),
            (Words{5, 0200000, 0200002, 0200002, 0, 0200004}));
}

// assm3 counts the definitions of 0 to 9; gs3 finds the next one for f and the last one for b.
TEST(BellLanguage, RelativeLabels) {
  EXPECT_EQ(
      words_at_0(
          "1: jmp 1b\njmp 1f\n1: jmp 1b; jmp 1f\n2: 1: 0\njmp 2b\n1f-1b; 1: 7\n0: lac 0b; lac 9f+1\n9: 0"),
      (Words{0600000, 0600002, 0600002, 0600004, 0, 0600004, 3, 7, 0200010, 0200013, 0}));
}

// assm4 and lookup: a name keeps its last value from pass 1 to its first place in pass 2. The words are those that `as` of 1970,
// run under UNIX v0, and as7 make of these sources.
TEST(BellLanguage, NamesThatAreSetAgain) {
  const Assembly twice = bell("   lac q\nq: 1\n   lac q\nq: 2\n   lac q\nq: 3\n   lac q\n");
  EXPECT_TRUE(twice.ok());
  EXPECT_EQ(messages(twice).size(), 1U) << "one warning for each name";
  EXPECT_EQ(words(bell("..=0\n   lac q\nq: 1\n   lac q\nq: 2\n   lac q\nq: 3\n   lac q\n")),
            (Words{0200005, 1, 0200001, 2, 0200003, 3, 0200005}));
  EXPECT_EQ(words_at_0("   -n\n   lac n\n   n = 1\n   lac n\n   n = n+1\n   lac n\n"),
            (Words{0777776, 0200002, 0200001, 0200002}));
  EXPECT_EQ(words(bell("..=0\nlac a; a: lac a; a = 7; lac a; a = a+1; lac a; a: lac a")),
            (Words{0200004, 0200001, 0200007, 0200010, 0200004}));
  EXPECT_EQ(words_at_0("m; m = n; n = 1; n = n+2"), (Words{3}));
}

// assm4 with a name of gs3: `9f:` sets 9f up to the next `9:`, which sets it once more; before the first place it has the last value.
TEST(BellLanguage, RelativeLabelsThatAreSet) {
  EXPECT_EQ(words_at_0("dac 9f; isz 9f; 9f:0; lac 9f"), (Words{0040002, 0440002, 0, 0200002}));
  EXPECT_EQ(words_at_0("dac 9f; 9f:1; lac 9f; 9: 3; lac 9b; lac 9f; 9: 4"),
            (Words{0040003, 1, 0200001, 3, 0200003, 0200006, 4}));
  EXPECT_EQ(words_at_0("9: 1; 9b: 2; lac 9b; 9b = 7; lac 9b; 9f = 9b+1; lac 9f"), (Words{1, 2, 0200001, 0200007, 0200010}));
}

// The idiom of the kernel: t counts the temporaries of all routines, 9: reserves them.
TEST(BellLanguage, TemporariesBy9fPlusT) {
  EXPECT_EQ(words_at_0("t = 0\nlac 9f+t; dac 9f+t+1 i\nt = t+2\nlac 9f+t\nt=t+1\n9: .=.+t\n7"),
            (Words{0200003, 0060004, 0200005}));
  const Assembly a = bell("..=0\nt=0\nt=t+2\n9: .=.+t\n7");
  EXPECT_EQ(words(a, 2), (Words{7}));
}

// process adds the value of `..`, 4096, to values with one relocatable term, and to the location.
TEST(BellLanguage, RelocatableWordsBeginAt4096) {
  const Assembly a = bell("a: lac a\n1\nb: b-a\nx = 5\nlac x\n. = 020\nb");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a, 010000), (Words{0210000, 1, 2, 0200005}));
  EXPECT_EQ(words(a, 020), (Words{010002}));
  EXPECT_EQ(a.value_of("b"), 010002U);
  EXPECT_EQ(a.value_of("x"), 5U);
  EXPECT_EQ(words(bell("..=0100\na: lac a; lac .."), 0100), (Words{0200100, 0200100}));
}

// The sources define the names of system calls; sys is cal i, 020000.
TEST(BellLanguage, SystemCalls) {
  EXPECT_EQ(words_at_0("open = 3; write=5\nsys open; name; 0\nsys write\nname: <na>"),
            (Words{020003, 4, 0, 020005, 0156141}));
}

TEST(BellLanguage, SeveralSourcesAreOneProgram) {
  const std::vector<SourceFile> sources{{"a.s", "..=0\nlac d1\n1: jmp 1f\nlac d1"},
                                        {"b.s", "\" b\n1: 5\nd1: 1\njmp 1b"}};
  const Assembly a = assemble_pdp7(sources, bell_options());
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0200004, 0600003, 0200004, 5, 1, 0600003}));
}

// gs2: eight characters count; upper and lower case differ.
TEST(BellLanguage, EightCharactersOfANameCount) {
  const Assembly a = bell("..=0\nabcdefgh1: 7\nlac abcdefgh2\nA: 1\na: 2\nlac a\n.x.y: 3");
  EXPECT_EQ(words(a), (Words{7, 0200000, 1, 2, 0200003, 3}));
  EXPECT_EQ(messages(a),
            (Texts{"t.s:3:5: warning: found 'abcdefgh2', the same symbol as 'abcdefgh1', expected names that "
                   "differ in their first eight characters"}));
}

// A file such as sop.s repeats the instruction table; the symbols stay instructions.
TEST(BellLanguage, SourcesMayDefineTheInstructions) {
  EXPECT_EQ(words_at_0("lac = 0200000\ni = 020000\nmine = 0700501\nlac 5 i\nmine"),
            (Words{0220005, 0700501}));
  EXPECT_EQ(
      first_message("lac = 0200000\nlac -1"),
      "t.s:2:1: error: found word 177777, which is no lac, expected an operand from 0 to 017777, and i");
}

// as.s has no predefined names, so its source can have a label iof.
TEST(BellLanguage, LabelsHideInstructions) {
  const Assembly a = bell("..=0\nlac iof\niof: 5");
  EXPECT_EQ(words(a), (Words{0200001, 5}));
  EXPECT_EQ(
      messages(a),
      (Texts{"t.s:3:1: warning: found label 'iof', which hides the instruction of this name, expected "
             "another name"}));
}

TEST(BellLanguage, DefinesOverrideAssignments) {
  Options options = bell_options();
  options.defines = {{"t", 5}};
  EXPECT_EQ(words(assemble("..=0\nt=3\nt", options)), (Words{5}));
}

TEST(BellLanguage, ListingHasEveryWord) {
  const Assembly a = bell("..=0\na: 1; 2\n");
  ASSERT_EQ(a.listing.size(), 3U);
  EXPECT_EQ(a.listing[1].address, "00000");
  EXPECT_EQ(a.listing[1].code, "000001");
  EXPECT_EQ(a.listing[2].code, "000002");
}

// --- Errors ---

// The message for each construct of the other dialect names that dialect; none makes a word silently.
TEST(BellErrors, ConstructsOfDecAreNamedWithTheirDialect) {
  const std::string dec = "--dialect dec";
  for (const std::string source : {"begin, lac 5", "lac (5", "lac 5 / comment", "lac a#", "lac $a", "1!2",
                                   "3&1", "decimal", "start 100", "text /abc/", "LAC 5", "variables"}) {
    const Assembly a = bell(source);
    EXPECT_FALSE(a.ok()) << source;
    EXPECT_TRUE(a.image.words.empty()) << source;
    bool named = false;
    for (const std::string& text : messages(a)) named = named || text.find(dec) != std::string::npos;
    EXPECT_TRUE(named) << source << ": " << first_message(source);
  }
}

TEST(BellErrors, EachHasItsPosition) {
  const auto expect = [](const std::string& source, const std::string& message) {
    EXPECT_EQ(first_message(source), "t.s:" + message) << source;
  };
  expect(
      "lac nowhere",
      "1:5: error: found undefined name 'nowhere', expected a label or an assignment in one of the sources");
  expect("begin, lac 5",
         "1:1: error: found 'begin', a tag of --dialect dec, expected a label, with ':' after the name");
  expect("08",
         "1:1: error: found '8' in octal number '08', expected octal digits; a decimal number begins with "
         "another "
         "digit than 0");
  expect("262144", "1:1: error: found number '262144', expected at most 0777777, which is 18 bits");
  const std::string again = "2:1: warning: found 'a' set again, expected another name than at t.s:1; before that line it has its last value";
  for (const char* twice : {"a: 1\na: 2", "a: 1\na = 2", "a = 1\na: 2", "a: 1\na: 2; a: 3; a: 4"}) expect(twice, again);
  expect("jmp 1f", "1:5: error: found '1f' without a label 1: after it, expected the label, or 1b");
  expect("jmp 1b\n1: 0", "1:5: error: found '1b' without a label 1: before it, expected the label, or 1f");
  expect("12: 0", "1:1: error: found '12:', expected a relative label 0: to 9:, or a name");
  expect("10f", "1:1: error: found '10f', expected a number, or a relative label 0b to 9b or 0f to 9f");
  expect("1+", "1:3: error: found the end of the file, expected a name, a number, '.' or a character <a");
  expect("a: lac a+a",
         "1:4: error: found the sum of two locations, expected at most one location that is added, or the "
         "difference of two");
  expect("a: 1-a",
         "1:4: error: found a number minus a location, expected at most one location that is added, or the "
         "difference of two");
  expect("law -3",
         "1:1: error: found word 757775, which is no law, expected an operand that fits the instruction");
  expect("<\"a",
         "1:1: error: found no character after '<', expected another than '\"', which begins a comment; its "
         "code "
         "is 042");
  expect("<\n",
         "1:1: error: found no character after '<', expected one of ASCII, blank to '~', or its code as a "
         "number");
  expect(
      "1\n..=0",
      "2:4: error: found '..' set after the first word or label, expected one value for the program, at its "
      "beginning");
  expect(".=020000", "1:3: error: found location 020000, expected one up to 017777");
  expect("..=0\n.=017777\n1;2",
         "3:3: error: found a word after location 017777, expected the end of the program");
  expect(".=a\na: 0",
         "1:3: error: found 'a' before its first definition, expected a name that is defined before, because "
         "the location depends on it");
  expect("lac t\nt=t+1", "1:5: error: found 't' without a value, expected a definition that does not depend on itself");
  expect("1\n.=.-1\n2",
         "3:1: warning: found a second word at 010000, which replaces that of t.s:1, expected one word "
         "per location");
  expect("_x", "1:1: error: found '_', expected a name, a number, '.' or a character <a");
}

TEST(BellErrors, LongNamesAreShownByTheirBeginning) {
  const std::string name(100000, 'x');
  EXPECT_EQ(first_message(name), "t.s:1:1: error: found undefined name '" + std::string(40, 'x') +
                                     "...', expected a label or an assignment in one of the sources");
  for (const std::string& text :
       {name + ": 1\n" + name + ": 2", name + "=1;" + name + ": 2", name + ": 1;" + name + "=3",
        std::string(100000, '1') + ": 5", std::string(100000, '1'), "1" + name})
    EXPECT_LT(first_message(text).size(), 200U) << first_message(text).substr(0, 100);
}

TEST(BellErrors, AllOfAProgramInOneRun) {
  const std::vector<SourceFile> sources{{"a.s", "lac no1\n\n  lac no2; lac no3\n"}, {"b.s", "09\n5\n(1\n"}};
  const Assembly a = assemble_pdp7(sources, bell_options());
  ASSERT_EQ(a.diagnostics.size(), 5U);
  EXPECT_EQ(a.diagnostics[1].line, 3U);
  EXPECT_EQ(a.diagnostics[2].column, 16U);
  EXPECT_EQ(a.diagnostics[3].file, "b.s");
  EXPECT_EQ(a.diagnostics[4].line, 3U);
}

// Random programs with known words: the generator counts the locations and has its own table of codes.
class Generated {
 public:
  explicit Generated(unsigned seed) : dice_(seed) {
    for (std::uint32_t at = 0; at < length; ++at) word(at);
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const Words& words() const { return words_; }

 private:
  static constexpr std::uint32_t length = 200;

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(dice_() % n); }
  static std::string octal(std::uint32_t n) {
    std::string digits;
    for (; n != 0; n >>= 3) digits.insert(digits.begin(), static_cast<char>('0' + (n & 7)));
    return "0" + digits;
  }
  void add(const std::string& text, std::uint32_t word) {
    text_ += text + (below(3) == 0 ? "; " : below(2) == 0 ? " \" a, comment: (1)\n" : "\n");
    words_.push_back(word & 0777777);
  }
  // Every location has a label, every third a relative one.
  void word(std::uint32_t at) {
    static const std::vector<std::pair<std::string, std::uint32_t>> memory{
        {"dac", 0040000}, {"jms", 0100000}, {"lac", 0200000},
        {"tad", 0340000}, {"isz", 0440000}, {"jmp", 0600000}};
    text_ += "l" + std::to_string(at) + ": ";
    if (at % 3 == 0) text_ += "4: ";
    const std::uint32_t number = below(01000000);
    switch (below(6)) {
      case 0: return add(std::to_string(number), number);
      case 1: return add(octal(number), number);
      case 2: return add("-" + std::to_string(number), 01000000 - number);
      case 3: {
        const auto a = static_cast<char>('a' + below(26));
        const auto b = static_cast<char>('A' + below(26));
        return add(std::string("<") + a + b + ">",
                   static_cast<std::uint32_t>(a) * 512 + static_cast<std::uint32_t>(b));
      }
      case 4: {
        const bool forward = at + 3 < length && below(2) == 0;
        const std::uint32_t target = at / 3 * 3 + (forward ? 3 : 0);
        return add(forward ? "lac 4f" : "lac 4b", 0200000 + target);
      }
      default: {
        const auto& [name, code] = memory[below(6)];
        const std::uint32_t target = below(length);
        const std::uint32_t offset = below(10);
        const bool indirect = below(2) == 0;
        return add(
            name + " l" + std::to_string(target) + "+" + std::to_string(offset) + (indirect ? " i" : ""),
            code + target + offset + (indirect ? 020000 : 0));
      }
    }
  }

  std::mt19937 dice_;
  std::string text_;
  Words words_;
};

TEST(BellLanguage, GeneratedProgramsHaveTheExpectedWords) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Generated program(seed);
    const Assembly at_0 = bell("..=0\n" + program.text());
    ASSERT_EQ(messages(at_0), Texts{}) << program.text();
    ASSERT_EQ(words(at_0), program.words()) << program.text();
    const Assembly elsewhere = bell("..=01000\n" + program.text());
    ASSERT_EQ(words(elsewhere, 01000).size(), program.words().size());
  }
}

// As large as the kernel of 1970, with labels of both kinds. It takes some milliseconds; the limit allows for sanitizers on a
// busy
// machine and detects superlinear time.
TEST(BellLanguage, ThreeThousandWords) {
  std::string text = "..=0\n";
  for (int i = 0; i < 1000; ++i) {
    const std::string n = std::to_string(i);
    text += "l" + n + ": 0\n   lac l" + std::to_string((i + 1) % 1000) + " i\" next\n1:  jmp 1b\n";
  }
  const auto begin = std::chrono::steady_clock::now();
  const Assembly a = bell(text);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(messages(a), Texts{});
  ASSERT_EQ(a.image.words.size(), 3000U);
  EXPECT_EQ(a.image.words.at(1), core::Word18(0220003));
  EXPECT_EQ(a.image.words.at(5), core::Word18(0600005));
  EXPECT_EQ(a.image.words.at(2998), core::Word18(0220000));
  EXPECT_LT(taken.count(), 1.0);
}

}  // namespace
}  // namespace sightline::assembler
