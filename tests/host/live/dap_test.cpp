// An editor's session by the Debug Adapter Protocol: the client's messages are written here, and the expected replies follow from
// the
// programs: lines, addresses, registers. Then invalid messages.
#include "host/live/dap/dap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/live/symbols.hpp"
#include "tests/host/app/command_line.hpp"
#include "tests/host/machines/machine_run.hpp"
#include "tests/host/live/disk_system.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/image/intel_hex.hpp"
#include "tools/image/tape.hpp"

namespace sightline::test {
namespace {

using nlohmann::json;

std::string frame_message(const std::string& message) {
  return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + message;
}

// The messages sent back, in order.
std::vector<json> messages(const std::string& wire) {
  std::vector<json> all;
  std::size_t at = 0;
  while (at < wire.size()) {
    const std::size_t end = wire.find("\r\n\r\n", at);
    if (end == std::string::npos) {
      ADD_FAILURE() << "no header at byte " << at;
      break;
    }
    const std::size_t length = std::stoul(wire.substr(at + 16, end - at - 16));
    all.push_back(json::parse(wire.substr(end + 4, length)));
    at = end + 4 + length;
  }
  return all;
}

// Runs the command as an editor starts it. The whole session is one script, so that all of it is available when the first request
// is
// answered; requests that start a run need DapSteps.
class Dap : public CommandLine {
 protected:
  void request(const std::string& command, json arguments = json::object()) {
    script_ += frame_message(json{{"seq", ++sequence_}, {"type", "request"}, {"command", command}, {"arguments", std::move(arguments)}}
                          .dump());
  }
  void hold() {
    const Ran ran = sightline({"dap"}, script_);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    received_ = messages(ran.out);
    for (std::size_t n = 0; n < received_.size(); ++n) EXPECT_EQ(received_[n].at("seq"), n + 1);
  }
  // The reply to the nth request of that name, from 0.
  json answer(const std::string& command, std::size_t n = 0) {
    for (const json& message : received_)
      if (message.at("type") == "response" && message.at("command") == command && n-- == 0) return message;
    ADD_FAILURE() << "no answer to " << command;
    return {};
  }
  std::vector<json> events(const std::string& name) {
    std::vector<json> found;
    for (const json& message : received_)
      if (message.at("type") == "event" && message.at("event") == name) found.push_back(message.at("body"));
    return found;
  }

