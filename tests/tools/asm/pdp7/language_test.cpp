// The words that sources assemble to, worked out by hand from the instruction formats (P4-17 to P4-23, P4-58) and from the
// language rules of DIGITAL-7-3-S, or taken from programs of the time.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/tools/asm/assemble.hpp"
#include "tools/image/octal.hpp"

namespace sightline::assembler {
namespace {

std::string data_file(const std::string& name) {
  std::ifstream file(std::string(SIGHTLINE_TEST_DATA) + "/asm/" + name);
  EXPECT_TRUE(file) << name;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Pdp7Language, RimLoaderOfTheTime) {
  const Assembly assembly = assemble(data_file("rim-loader.s"));
  EXPECT_EQ(messages(assembly), Texts{});
  const auto expected = image::read_octal(data_file("rim-loader.octal"), "rim-loader.octal");
  ASSERT_TRUE(expected);
  EXPECT_EQ(assembly.image.words, expected.value().words);
  EXPECT_EQ(assembly.image.start, 017770U);
}

TEST(Pdp7Language, MemoryReferences) {
  const Assembly a = assemble(
      "x, lac x\n dac i x 5\nLAC I 10\n jmp .+3\n jmp .-2\n jms i x\n isz x+2\n xct 17777\n cal\n cal i\n i "
      "lac x");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0200000, 0060005, 0220010, 0600006, 0600002, 0120000, 0440002, 0417777, 0,
                             020000, 0220000}));
}

TEST(Pdp7Language, ExpressionsAreEvaluatedFromLeftToRight) {
  const Assembly a = assemble("1+2-4\n6!11&12\n7-3+2\n1 2 3\n10-7!40\n-1+2\n+5\n5+-3\n.\n.+.");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0777776, 012, 6, 6, 041, 1, 5, 2, 010, 022}));
}

TEST(Pdp7Language, OnesComplementByDefault) {
  EXPECT_EQ(words(assemble("-1\n-0\n-47\n5-5\n-3+1\n3-5\n777777+1\nlam -2\nlaw 17775")),
            (Words{0777776, 0777777, 0777730, 0, 0777775, 0777775, 1, 0777775, 0777775}));
}

TEST(Pdp7Language, TwosComplementOnRequest) {
  Options options;
  options.twos_complement = true;
  EXPECT_EQ(words(assemble("-1\n-0\n-47\n5-5\n777777+1\n-3+1", options)),
            (Words{0777777, 0, 0777731, 0, 0, 0777776}));
}

// A sum would give 711101, an IOT, where DEC's FF loader needs 751100.
TEST(Pdp7Language, MicroinstructionsOfOneClassAreOred) {
  const Assembly a = assemble(
      "spa cla\ncla cma\ncla cll ral\nclq!lacq\nlrs ecla 5\nidrc idcf\nsma!sza!cla\ncla+cma+hlt\n740001 cla\n"
      "mine=700704\nidrc mine");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0751100, 0750001, 0754010, 0651002, 0641505, 0700716, 0750300, 0750041, 0750001,
                             0700716}));
}

TEST(Pdp7Language, NumbersAreAddedEvenWhereTheyLookLikeMicroinstructions) {
  EXPECT_EQ(words(assemble("-30001+-20002\n740001+740001")), (Words{0727774, 0700003}));
}

TEST(Pdp7Language, StepCounts) {
  EXPECT_EQ(words(assemble("mul\nmul-11\nlls 44\nnorm\nidiv\nals 22\ndiv-22")),
            (Words{0653122, 0653111, 0640644, 0640444, 0653323, 0640722, 0640301}));
}

TEST(Pdp7Language, InstructionsCanBeNamed) {
  const Assembly a = assemble("call=jms i 20\ncall\ncall 5\nskip=skp\nskip cla\nn=lac i\nn 7");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0120020, 0120025, 0751000, 0220007}));
}

TEST(Pdp7Language, RadixAndItsScope) {
  EXPECT_EQ(words(assemble("18+1\n", Options{})), Words{});
  const std::vector<SourceFile> two{{"a", "DECIMAL\n18; 99\nOCTAL 17\n"}, {"b", "decimal\n10"}, {"c", "10"}};
  EXPECT_EQ(messages(assemble_pdp7(two)),
            Texts{"a:3:7: error: found '17', expected an operator or the end of the statement"});
  const std::vector<SourceFile> good{
      {"a", "DECIMAL\n18; 99\nOCTAL; 17\n"}, {"b", "decimal\n10"}, {"c", "10"}};
  EXPECT_EQ(words(assemble_pdp7(good)), (Words{022, 0143, 017, 012, 010}));
}

