// CheckMemory: after any change of a text, the check that continues at a stored place finds what a check from the beginning finds.

#include "session/checklist/check_memory.h"

#include <cstdlib>
#include <random>

#include "session/a_session.h"
#include "session/checklist/program_check.h"

namespace kadr::check_memory_test {
namespace {

using test::shared_control;

/// Returns the findings of a check, all their members in words.
std::vector<std::string> findings(const std::string& id, const std::string& text, CheckMemory* memory) {
  std::shared_ptr<ByteSource> source = text_source(text);
  Program program{"main.nc", nullptr, Encoding::utf8};
  program.source = memory == nullptr ? text_source(text) : memory->follow(source);
  RunLimits limits;
  limits.restarts = 0;
  limits.repeated_blocks = 20'000;
  auto session = Session::open({shared_control(id), test::generic_machine(), {}, std::move(program), limits});
  std::vector<std::string> all;
  const auto take = [&](std::size_t, const AlarmReport& report) {
    std::string words = std::string(name_of(report.alarm.id)) + " " + std::to_string(report.origin.line) + ":" +
                        std::to_string(report.origin.column) + " " + std::to_string(report.alarm.where.begin) + "-" +
                        std::to_string(report.alarm.where.end) + " " + report.line_text;
    for (const AlarmReport::Call& call : report.calls) words += " <" + std::to_string(call.line);
    all.push_back(std::move(words));
    return true;
  };
  ProgramCheck({}, take).check(**session, memory);
  return all;
}

/// Lines for the middle of a program: what changes a mode, an offset, a cycle, the flow; and faults.
const std::vector<std::string>& lines_for(const std::string& id) {
  static const std::vector<std::string> common = {"G0 Z50.",
                                                  "G1 X999. F100",
                                                  "G2 X1. Y1. I5. J0",
                                                  "G41 D1",
                                                  "G40",
                                                  "S5000 M3",
                                                  "M5",
                                                  "G91",
                                                  "G90",
                                                  "G20",
                                                  "G21",
                                                  "G17",
                                                  "G18",
                                                  "X",
                                                  "(Ж 4 FLUTE)",
                                                  "G81 X3. Y3. Z-5. R2. F50",
                                                  "G80",
                                                  "G54",
                                                  "G55",
                                                  "T7 M6",
                                                  "N5",
                                                  "?",
                                                  "G1 Z-3.",
                                                  "/G1 X5.",
                                                  "M30",
                                                  "M8",
                                                  "M9",
                                                  ""};
  static const std::vector<std::string> fanuc = {"#101=5.", "G1 X#101",          "GOTO 5", "IF[#101GT3]GOTO 5", "M98 P200",      "O200",
                                                 "M99",     "WHILE[#101LT9]DO1", "END1",   "#101=#101+1",       "G10 L2 P1 X5.", "G52 X1."};
  static const std::vector<std::string> linuxcnc = {
      "#<a>=5",    "G1 X#<a>", "o1 while [#<a> lt 9]", "o1 endwhile", "#<a>=[#<a>+1]", "o2 sub",
      "o2 endsub", "o2 call",  "G10 L2 P1 X5",         "G92 X1",      "G92.1",         "G64 P0.1"};
  static const std::vector<std::string> sinumerik = {"R1=5",     "G1 X=R1", "GOTOF M1",           "M1:",    "IF R1>3 GOTOB M1",
                                                     "TRANS X5", "TRANS",   "CYCLE81(50,0,2,-5)", "REPEAT", "UNTIL R1>9",
                                                     "R1=R1+1"};
  static std::map<std::string, std::vector<std::string>> all;
  std::vector<std::string>& lines = all[id];
  if (lines.empty()) {
    lines = common;
    const auto& own = id == "linuxcnc" ? linuxcnc : id == "sinumerik" ? sinumerik : fanuc;
    lines.insert(lines.end(), own.begin(), own.end());
  }
  return lines;
}

class CheckMemoryOf : public testing::TestWithParam<const char*> {};

TEST_P(CheckMemoryOf, finds_what_a_check_from_the_beginning_finds) {
  const std::string id = GetParam();
  const char* const wanted = std::getenv("KADR_CHECK_CHANGES");
  const int changes = wanted == nullptr ? 24 : std::atoi(wanted);
  std::mt19937 choose(std::random_device::result_type(id.size()));
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(choose); };
  std::vector<std::string> lines = {"%", "O1", "G21 G90 G54 G17", "T1 M6", "G0 X50. Y0 S3000 M3"};
  if (id == "sinumerik") lines.erase(lines.begin(), lines.begin() + 2);
  if (id == "linuxcnc") lines.erase(lines.begin() + 1);
  for (std::size_t i = 0; i < 14'000; ++i)
    lines.push_back("N" + std::to_string(10 * i) + " G1 X" + std::to_string(i % 77) + "." + std::to_string(i % 10) + " Y" +
                    std::to_string(i % 59) + ".25 F" + std::to_string(800 + i % 7));
  lines.push_back("M30");
  if (id == "linuxcnc") lines.push_back("%");
  const auto text_of = [&] {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  };
  CheckMemory memory;
  (void)findings(id, text_of(), &memory);
  const std::vector<std::string> whole = lines;
  for (int n = 0; n < changes; ++n) {
    if (below(3) == 0) lines = whole;  // the user undoes the changes; otherwise soon an M30 would end each program early
    const std::size_t at = below(lines.size());
    const std::string& line = lines_for(id)[below(lines_for(id).size())];
    const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(4)) {
      case 0: lines.insert(place, line); break;
      case 1: lines.erase(place); break;
      default: *place = line; break;
    }
    const std::string text = text_of();
    ASSERT_EQ(findings(id, text, &memory), findings(id, text, nullptr)) << id << ", change " << n << ", line " << at + 1 << ": " << line;
  }
  EXPECT_GT(memory.continued(), 0U) << "no check has continued at a stored place";
  RecordProperty("continued", static_cast<int>(memory.continued()));
}

INSTANTIATE_TEST_SUITE_P(controls, CheckMemoryOf, testing::Values("fanuc", "linuxcnc", "nct", "grbl", "haas", "sinumerik", "s2c42"),
                         [](const auto& of) { return std::string(of.param); });

TEST(CheckMemory, continues_after_a_change_at_the_end) {
  std::string text = "G21 G90 F100\n";
  for (int i = 0; i < 30'000; ++i) text += "G1 X" + std::to_string(i % 77) + " Y" + std::to_string(i % 59) + "\n";
  CheckMemory memory;
  (void)findings("linuxcnc", text + "M2\n", &memory);
  EXPECT_EQ(memory.continued(), 0U);
  (void)findings("linuxcnc", text + "M30\n", &memory);
  EXPECT_EQ(memory.continued(), 1U);
  (void)findings("linuxcnc", "G20" + text.substr(3), &memory);
  EXPECT_EQ(memory.continued(), 1U) << "the first line has changed";
}

}  // namespace
}  // namespace kadr::check_memory_test