  std::string script_;
  int sequence_ = 0;
  std::vector<json> received_;
};

TEST_F(Dap, BreakpointsAreSetInTheSource) {
  write("p.s",
        "/ A title line.\n"     // 1
        "100/\n"                // 2
        "begin,  lac (3\n"      // 3: 100
        "        jms store\n"   // 4: 101
        "        lac (5\n"      // 5: 102
        "        jms store\n"   // 6: 103
        "        hlt\n"         // 7: 104
        "\n"                    // 8
        "store,  0\n"           // 9: 105
        "        dac place\n"   // 10: 106
        "        jmp i store\n" // 11: 107
        "place,  0\n"           // 12: 110
        "        start begin\n");
  const std::string source = path("p.s").string();
  request("initialize", {{"adapterID", "sightline"}, {"linesStartAt1", true}});
  request("launch", {{"machine", "pdp7"}, {"program", source}, {"stopOnEntry", true}, {"options", {{"memory", "4k"}}}});
  request("setBreakpoints", {{"source", {{"path", source}}}, {"breakpoints", {{{"line", 8}}, {{"line", 400}}}}});
  request("setFunctionBreakpoints", {{"breakpoints", {{{"name", "store+1"}, {"condition", "ac==5"}}, {{"name", "nobody"}}}}});
  request("configurationDone");
  request("stackTrace", {{"threadId", 1}});
  request("disconnect");
  hold();
  EXPECT_EQ(answer("initialize").at("body").at("supportsStepBack"), true);
  ASSERT_EQ(events("initialized").size(), 1U);
  // A line without code moves to the next line with code.
  const json lines = answer("setBreakpoints").at("body").at("breakpoints");
  EXPECT_EQ(lines[0].at("verified"), true);
  EXPECT_EQ(lines[0].at("line"), 9);
  EXPECT_EQ(lines[0].at("instructionReference"), "0x45");
  EXPECT_EQ(lines[1].at("verified"), false);
  const json functions = answer("setFunctionBreakpoints").at("body").at("breakpoints");
  EXPECT_EQ(functions[0].at("verified"), true);
  EXPECT_EQ(functions[1].at("verified"), false);
  const json top = answer("stackTrace").at("body").at("stackFrames").at(0);
  EXPECT_EQ(top.at("line"), 3);
  EXPECT_EQ(top.at("instructionPointerReference"), "0x40");
  EXPECT_EQ(top.at("source").at("name"), "p.s");
  EXPECT_EQ(events("stopped").at(0).at("reason"), "entry");
}

// A client that sends a request when the machine is stopped.
class DapSteps : public Dap {
 protected:
  // `restart` calls `launch` again.
  void hold_with(std::function<base::Result<live::Launched>(const json&)> launch,
                 std::function<base::Result<base::Done>(const machines::Machine&)> finish = {}) {
    live::DapHost host;
    host.finish = std::move(finish);
    std::string wire;
    std::size_t at = 0;
    host.read = [&](int milliseconds) -> std::optional<std::string> {
      if (milliseconds == 0) return std::string();
      if (at == script_.size()) return std::nullopt;
      // In two pieces, as may happen.
      const std::size_t end = std::min(script_.size(), at + (script_.size() - at + 1) / 2);
      const std::string piece = script_.substr(at, 1 + (end - at) % 97);
      at += piece.size();
      return piece;
    };
    host.write = [&wire](std::string_view text) {
      wire += text;
      return true;
    };
    host.launch = [&launch](const base::Json&) { return launch({}); };
    const auto done = live::serve_debug_adapter(host);
    EXPECT_TRUE(done.has_value());
    received_ = messages(wire);
  }
  // "PC=00105 AC=000003", from the nth reply to `variables`.
  std::string registers(std::size_t n, const std::vector<std::string>& names) {
    std::string text;
    const json whole = answer("variables", n);
    for (const json& each : whole.at("body").at("variables")) {
      const std::string name = each.at("name");
      if (std::find(names.begin(), names.end(), name) != names.end())
        text += (text.empty() ? "" : " ") + name + "=" + each.at("value").get<std::string>();
    }
    return text;
  }
  // Starts a session of a program, stopped at its first instruction.
  void begin() {
    request("initialize");
    request("launch");
    request("configurationDone");
  }
  void look() { request("variables", {{"variablesReference", 1}}); }
};

template <class Assembly>
live::Launched launch_run(const machines::MachineDescription& description, MachineRun& of, const Assembly& assembly,
                        const std::string& table, const char* start = "100") {
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  of.set("--start", start).monitored();
  auto prepared = of.prepared();
  EXPECT_TRUE(prepared.has_value()) << of.refusal();
  live::Symbols symbols(description.radix);
  EXPECT_TRUE(symbols.add_table(table));
  for (const auto& line : machines::source_lines(assembly.listing, description.radix)) symbols.add_line(line.address, {line.file, line.line});
  return {&description, std::move(*prepared), std::move(symbols), {}};
}

live::Launched launch_pdp7(const std::string& source, const char* start = "100") {
  const std::vector<assembler::SourceFile> sources{{"p.s", source}};
  const auto assembly = assembler::assemble_pdp7(sources, {});
  const auto tape = image::write_rim(assembly.image, "p.rim");
  MachineRun of(machines::pdp7());
  of.set_file("--load", "p.rim", {reinterpret_cast<const char*>(tape->data()), tape->size()});
  return launch_run(machines::pdp7(), of, assembly, assembler::write_symbols(assembly.symbols), start);
}

live::Launched launch_i8080(const std::string& source) {
  const std::vector<assembler::SourceFile> sources{{"p.asm", source}};
  const auto assembly = assembler::assemble_i8080(sources);
  MachineRun of(machines::i8080());
  of.set_file("--load", "p.hex", image::write_intel_hex(assembly.image)).set("--cpm").set("--console", "ascii");
  return launch_run(machines::i8080(), of, assembly, assembler::write_i8080_symbols(assembly.symbols));
}

TEST_F(DapSteps, ThePdp7RunsForwardAndBack) {
  request("initialize");
  request("launch");
  request("setFunctionBreakpoints", {{"breakpoints", {{{"name", "store+1"}}}}});
  request("dataBreakpointInfo", {{"name", "place"}});
  request("dataBreakpointInfo", {{"name", "ac"}});
  request("setDataBreakpoints", {{"breakpoints", {{{"dataId", "0x48"}, {"accessType", "write"}, {"hitCondition", "2"}}}}});
  request("configurationDone");  // runs to store+1
  look();
  request("stackTrace");
  request("stepOut");  // back at 102
  look();
  request("stepBack");  // at JMP I STORE
  look();
  request("stepIn");
  request("next");  // LAC
  request("setFunctionBreakpoints", {{"breakpoints", json::array()}});
  request("next");  // over the JMS; the second write of PLACE stops it
  look();
  request("reverseContinue");  // to the first write of PLACE: counts are ignored
  look();
  request("setVariable", {{"variablesReference", 1}, {"name", "AC"}, {"value", "777"}});
  request("setVariable", {{"variablesReference", 1}, {"name", "AC"}, {"value", "1000000"}});
  request("readMemory", {{"memoryReference", "0x40"}, {"count", 5}});
  request("writeMemory", {{"memoryReference", "0x48"}, {"data", "AQIDAA=="}});
  request("evaluate", {{"expression", "[place]"}});
  request("disassemble", {{"memoryReference", "0x40"}, {"instructionOffset", -1}, {"instructionCount", 2}});
  request("disconnect");
  hold_with([](const json&) {
    return launch_pdp7(
        "100/\nbegin, lac (3\n  jms store\n  lac (5\n  jms store\n  hlt\nstore, 0\n  dac place\n  jmp i store\n"
        "place, 0\n  start begin\n");
  });
  EXPECT_EQ(answer("dataBreakpointInfo", 0).at("body").at("dataId"), "0x48");
  EXPECT_TRUE(answer("dataBreakpointInfo", 1).at("body").at("dataId").is_null());
  EXPECT_EQ(registers(0, {"PC", "AC"}), "PC=00106 AC=000003");
  const json frames = answer("stackTrace").at("body").at("stackFrames");
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].at("line"), 8);
  EXPECT_EQ(frames[1].at("line"), 3);
  EXPECT_EQ(frames[1].at("name"), "begin+1");
  EXPECT_EQ(registers(1, {"PC", "AC"}), "PC=00102 AC=000003");
  EXPECT_EQ(registers(2, {"PC", "AC"}), "PC=00107 AC=000003");
  EXPECT_EQ(registers(3, {"PC", "AC"}), "PC=00107 AC=000005");
  EXPECT_EQ(registers(4, {"PC", "AC"}), "PC=00107 AC=000003");
  std::string reasons;
  for (const json& body : events("stopped")) reasons += body.at("reason").get<std::string>() + " ";
  EXPECT_EQ(reasons, "breakpoint step step step step breakpoint breakpoint ");
  EXPECT_EQ(answer("setVariable", 0).at("body").at("value"), "000777");
  EXPECT_EQ(answer("setVariable", 1).at("success"), false);
  // 200111 is 010111 in hexadecimal; the first five of its bytes and the next word's.
  EXPECT_EQ(answer("readMemory").at("body").at("data"), "SQABAEU=");
  EXPECT_EQ(answer("evaluate").at("body").at("result"), "601001 = 197121. = -65023. as a word with a sign");
  const json rows = answer("disassemble").at("body").at("instructions");
  EXPECT_EQ(rows[0].at("address"), "0x3F");
  EXPECT_EQ(rows[1].at("line"), 2);
}

TEST_F(DapSteps, The8080PrintsAndHasWatchpoints) {
  request("initialize", {{"linesStartAt1", false}});
  request("launch");
  request("setBreakpoints", {{"source", {{"path", "p.asm"}}}, {"breakpoints", {{{"line", 4}, {"condition", "a==41+1"}}}}});
  request("evaluate", {{"expression", "send \"AB\""}, {"context", "repl"}});
  request("configurationDone");  // to the line after the CALL with B in A
  look();
  request("stackTrace");
  request("scopes", {{"frameId", 0}});
  request("disconnect");
  hold_with([](const json&) {
    return launch_i8080("\tORG 100H\nAGAIN:\tMVI C,1\n\tCALL 5\n\tNOP\n\tMOV D,A\n\tJMP AGAIN\n");
  });
  EXPECT_EQ(answer("setBreakpoints").at("body").at("breakpoints").at(0).at("line"), 4);
  EXPECT_EQ(registers(0, {"PC", "A"}), "A=42 PC=0106");
  EXPECT_EQ(answer("stackTrace").at("body").at("stackFrames").at(0).at("line"), 4);
  std::string printed;
  for (const json& body : events("output"))
    if (body.at("category") == "stdout") printed += body.at("output").get<std::string>();
  EXPECT_EQ(printed, "AB");
}