TEST(Pdp7Language, LiteralsArePooledByValueAndPlacedAtTheEnd) {
  const Assembly a =
      assemble("100/ lac (5\n add (-1)\n tad (5)\n lac (fwd)\n dac (1)+2\nfwd, lac ((7\n jmp i (fwd");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a, 0100), (Words{0200107, 0300110, 0340107, 0200111, 0040114, 0200114, 0620111, 5, 0777776,
                                   0105, 1, 7, 0113}));
}

TEST(Pdp7Language, AForwardReferenceDoesNotSplitAPool) {
  const Assembly a = assemble("lac (fwd)\n lac (fwd)\n constants\nfwd, lac (4)\n");
  EXPECT_EQ(words(a),
            (Words{0200002, 0200002, 3, 0200004, 4}));  // fwd is 3, once the pool is known to be one word
}

TEST(Pdp7Language, ConstantsAndVariablesArePlacedWhereAsked) {
  const Assembly a =
      assemble("lac (5\n dac zz#\n dac #aa\n constants\n lac (5\n variables\nx, lac zz\n dac bb#");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0200003, 0040006, 0040005, 5, 0200011, 0, 0, 0200006, 0040012, 5, 0}));
  EXPECT_EQ(a.value_of("aa"), 5U);
  EXPECT_EQ(a.value_of("BB"), 012U);
}

TEST(Pdp7Language, UndefinedSymbolsAreVariablesOnlyOnRequest) {
  EXPECT_FALSE(assemble("lac x\n dac y").ok());
  Options options;
  options.undefined_are_variables = true;
  const Assembly a = assemble("lac y\n dac x\n lac (3\n jmp t\nt, 0", options);
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0200007, 0040006, 0200005, 0600004, 0, 3, 0, 0}));
}

TEST(Pdp7Language, ConditionalsNestAndRunOverLines) {
  const std::string source =
      "n=0\nifzero n <1\n ifnzro n <2> 3\n> 4\nifnzro n <5 / > <\n ifzero 0 <6; text /a>b/\n>\n> 7\n"
      "ifzero -0 <10>; ifzero 1 <11> ifnzro 1 <12>\nifzero 1 <ifzero 0 <1>>";
  const Assembly a = assemble(source);
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{1, 3, 4, 7, 010, 012}));
}

TEST(Pdp7Language, DefinesOverrideTheSource) {
  Options options;
  options.defines = {{"EAE", 0}, {"size", 7}};
  const Assembly a = assemble("eae=1\nsize=100\nifzero eae <1>\nifnzro eae <2>\nsize", options);
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{1, 7}));
}

TEST(Pdp7Language, DefinesAreRead) {
  const auto define = parse_define("EAE=-1");
  ASSERT_TRUE(define);
  EXPECT_EQ(define->name, "EAE");
  EXPECT_EQ(define->value, 0777776U);
  for (const char* bad : {"", "EAE", "EAE=", "=1", "1A=1", "A=8", "A=1234567", "A=-", "a b=1", "A=1 "}) {
    EXPECT_FALSE(parse_define(bad)) << bad;
  }
}

TEST(Pdp7Language, TextIsTrimmedAsciiThreeToAWord) {
  EXPECT_EQ(words(assemble("text /ABCd/\n text 'a/ 1'\ntext ,,")),
            (Words{0010203, 0040000, 0015740, 0610000}));
}

TEST(Pdp7Language, PseudoOperationNamesMayBeTags) {
  const Assembly a =
      assemble("10/\nstart, jmp start\ntext, octal=5\noctal+1\nvariable, lac text\n start start");
  EXPECT_EQ(messages(a),
            (Texts{"t.s:4:6: error: found '+', expected an operator or the end of the statement"}));
  const Assembly b = assemble("10/\nstart, jmp start\ntext, 1\n jmp text\n start start");
  EXPECT_EQ(messages(b), Texts{});
  EXPECT_EQ(words(b, 010), (Words{0600010, 1, 0600011}));
  EXPECT_EQ(b.image.start, 010U);
}

TEST(Pdp7Language, SixCharactersCount) {
  const Assembly a = assemble("lengthone=5\n lengthone\n length\n LENGTHONE\n lengthtwo");
  EXPECT_EQ(words(a), (Words{5, 5, 5, 5}));
  EXPECT_EQ(
      messages(a),
      (Texts{
          "t.s:3:2: warning: found 'length', the same symbol as 'lengthone', expected names that differ in "
          "their first six characters",
          "t.s:5:2: warning: found 'lengthtwo', the same symbol as 'lengthone', expected names that differ "
          "in their first six characters"}));
}

TEST(Pdp7Language, AssignmentsMayLookAheadAndChange) {
  const Assembly a = assemble("a=b+1\n a\nb=5\nc=1\n c\nc=2\n c");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{6, 1, 2}));
}