// Instructions have one to three bytes: the rows before an address end there, with the assembler's instructions.
TEST_F(DapSteps, RowsBeforeAnAddressOfThe8080) {
  begin();
  request("disassemble", {{"memoryReference", "0x10B"}, {"instructionOffset", -5}, {"instructionCount", 7}});
  request("disassemble", {{"memoryReference", "0x1"}, {"instructionOffset", -3}, {"instructionCount", 4}});
  request("disassemble", {{"memoryReference", "0x100"}, {"instructionOffset", 2}, {"instructionCount", 1}});
  request("disassemble", {{"memoryReference", "0xFFFF"}, {"instructionOffset", 3}, {"instructionCount", 2}});
  request("disconnect");
  hold_with([](const json&) {
    return launch_i8080("\tORG 100H\n\tLXI H,2121H\n\tMVI A,21H\n\tINX H\n\tCALL 2121H\n\tMVI M,3EH\n\tHLT\n");
  });
  const auto addresses = [this](std::size_t n) {
    std::string text;
    const json whole = answer("disassemble", n);
    for (const json& row : whole.at("body").at("instructions")) text += row.at("address").get<std::string>() + " ";
    return text;
  };
  EXPECT_EQ(addresses(0), "0x100 0x103 0x105 0x106 0x109 0x10B 0x10C ");
  const json edge = answer("disassemble", 1).at("body").at("instructions");
  ASSERT_EQ(edge.size(), 4U);
  EXPECT_EQ(edge[0].at("presentationHint"), "invalid");
  EXPECT_EQ(edge[1].at("presentationHint"), "invalid");
  EXPECT_EQ(edge[2].at("address"), "0x0");
  EXPECT_EQ(edge[3].at("address"), "0x1");
  EXPECT_EQ(addresses(2), "0x105 ");
  EXPECT_EQ(answer("disassemble", 3).at("body").at("instructions").size(), 2U);
}

// The source changes before it is launched again: breakpoints of lines and names move, those that the client has not sent again
// stay,
// and the machine is new.
TEST_F(DapSteps, RestartsWithItsBreakpoints) {
  request("initialize");
  request("launch");
  request("setBreakpoints", {{"source", {{"path", "p.s"}}}, {"breakpoints", {{{"line", 8}}}}});
  request("setFunctionBreakpoints", {{"breakpoints", {{{"name", "gone"}, {"hitCondition", "1"}}}}});
  request("configurationDone");  // runs to line 8
  look();
  request("restart");
  look();
  request("continue");
  look();
  request("restart", {{"arguments", {{"stopOnEntry", true}}}});
  look();
  request("disconnect");
  int launches = 0;
  hold_with([&launches](const json&) {
    const std::string head = launches++ == 0 ? "100/\n" : "300/\n";
    const std::string gone = launches == 1 ? "gone, 0\n" : "0\n";
    return launch_pdp7(head + "begin, lac (3\n jms store\n lac (5\n jms store\n hlt\nstore, 0\n dac place\n jmp i store\nplace, 0\n" + gone +
                             " start begin\n",
                         launches == 1 ? "100" : "300");
  });
  EXPECT_EQ(launches, 3);
  EXPECT_EQ(answer("initialize").at("body").at("supportsRestartRequest"), true);
  EXPECT_EQ(registers(0, {"PC", "AC", "time"}), "PC=00106 AC=000003 time=0.000007000 s");
  EXPECT_EQ(registers(1, {"PC", "AC", "time"}), "PC=00306 AC=000003 time=0.000007000 s");
  EXPECT_EQ(registers(2, {"PC", "AC"}), "PC=00306 AC=000005");
  EXPECT_EQ(registers(3, {"PC", "AC"}), "PC=00300 AC=000000");
  std::string reasons;
  for (const json& body : events("stopped")) reasons += body.at("reason").get<std::string>() + " ";
  EXPECT_EQ(reasons, "breakpoint breakpoint breakpoint entry ");
  const auto changes = events("breakpoint");
  ASSERT_GE(changes.size(), 2U);
  EXPECT_EQ(changes[0].at("breakpoint").at("instructionReference"), "0xC6");
  EXPECT_EQ(changes[0].at("breakpoint").at("line"), 8);
  EXPECT_EQ(changes[1].at("breakpoint").at("verified"), false);
}

TEST_F(DapSteps, RestartOfABrokenSourceLeavesTheMachine) {
  request("initialize");
  request("launch");
  request("restart");
  look();
  request("disconnect");
  int launches = 0;
  hold_with([&launches](const json&) -> base::Result<live::Launched> {
    if (launches++ != 0) return base::bad_input("p.s: the source has errors");
    return launch_pdp7("100/\nbegin, hlt\n start begin\n");
  });
  EXPECT_EQ(answer("restart").at("success"), false);
  EXPECT_EQ(answer("restart").at("message"), "p.s: the source has errors");
  EXPECT_EQ(registers(0, {"PC"}), "PC=00100");
}

// The console evaluates an expression; any other text is a monitor command.
TEST_F(DapSteps, TheConsoleTakesTheVerbsOfTheMonitor) {
  const auto typed = [this](const std::string& line) { request("evaluate", {{"expression", line}, {"context", "repl"}}); };
  request("initialize", {{"supportsInvalidatedEvent", true}, {"supportsMemoryEvent", true}});
  request("launch", {{"stopOnEntry", true}});
  request("setFunctionBreakpoints", {{"breakpoints", {{{"name", "place"}}}}});
  request("configurationDone");
  typed("step 2");       // 0: stops at store+1
  look();
  typed("e 104");        // 1
  typed("e");            // 2: not an expression of the PDP-7: all registers
  typed("ac+1");         // 3: an expression
  typed("delete");       // 4: the client is notified that its breakpoint is deleted
  typed("deposit 110 7");  // 5
  typed(":evaluate [110]");  // 6
  typed("back 2");       // 7
  look();
  typed("steep");        // 8: neither
  typed("assert ac==7");  // 9
  typed("run until pc==107");  // 10
  request("evaluate", {{"expression", "step"}, {"context", "watch"}});  // 11: in another context it is an expression
  typed("help back");    // 12
  typed("quit");         // 13
  request("completions", {{"text", "hist"}, {"column", 5}});
  request("disconnect");
  hold_with([](const json&) {
    return launch_pdp7("100/\nbegin, lac (3\n jms store\n lac (5\n jms store\n hlt\nstore, 0\n dac place\n jmp i store\nplace, 0\n start begin\n");
  });
  const auto result = [this](std::size_t n) {
    const json whole = answer("evaluate", n);
    return whole.at("success") == true ? whole.at("body").at("result").get<std::string>() : "! " + whole.at("message").get<std::string>();
  };
  EXPECT_EQ(registers(0, {"PC", "AC"}), "PC=00106 AC=000003");
  EXPECT_EQ(result(1), "00104 740040  begin+4: hlt");
  EXPECT_EQ(result(2).substr(0, 8), "PC 00106");
  EXPECT_EQ(result(3), "4 = 4.");
  ASSERT_EQ(events("breakpoint").size(), 1U);
  EXPECT_EQ(events("breakpoint")[0].at("reason"), "removed");
  EXPECT_EQ(result(6), "7 = 7.");
  EXPECT_EQ(registers(1, {"PC", "AC"}), "PC=00100 AC=000000");
  EXPECT_EQ(result(8).substr(0, 17), "! found \"steep\", ");
  EXPECT_EQ(result(9).substr(0, 26), "! assert: ac==7 is not tru");
  EXPECT_EQ(result(10).substr(0, 16), "pc==107\n00107 st");
  EXPECT_EQ(result(11).substr(0, 15), "! found \"step\",");
  EXPECT_EQ(result(12).substr(0, 8), "ba[ck] [");
  EXPECT_EQ(events("terminated").size(), 1U);
  EXPECT_FALSE(events("invalidated").empty());
  EXPECT_EQ(events("memory").at(0).at("count"), 8192 * 4);
  std::string reasons;
  for (const json& body : events("stopped")) reasons += body.at("reason").get<std::string>() + " ";
  EXPECT_EQ(reasons, "entry step step step ");
  EXPECT_EQ(answer("completions").at("body").at("targets").at(0).at("label"), "history");
}

// A line with a macro makes three instructions: stepping by lines executes all of them, stepping in the disassembly each.
TEST_F(DapSteps, StepsByLinesAndByInstructions) {
  request("initialize", {{"columnsStartAt1", false}});
  request("launch");
  request("setFunctionBreakpoints", {{"breakpoints", {{{"name", "begin"}}}}});
  request("configurationDone");
  request("next", {{"threadId", 1}, {"granularity", "statement"}});
  look();
  request("stepIn", {{"granularity", "instruction"}});
  look();
  request("stackTrace");
  request("next", {{"granularity", "line"}});  // the remaining two of the line
  look();
  request("next");  // JMP to itself: once
  look();
  request("disconnect");
  hold_with([](const json&) {
    return launch_i8080("\tORG 100H\nUP3:\tMACRO\n\tINX H\n\tINX H\n\tINX H\n\tENDM\n\tNOP\nBEGIN:\tNOP\n"
                          "\tREPT 1\n\tINR A ! INR A ! INR A\n\tENDM\nSELF:\tJMP SELF\n");
  });
  EXPECT_EQ(registers(0, {"PC"}), "PC=0102");
  EXPECT_EQ(registers(1, {"PC"}), "PC=0103");
  EXPECT_EQ(answer("stackTrace").at("body").at("stackFrames").at(0).at("column"), 0);
  EXPECT_EQ(registers(2, {"PC"}), "PC=0105");
  EXPECT_EQ(registers(3, {"PC"}), "PC=0105");
}

TEST_F(DapSteps, ExpressionsAreSetAndCompleted) {
  begin();
  request("setExpression", {{"expression", "AC"}, {"value", "17"}});
  request("setExpression", {{"expression", "[place]"}, {"value", "ac+1"}});
  request("setExpression", {{"expression", "place"}, {"value", "1"}});
  request("setExpression", {{"expression", "[place]"}, {"value", "1000000"}});
  request("evaluate", {{"expression", "[place]"}, {"context", "watch"}});
  request("completions", {{"text", "ac+pl"}, {"column", 6}});
  request("dataBreakpointInfo", {{"name", "time"}});
  request("variables", {{"variablesReference", 3}});
  request("disconnect");
  hold_with([](const json&) { return launch_pdp7("100/\nbegin, hlt\nplace, 5\nplan=7\n  start begin\n"); });
  EXPECT_EQ(answer("setExpression", 0).at("body").at("value"), "000017");
  EXPECT_EQ(answer("setExpression", 1).at("body").at("value"), "000020");
  EXPECT_EQ(answer("setExpression", 2).at("success"), false);
  EXPECT_EQ(answer("setExpression", 3).at("success"), false);
  EXPECT_EQ(answer("evaluate").at("body").at("result"), "20 = 16. = plan+11");
  std::string labels;
  const json targets = answer("completions").at("body").at("targets");
  for (const json& each : targets) labels += each.at("label").get<std::string>() + " ";
  EXPECT_EQ(labels, "place plan ");
  EXPECT_EQ(targets.at(0).at("start"), 3);
  EXPECT_EQ(targets.at(0).at("length"), 2);
  EXPECT_TRUE(answer("dataBreakpointInfo").at("body").at("dataId").is_null());
  const json devices = answer("variables").at("body").at("variables");
  EXPECT_FALSE(devices.empty());
  for (const json& each : devices) EXPECT_FALSE(each.contains("evaluateName"));
}

// The radix of `launch` applies to the values.
TEST_F(Dap, TheRadixIsAnOption) {
  write("p.s", "100/\nbegin, lac (12\n  hlt\n  start begin\n");
  request("initialize");
  request("launch", {{"machine", "pdp7"}, {"program", path("p.s").string()}, {"stopOnEntry", true}, {"options", {{"radix", 16}}}});
  request("configurationDone");
  request("evaluate", {{"expression", "begin+1"}});
  request("disconnect");
  hold();
  EXPECT_EQ(answer("evaluate").at("body").at("result"), "41 = 65. = begin+1");
}