TEST(Pdp7Language, BanksOfALargerMachine) {
  const Assembly a = assemble("20100/\nx, lac x\n jmp .+1\n lac (5");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a, 020100), (Words{0200100, 0600102, 0200103, 5}));
}

TEST(Pdp7Language, SeveralSourcesAreOneProgram) {
  const std::vector<SourceFile> sources{{"a", "lac x\n pause\n"}, {"b", "x, 7\r\n\tstart x\r\n"}};
  const Assembly a = assemble_pdp7(sources);
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0200001, 7}));
  EXPECT_EQ(a.image.start, 1U);
  EXPECT_EQ(a.symbols.at(0).file, "b");
  EXPECT_EQ(write_symbols(a.symbols), "x 000001\n");
}

TEST(Pdp7Language, TitleLineOnRequest) {
  Options options;
  options.first_line_is_title = true;
  EXPECT_EQ(words(assemble("this is, not code (\n5\ntitle nor this\n6", options)), (Words{5, 6}));
}

TEST(Pdp7Language, AnEmptySourceMakesNoWords) {
  EXPECT_TRUE(assemble_pdp7({}).ok());
  EXPECT_TRUE(assemble("").image.words.empty());
  EXPECT_TRUE(assemble("/ only a comment").ok());
}

TEST(Pdp7Language, ListingShowsAddressWordAndSource) {
  const std::string source =
      "/ two words\n10/\nx,      lac (5    / five\n        text /abcd/\nIFZERO 1 <\n skipped >\n dac v#\n "
      "start x\n";
  const Assembly a = assemble(source);
  const std::string expected =
      "              / two words\n"
      "              10/\n"
      "00010 200014  x,      lac (5    / five\n"
      "00011 010203          text /abcd/\n"
      "00012 040000\n"
      "              IFZERO 1 <\n"
      "               skipped >\n"
      "00013 040015   dac v#\n"
      "               start x\n"
      "00014 000005  (000005)\n"
      "00015 000000  v,\n";
  EXPECT_EQ(write_listing(a.listing), expected);
  EXPECT_EQ(write_listing(assemble(source).listing), expected);
}

// DIGITAL-7-3-S designates variables by # or $.
TEST(Pdp7Language, DollarMarksAVariableLikeHash) {
  const Assembly a = assemble("lac sum$\ndac $next\nlac sum\ntad next#");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0200005, 0040004, 0200005, 0340004, 0, 0}));
}

// Several tapes in one file: each begins in octal.
TEST(Pdp7Language, PauseInTheMiddleBeginsAnotherTape) {
  const Assembly a = assemble("decimal\n10\npause\n10\nx, 7\npause\n\ndecimal; 11; pause; 11\nstart x\n");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{012, 010, 7, 013, 011}));
  EXPECT_EQ(a.image.start, 2U);
  Options options;
  options.first_line_is_title = true;
  EXPECT_EQ(words(assemble("first tape\n1\npause\nsecond tape\n2\npause", options)), (Words{1, 2}));
  EXPECT_EQ(messages(assemble("pause 5")), (Texts{"t.s:1:7: error: found '5', expected the end of the statement"}));
}

TEST(Pdp7Language, PauseInAConditionalKeepsItOpen) {
  const Assembly a = assemble("ifzero 0 <1\npause\n2>\n3");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{1, 2, 3}));
}

// The Cambridge assembler of 1972: `cdr=jms,` at 3 is jms 3, so that cdr alone is a call.
TEST(Pdp7Language, NameEqualsExpressionComma) {
  const Assembly a = assemble("cdr\ncdr 1\ncdr i\ncdr=jms, 0\nbase=100, 7\nlac base");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0100003, 0100004, 0120003, 0, 7, 0200104}));
  EXPECT_EQ(messages(assemble("here=, 5")), (Texts{"t.s:1:6: error: found ',', which is this location in the Cambridge dialect, expected a number, a name, '.' or '('"}));
}

TEST(Pdp7Language, ATagDefinedByAnExpressionHasOneAddress) {
  EXPECT_EQ(messages(assemble("f=jms, 0\nf=jms, 0")),
            (Texts{"t.s:2:1: error: found symbol 'f', already defined at t.s:1, expected another name"}));
  EXPECT_EQ(messages(assemble("f=jms, 0\nf=5")),
            (Texts{"t.s:2:1: error: found an assignment to 'f', which is a tag, expected another name"}));
  EXPECT_EQ(messages(assemble("lac=jms, 0")),
            (Texts{"t.s:1:1: error: found permanent symbol 'lac' as a tag, expected another name"}));
}