// Without asAddress a name denotes a variable: [200] is the word at 200, whatever it contains; with asAddress its value is the address.
TEST_F(DapSteps, DataBreakpointsOnWordsInBrackets) {
  const std::vector<std::pair<json, json>> cases{
      {{{"name", "[200]"}}, "0x200"},
      {{{"name", "200"}}, "0x200"},
      {{{"name", " [ 1FF + 1 ] "}}, "0x200"},
      {{{"name", "[[200]]"}}, "0x7"},
      {{{"name", "[TABLE]"}}, "0x200"},
      {{{"name", "table+1"}}, "0x201"},
      {{{"name", "[hl]"}}, "0x0"},
      {{{"name", "[200]"}, {"asAddress", true}}, "0x7"},
      {{{"name", "b"}, {"asAddress", true}}, "0x0"},
      {{{"name", "0x200"}, {"asAddress", true}, {"bytes", 3}}, "0x200-0x202"},
      {{{"name", "[200]"}, {"bytes", 2}}, "0x200-0x201"},
      {{{"name", "0FFFF"}, {"asAddress", true}, {"bytes", 100}}, "0xFFFF"},
      {{{"name", "hl"}}, nullptr},
      {{{"name", "b"}}, nullptr},
      {{{"name", "[200"}}, nullptr},
      {{{"name", "[10000]"}}, nullptr},
      {{{"name", "[200]*[200]*10000"}}, nullptr},
      {{{"name", ""}}, nullptr}};
  request("initialize");
  request("launch", {{"stopOnEntry", true}});
  request("configurationDone");
  for (const auto& [arguments, id] : cases) request("dataBreakpointInfo", arguments);
  request("setDataBreakpoints", {{"breakpoints", {{{"dataId", "0x200"}, {"accessType", "write"}, {"hitCondition", ">=2"}},
                                                  {{"dataId", "0x300-0x302"}, {"accessType", "write"}},
                                                  {{"dataId", "0x300-0x2FF"}}, {{"dataId", "0x200-"}}, {{"dataId", "[200]"}}}}});
  request("continue");  // to the word 302
  look();
  request("continue");  // to the second write of TABLE
  look();
  request("disconnect");
  hold_with([](const json&) {
    return launch_i8080("\tORG 100H\n\tMVI A,9\n\tSTA 302H\n\tSTA 303H\n\tSTA TABLE\n\tINR A\n\tSTA TABLE\n\tHLT\n\tORG 200H\nTABLE:\tDB 7\n");
  });
  for (std::size_t n = 0; n < cases.size(); ++n) EXPECT_EQ(answer("dataBreakpointInfo", n).at("body").at("dataId"), cases[n].second) << cases[n].first;
  EXPECT_EQ(answer("dataBreakpointInfo", 0).at("body").at("description"), "word at 0200 TABLE");
  const json set = answer("setDataBreakpoints").at("body").at("breakpoints");
  EXPECT_EQ(set[0].at("verified"), true);
  EXPECT_EQ(set[1].at("verified"), true);
  for (std::size_t n = 2; n < 5; ++n) EXPECT_EQ(set[n].at("verified"), false) << n;
  EXPECT_EQ(registers(0, {"PC"}), "PC=0105");
  EXPECT_EQ(registers(1, {"PC"}), "PC=010F");
  EXPECT_EQ(answer("initialize").at("body").at("supportsDataBreakpointBytes"), true);
}

// The same text as the monitor's `evaluate`.
TEST_F(DapSteps, AHoverShowsAllFormsOfAValue) {
  request("initialize");
  request("launch", {{"stopOnEntry", true}});
  request("configurationDone");
  for (const char* const each : {"LOOP", "loop+3", "b", "0FEH", "loop-109", "[loop]", "0FFFF+1", "b b"})
    request("evaluate", {{"expression", each}, {"context", "hover"}});
  for (const char* const each : {"evaluate LOOP", "evaluate loop+3", "evaluate b"}) request("evaluate", {{"expression", each}, {"context", "repl"}});
  request("disconnect");
  hold_with([](const json&) { return launch_i8080("\tORG 100H\n\tDS 8\nLOOP:\tMVI B,10\n\tJMP LOOP\n"); });
  const std::vector<std::string> expected{"108 = 264. = LOOP", "10B = 267. = LOOP+3", "0 = 0.", "FE = 254. = -2. as a word with a sign",
                                          "FFFFFFFFFFFFFFFF = -1.", "6 = 6.", "10000 = 65536."};
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_EQ(answer("evaluate", n).at("body").at("result"), expected[n]);
  EXPECT_EQ(answer("evaluate", 0).at("body").at("memoryReference"), "0x108");
  EXPECT_EQ(answer("evaluate", 7).at("success"), false);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(answer("evaluate", 8 + n).at("body").at("result"), expected[n]);
}

// A loop that counts B from 1 to 5: the values of B at the stops.
TEST_F(DapSteps, HitConditionsAreComparedWithTheNumberOfMatches) {
  const auto stops = [this](const std::string& count) {
    script_.clear();
    sequence_ = 0;
    request("initialize");
    request("launch");
    request("setInstructionBreakpoints", {{"breakpoints", {{{"instructionReference", "0x103"}, {"hitCondition", count}}}}});
    request("configurationDone");
    for (int n = 0; n < 6; ++n) {
      look();
      request("continue");
    }
    request("disconnect");
    hold_with([](const json&) { return launch_i8080("\tORG 100H\n\tMVI B,0\nLOOP:\tINR B\n\tMOV A,B\n\tCPI 5\n\tJNZ LOOP\n\tHLT\n"); });
    const json set = answer("setInstructionBreakpoints").at("body").at("breakpoints").at(0);
    if (set.at("verified") == false) return set.at("message").get<std::string>();
    std::string found;
    std::size_t at = 0;
    for (const json& body : events("stopped")) {
      if (body.at("reason") != "breakpoint") break;
      const std::string b = registers(at++, {"B"});
      found += b.substr(b.size() - 1);
    }
    return found;
  };
  EXPECT_EQ(stops("1"), "12345");
  EXPECT_EQ(stops("2"), "24");
  EXPECT_EQ(stops("%2"), "24");
  EXPECT_EQ(stops("% 3"), "3");
  EXPECT_EQ(stops(">=3"), "345");
  EXPECT_EQ(stops(" > 3 "), "45");
  EXPECT_EQ(stops("<3"), "12");
  EXPECT_EQ(stops("<=3"), "123");
  EXPECT_EQ(stops("=4"), "4");
  EXPECT_EQ(stops("== 4"), "4");
  EXPECT_EQ(stops(">=0"), "12345");
  EXPECT_EQ(stops("%0"), "found count %0, expected 1 or more: the first time has number 1");
  EXPECT_EQ(stops("<1"), "found count <1, expected 2 or more: the first time has number 1");
  for (const char* const wrong : {"=>3", ">", "3x", "%2%", "-1", "0x3", "99999999999999999999"})
    EXPECT_NE(stops(wrong).find("expected a decimal count"), std::string::npos) << wrong;
}

TEST_F(DapSteps, LogpointsPrintAndDoNotStop) {
  request("initialize");
  request("launch");
  request("setBreakpoints", {{"source", {{"path", "p.asm"}}},
                             {"breakpoints", {{{"line", 4}, {"logMessage", "b={b} at {pc} {{loop}} {[1]/0}"}, {"hitCondition", "%2"}},
                                              {{"line", 5}, {"logMessage", "{b"}},
                                              {{"line", 5}, {"logMessage", "b}"}},
                                              {{"line", 5}, {"logMessage", "{nobody}"}},
                                              {{"line", 7}}}}});
  request("setDataBreakpoints", {{"breakpoints", {{{"dataId", "0x200"}, {"logMessage", "now {[200]}"}, {"condition", "[200]==3"}}}}});
  request("configurationDone");
  look();
  request("reverseContinue");
  look();
  request("disconnect");
  hold_with([](const json&) {
    return launch_i8080("\tORG 100H\n\tLXI H,200H\nLOOP:\tINR B\n\tMOV M,B\n\tMVI A,5\n\tCMP B ! JNZ LOOP\n\tNOP\n\tHLT\n");
  });
  EXPECT_EQ(answer("initialize").at("body").at("supportsLogPoints"), true);
  const json set = answer("setBreakpoints").at("body").at("breakpoints");
  EXPECT_EQ(set[0].at("verified"), true);
  EXPECT_EQ(set[1].at("message"), "found { alone, expected an expression in braces, such as {pc}; {{ and }} print a brace");
  EXPECT_EQ(set[2].at("verified"), false);
  EXPECT_NE(set[3].at("message").get<std::string>().find("found \"nobody\""), std::string::npos);
  std::string printed;
  for (const json& body : events("output"))
    if (body.at("category") == "console") printed += body.at("output").get<std::string>();
  const std::string division = " {loop} (found a division by 0, expected a divisor other than 0)\n";
  EXPECT_EQ(printed, "b=02 at 0104" + division + "now 03\n" + "b=04 at 0104" + division);
  EXPECT_EQ(registers(0, {"PC", "B"}), "B=05 PC=010B");
  // Back past the logpoints to the beginning.
  EXPECT_EQ(registers(1, {"PC", "B"}), "B=00 PC=0100");
}

TEST_F(DapSteps, ThePlacesOfASource) {
  request("initialize");
  request("launch", {{"stopOnEntry", true}});
  request("configurationDone");
  request("loadedSources");
  request("breakpointLocations", {{"source", {{"path", "p.s"}}}, {"line", 2}, {"endLine", 6}});
  request("breakpointLocations", {{"source", {{"path", "p.s"}}}, {"line", 4}});
  request("breakpointLocations", {{"source", {{"path", "other.s"}}}, {"line", 1}, {"endLine", 100}});
  request("gotoTargets", {{"source", {{"path", "p.s"}}}, {"line", 5}});
  request("gotoTargets", {{"source", {{"path", "p.s"}}}, {"line", 100}});
  // Numbers for which a sum would overflow.
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  request("breakpointLocations", {{"source", {{"path", "p.s"}}}, {"line", most}, {"endLine", most}});
  request("gotoTargets", {{"source", {{"path", "p.s"}}}, {"line", most}});
  request("readMemory", {{"memoryReference", "0x40"}, {"offset", most}, {"count", 1}});
  request("goto", {{"threadId", 1}, {"targetId", 0103}});
  look();
  request("next");
  look();
  request("goto", {{"threadId", 1}, {"targetId", -1}});
  request("goto", {{"threadId", 1}, {"targetId", 1000000}});
  request("goto", {{"threadId", 1}});
  request("stepBack");
  look();
  request("disconnect");
  hold_with([](const json&) { return launch_pdp7("100/\nbegin, lac (3\n  lac (4\n\n\n  lac (5\n  hlt\n  start begin\n"); });
  const json sources = answer("loadedSources").at("body").at("sources");
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].at("name"), "p.s");
  EXPECT_EQ(answer("breakpointLocations", 0).at("body").at("breakpoints"), json::array({{{"line", 2}}, {{"line", 3}}, {{"line", 6}}}));
  EXPECT_EQ(answer("breakpointLocations", 1).at("body").at("breakpoints"), json::array());
  EXPECT_EQ(answer("breakpointLocations", 2).at("body").at("breakpoints"), json::array());
  EXPECT_EQ(answer("breakpointLocations", 3).at("body").at("breakpoints"), json::array());
  EXPECT_FALSE(answer("readMemory").at("success"));
  const json target = answer("gotoTargets", 0).at("body").at("targets").at(0);
  EXPECT_EQ(target.at("line"), 6);
  EXPECT_EQ(target.at("id"), 0102);
  EXPECT_EQ(target.at("instructionPointerReference"), "0x42");
  EXPECT_EQ(answer("gotoTargets", 1).at("body").at("targets"), json::array());
  EXPECT_EQ(registers(0, {"PC", "AC"}), "PC=00103 AC=000000");
  for (std::size_t n = 1; n < 4; ++n) EXPECT_EQ(answer("goto", n).at("success"), false) << n;
  std::string reasons;
  for (const json& body : events("stopped")) reasons += body.at("reason").get<std::string>() + " ";
  EXPECT_EQ(reasons.substr(0, 11), "entry goto ");
}

// Lines with an address but without code are no places: ORG, labels alone, EQU and DS.
TEST_F(DapSteps, LinesWithoutCodeOfThe8080) {
  request("initialize");
  request("launch", {{"stopOnEntry", true}});
  request("configurationDone");
  request("stackTrace");
  request("breakpointLocations", {{"source", {{"path", "p.asm"}}}, {"line", 1}, {"endLine", 9}});
  request("setBreakpoints", {{"source", {{"path", "p.asm"}}}, {"breakpoints", {{{"line", 1}}, {{"line", 3}}, {{"line", 5}}, {{"line", 9}}}}});
  request("gotoTargets", {{"source", {{"path", "p.asm"}}}, {"line", 3}});
  request("disconnect");
  hold_with([](const json&) {
    return launch_i8080("\tORG 100H\nX:\nY\tEQU 7\nL:\tNOP\n\tDS 3\nM:\n\tNOP\nT:\tDB 1,2,3,4,5,6,7\n\tEND\n");
  });
  EXPECT_EQ(answer("stackTrace").at("body").at("stackFrames").at(0).at("line"), 4);
  EXPECT_EQ(answer("breakpointLocations").at("body").at("breakpoints"), json::array({{{"line", 4}}, {{"line", 7}}, {{"line", 8}}}));
  const json set = answer("setBreakpoints").at("body").at("breakpoints");
  EXPECT_EQ(set[0].at("instructionReference"), "0x100");
  EXPECT_EQ(set[1].at("line"), 4);
  EXPECT_EQ(set[2].at("line"), 7);
  EXPECT_EQ(set[2].at("instructionReference"), "0x104");
  EXPECT_EQ(set[3].at("verified"), false);
  EXPECT_EQ(answer("gotoTargets").at("body").at("targets").at(0).at("id"), 0x100);
}