TEST(Pdp7Language, PunchMakesNoWord) {
  const Assembly a = assemble("1\npunch\n2\npunch, 3\nlac punch");
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{1, 2, 3, 0200002}));
}

// DIGITAL-7-3-S, appendix 3: the undeclared names of a program unit are local to it. All sources are one program, so
// declarations only need to be consistent.
TEST(Pdp7Language, NamesOfASourceWithDeclarationsAreLocal) {
  const std::vector<SourceFile> sources{{"a", "100/\nexternal sqrt\nloop, jms sqrt\njmp loop\nn=1\nlac n\nlac v#\n"},
                                        {"b", "internal sqrt\nsqrt, 0\nloop, jmp i sqrt\njmp loop\nn=2\nlac n\nlac v#\n"}};
  const auto assembly = assemble_pdp7(sources);
  ASSERT_TRUE(assembly.ok()) << messages(assembly)[0];
  const auto word = [&assembly](std::uint32_t at) { return assembly.image.words.at(at).value(); };
  const std::vector<std::uint32_t> expected{0100104, 0600100, 0200001, 0200111, 0, 0620104, 0600105, 0200002, 0200112};
  for (std::uint32_t n = 0; n < expected.size(); ++n) EXPECT_EQ(word(0100 + n), expected[n]) << n;
  // Two variables, one in each source.
  EXPECT_EQ(assembly.image.words.size(), 11U);
  Options options;
  options.defines.push_back({"n", 7});
  const auto defined = assemble_pdp7(sources, options);
  EXPECT_EQ(defined.image.words.at(0102).value(), 0200007U);
  EXPECT_EQ(defined.image.words.at(0107).value(), 0200007U);
  EXPECT_EQ(messages(assemble_pdp7(std::vector<SourceFile>{{"a", "external s\njms s\nlac x\n"}, {"b", "internal s\ns, 0\nx, 5\n"}})),
            (Texts{"a:3:5: error: found undefined symbol 'x', expected a tag, an assignment, or #x"}));
}

TEST(Pdp7Language, ExternalAndInternalNames) {
  const std::vector<SourceFile> sources{{"a", "external sqrt, cube\njms sqrt\njms cube\n"},
                                        {"b", "internal sqrt\ninternal cube\nsqrt, 0\ncube=17\n"}};
  const Assembly a = assemble_pdp7(sources);
  EXPECT_EQ(messages(a), Texts{});
  EXPECT_EQ(words(a), (Words{0100002, 0100017, 0}));
}

TEST(Pdp7Language, DeclaredNamesMustBeDefined) {
  EXPECT_EQ(messages(assemble("external sqrt\njms sqrt\njms sqrt\ninternal cube")),
            (Texts{"t.s:1:10: error: found external symbol 'sqrt', which no source defines, expected the source that defines "
                   "it on the command line, too: there is no linker",
                   "t.s:4:10: error: found internal symbol 'cube', which no source defines, expected its definition"}));
  Options options;
  options.undefined_are_variables = true;
  EXPECT_EQ(messages(assemble("external sqrt\njms sqrt", options)).size(), 1U);
  EXPECT_EQ(messages(assemble("external")), (Texts{"t.s:1:9: error: found the end of the file, expected names"}));
  EXPECT_EQ(messages(assemble("external lac 5")).size(), 2U);
  EXPECT_EQ(messages(assemble("libfrm")),
            (Texts{"t.s:1:1: error: found LIBFRM, which asks DEC's Linking Loader for a library, expected the library among "
                   "the sources of the program"}));
}

TEST(Pdp7Language, OtherAssemblersConstructsAreNamed) {
  for (const auto& [text, name] : {std::pair<std::string, std::string>{"djs=0\ndjs , 2", "the Cambridge dialect"},
                                   {"disp", "the Cambridge dialect"},
                                   {"nodisp", "the Cambridge dialect"},
                                   {"*200", "PAL of the PDP-8"}}) {
    const Texts all = messages(assemble(text));
    ASSERT_FALSE(all.empty()) << text;
    EXPECT_NE(all.front().find(name), std::string::npos) << all.front();
  }
}

// The messages for constructs of the other dialect name it; they make no words.
TEST(Pdp7Language, ConstructsOfBellAreNamedWithTheirDialect) {
  for (const std::string source : {"loop: lac 5", "lac 5 \" comment", "jmp 1f", "jmp 2b", ".=.+5", "<ab>", "sys 5", "1: 0"}) {
    const Assembly a = assemble(source);
    EXPECT_FALSE(a.ok()) << source;
    bool named = false;
    for (const std::string& text : messages(a)) named = named || text.find("--dialect bell") != std::string::npos;
    EXPECT_TRUE(named) << source << ": " << messages(a).front();
  }
}

}  // namespace
}  // namespace sightline::assembler