// Bytes outside memory are not written, and bytes of a word that are not written keep their value.
TEST_F(DapSteps, WritesOfAFewBytes) {
  begin();
  request("writeMemory", {{"memoryReference", "0xFFFE"}, {"data", "AQIDBA=="}});
  request("readMemory", {{"memoryReference", "0xFFFE"}, {"count", 2}});
  request("writeMemory", {{"memoryReference", "0xFFFE"}, {"data", "AQIDBA=="}, {"allowPartial", true}});
  request("readMemory", {{"memoryReference", "0xFFFE"}, {"count", 4}});
  request("writeMemory", {{"memoryReference", "0x10000"}, {"data", "AQ=="}, {"allowPartial", true}});
  request("writeMemory", {{"memoryReference", "0x200"}, {"data", ""}});
  request("disconnect");
  hold_with([](const json&) { return launch_i8080("\tORG 100H\n\tHLT\n"); });
  EXPECT_EQ(answer("writeMemory", 0).at("message"), "found 4 bytes, expected at most 2: memory ends there; allowPartial writes these");
  EXPECT_EQ(answer("writeMemory", 1).at("body").at("bytesWritten"), 2);
  EXPECT_EQ(answer("readMemory", 1).at("body").at("data"), "AQI=");
  EXPECT_EQ(answer("readMemory", 1).at("body").at("unreadableBytes"), 2);
  EXPECT_EQ(answer("writeMemory", 2).at("success"), false);
  EXPECT_EQ(answer("writeMemory", 3).at("body").at("bytesWritten"), 0);
}

TEST_F(DapSteps, WritesOfAFewBytesOfAWord) {
  begin();
  request("writeMemory", {{"memoryReference", "0x81"}, {"offset", -3}, {"data", "/////w=="}});  // 4 bytes from byte 1 of 200
  request("evaluate", {{"expression", "[200]"}});
  request("evaluate", {{"expression", "[201]"}});
  request("evaluate", {{"expression", "[202]"}});
  request("readMemory", {{"memoryReference", "0x80"}, {"offset", 1}, {"count", 5}});
  request("writeMemory", {{"memoryReference", "0x1FFF"}, {"offset", 3}, {"data", "AAEC"}, {"allowPartial", true}});
  request("disconnect");
  hold_with([](const json&) { return launch_pdp7("100/\nbegin, hlt\n200/ 123456\n 654321\n  start begin\n"); });
  const auto result = [this](std::size_t n) { return answer("evaluate", n).at("body").at("result").get<std::string>().substr(0, 6); };
  EXPECT_EQ(result(0), "777456");  // 123456 is 00A72E in hexadecimal: the byte 2E stays
  EXPECT_EQ(result(1), "654377");  // 654321 is 0358D1: only its lowest byte becomes FF
  EXPECT_EQ(result(2), "0 = 0.");
  EXPECT_EQ(answer("readMemory").at("body").at("data"), "/wMA/1g=");
  EXPECT_EQ(answer("writeMemory", 1).at("body").at("bytesWritten"), 1);
}

// A .SYM file of MAC or LINK for a program without its source.
TEST_F(Dap, SymbolsOfASymFile) {
  write("p.hex", ":03010000C3080130\n:00000001FF\n");
  write("P.SYM", "0100 START\t0108 LOOP\r\n\x1A\x1A\x1A");
  write("BAD.SYM", "0100 START\r\n01X8 LOOP\r\n");
  request("initialize");
  request("launch", {{"machine", "i8080"}, {"program", path("p.hex").string()}, {"options", {{"symbols", path("BAD.SYM").string()}}}});
  request("launch", {{"machine", "i8080"}, {"program", path("p.hex").string()}, {"stopOnEntry", true}, {"options", {{"start", "100"}, {"symbols", path("P.SYM").string()}}}});
  request("configurationDone");
  request("evaluate", {{"expression", "loop"}, {"context", "hover"}});
  request("stackTrace");
  request("disconnect");
  hold();
  EXPECT_NE(answer("launch", 0).at("message").get<std::string>().find("BAD.SYM: line 2: found \"01X8 LOOP\", expected an address of four"), std::string::npos)
      << answer("launch", 0);
  EXPECT_EQ(answer("evaluate").at("body").at("result"), "108 = 264. = LOOP");
  EXPECT_EQ(answer("stackTrace").at("body").at("stackFrames").at(0).at("name"), "START");
}

// The system of disk_test.cpp, through messages.
TEST_F(DapSteps, ASystemBootsFromADisk) {
  request("initialize");
  request("launch", {{"input", "w5Zr5h"}});
  request("configurationDone");  // runs to the HLT of the command h
  look();
  request("disconnect");
  std::size_t changed = 0;
  hold_with([](const json&) {
    const auto assembly = assembled_file(disk_system_file("boot.s"));
    const auto tape = image::write_rim(assembly.image, "boot.rim");
    MachineRun of(machines::pdp7());
    of.set_file("--load", "boot.rim", {reinterpret_cast<const char*>(tape->data()), tape->size()});
    of.set_file("--disk", "disk", disk_system_image());
    return launch_run(machines::pdp7(), of, assembly, assembler::write_symbols(assembly.symbols), "7700");
  },
            [&changed](const machines::Machine& machine) -> base::Result<base::Done> {
              changed = machine.changed_media().size();
              return base::Done{};
            });
  std::string printed;
  for (const json& body : events("output"))
    if (body.at("category") == "stdout") printed += body.at("output").get<std::string>();
  EXPECT_EQ(printed, "*w5Zk\r\n*r5Z\r\n*h");
  EXPECT_EQ(events("stopped").at(0).at("text"), "stopped by halt");
  EXPECT_EQ(changed, 1U);
}

// --- Messages of any content ---

TEST_F(DapSteps, RequestsWithAnyContentAreAnswered) {
  std::mt19937 engine(1121);
  const auto below = [&engine](std::size_t n) { return engine() % n; };
  const std::vector<std::string> names{"setBreakpoints", "setFunctionBreakpoints", "setInstructionBreakpoints", "dataBreakpointInfo",
                                       "setDataBreakpoints", "next", "stepIn", "stepOut", "stepBack", "reverseContinue", "pause",
                                       "threads", "stackTrace", "scopes", "variables", "setVariable", "evaluate", "readMemory",
                                       "writeMemory", "disassemble", "setExpression", "completions", "nonsense", "launch", "configurationDone",
                                       "breakpointLocations", "loadedSources", "gotoTargets", "goto"};
  const std::vector<json> values{1, -1, 0, 1e300, "x", "0x40", "0xFFFFFFFFFFFF", nullptr, true, json::array({1, 2}), json::object(),
                                 9223372036854775807, "ac+", "AAAA", "====", json::array({json::object()}),
                                 json::array({{{"line", 3}, {"condition", "("}, {"hitCondition", "0"}}}),
                                 json::array({{{"line", 3}, {"logMessage", "{ac} {"}, {"hitCondition", ">=1"}}})};
  const std::vector<std::string> keys{"line", "source", "breakpoints", "name", "memoryReference", "offset", "count", "data", "expression",
                                      "variablesReference", "value", "instructionCount", "instructionOffset", "startFrame", "levels",
                                      "dataId", "accessType", "instructionReference", "context", "text", "column", "granularity",
                                      "allowPartial", "targetId", "endLine", "bytes", "asAddress"};
  begin();
  for (int round = 0; round < tests::effort(400, 100); ++round) {
    json arguments = json::object();
    for (std::size_t n = below(6); n > 0; --n) arguments[keys[below(keys.size())]] = values[below(values.size())];
    request(names[below(names.size())], below(8) == 0 ? values[below(values.size())] : arguments);
  }
  const int requests = sequence_;
  hold_with([](const json&) {
    auto session = launch_pdp7("100/\nbegin, isz 200\n  jmp begin\n  hlt\n200/ 777000\n  start begin\n");
    session.prepared.limits.instructions = 20000;  // the code after the HLT need not end
    return session;
  });
  int answers = 0;
  for (const json& message : received_) answers += message.at("type") == "response" ? 1 : 0;
  EXPECT_EQ(answers, requests);
}

// Sums with them must not overflow.
TEST_F(DapSteps, NumbersAtTheEndsOfTheirRange) {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t smallest = std::numeric_limits<std::int64_t>::min();
  request("initialize");
  request("launch", {{"stopOnEntry", true}});
  request("configurationDone");
  request("stepIn");
  request("stackTrace", {{"startFrame", 1}, {"levels", largest}});
  request("setBreakpoints", {{"source", {{"path", "p.asm"}}}, {"breakpoints", {{{"line", largest}}}}});
  request("readMemory", {{"memoryReference", "0x100"}, {"offset", largest}, {"count", 1}});
  request("readMemory", {{"memoryReference", "0x100"}, {"offset", smallest}, {"count", 1}});
  request("readMemory", {{"memoryReference", "0xFFFF"}, {"count", largest}});
  request("completions", {{"text", "a"}, {"column", smallest}});
  request("disconnect");
  hold_with([](const json&) { return launch_i8080("\tORG 100H\n\tCALL SUB\n\tHLT\nSUB:\tRET\n"); });
  EXPECT_EQ(answer("stackTrace").at("body").at("stackFrames").size(), 1U);  // of the caller
  EXPECT_EQ(answer("setBreakpoints").at("body").at("breakpoints").at(0).at("verified"), false);
  EXPECT_EQ(answer("readMemory", 0).at("success"), false);
  EXPECT_EQ(answer("readMemory", 1).at("success"), false);
  EXPECT_EQ(answer("readMemory", 2).at("body").at("data").get<std::string>().size(), 4U);  // one byte
  EXPECT_EQ(answer("completions").at("success"), true);
}

TEST_F(Dap, TheArgumentsOfLaunchAreChecked) {
  const auto refused = [this](json arguments) {
    script_.clear();
    sequence_ = 0;
    request("initialize");
    request("launch", std::move(arguments));
    request("threads");
    request("disconnect");
    hold();
    EXPECT_EQ(answer("launch").at("success"), false);
    EXPECT_EQ(answer("threads").at("message"), "found threads before launch, expected launch first");
    return answer("launch").value("message", std::string());
  };
  EXPECT_NE(refused({{"machine", "pdp8"}}).find("expected machine: pdp7 or i8080"), std::string::npos);
  EXPECT_NE(refused(json::object()).find("found no machine"), std::string::npos);
  EXPECT_NE(refused({{"machine", "pdp7"}, {"program", "none.rim"}}).find("none.rim"), std::string::npos);
  EXPECT_NE(refused({{"machine", "pdp7"}, {"options", {{"colour", 1}}}}).find("found option colour"), std::string::npos);
  EXPECT_NE(refused({{"machine", "pdp7"}, {"options", {{"memory", "7k"}}}}).find("none of its values"), std::string::npos);
  EXPECT_NE(refused({{"machine", "pdp7"}, {"options", {{"display", "yes"}}}}).find("expected true or false"), std::string::npos);
  EXPECT_NE(refused({{"machine", "pdp7"}, {"options", {{"do", "f"}}}}).find("which is for a terminal"), std::string::npos);
  EXPECT_NE(refused({{"machine", "pdp7"}, {"options", 5}}).find("expected an object"), std::string::npos);
  write("bad.s", "100/ nonsense\n");
  EXPECT_NE(refused({{"machine", "pdp7"}, {"program", "bad.s"}}).find("the source has errors"), std::string::npos);
}

// A signal ends the session of an endless program in order: the exit code says so, and no truncated message is sent.
TEST_F(Dap, ASignalEndsTheSession) {
  write("p.s", "100/\nbegin, jmp begin\n  start begin\n");
  request("initialize");
  request("launch", {{"machine", "pdp7"}, {"program", path("p.s").string()}});
  request("configurationDone");
  write("in", script_);
  const std::string command = "cd '" + path(".").string() + "' && { cat in; sleep 2; } | timeout --foreground -s TERM 1 '" +
                              command_of_this_build() + "' dap > out; echo $? > code";
  ASSERT_EQ(std::system(command.c_str()), 0);
  received_ = messages(read("out"));
  EXPECT_EQ(answer("launch").at("success"), true);
  // timeout exits with 124 after it has sent the signal.
  EXPECT_EQ(read("code"), "124\n");
}

TEST_F(Dap, AnInvalidMessageEndsTheSession) {
  const auto ends = [this](const std::string& bytes) {
    const Ran ran = sightline({"dap"}, bytes);
    EXPECT_EQ(ran.exit_code, 4) << bytes.substr(0, 40);
    return ran.err;
  };
  EXPECT_NE(ends("GET / HTTP/1.1\r\n\r\n").find("expected one in the headers"), std::string::npos);
  EXPECT_NE(ends("Content-Length: many\r\n\r\n").find("Content-Length"), std::string::npos);
  EXPECT_NE(ends("Content-Length: 99999999999\r\n\r\n").find("at most 16777216"), std::string::npos);
  EXPECT_NE(ends(frame_message("{")).find("message"), std::string::npos);
  EXPECT_NE(ends(frame_message("[1]")).find("expected an object as a message"), std::string::npos);
  EXPECT_NE(ends(std::string(5000, 'x')).find("without an empty line"), std::string::npos);
  // A client that disconnects is not an error.
  EXPECT_EQ(sightline({"dap"}, "").exit_code, 0);
  EXPECT_EQ(sightline({"dap"}, "Content-Length: 10\r\n\r\n{").exit_code, 0);
}

}  // namespace
}  // namespace sightline::test
