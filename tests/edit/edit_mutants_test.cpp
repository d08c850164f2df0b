// edit/: the proof of an edit is put to the test. Each edited text is corrupted in one small place (a number by one in its last digit, a
// block dropped, doubled or exchanged with the next one, two words exchanged, a blank lost), and the proof must refuse it whenever the run
// shows another step. Whether it does is decided by the traces, which share nothing with the comparison of the proof.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "config/control/control_file.h"
#include "convert/open_states.h"
#include "convert/program_shape.h"
#include "edit/editing.h"
#include "lang/text/utf16.h"
#include "out/trace/trace.h"
#include "session/session.h"

namespace kadr::edit_mutants_test {
namespace {

constexpr const char* mill =
    "%\nO1\nN10 G21 G90 G17 G40 G49 G80 (PLATE)\nN20 T1 M6\nN30 S2000 M3\nN40 G54 G0 X-20. Y-20.\nN50 G43 H1 Z50. M8\nN60 G1 Z-5.25 F100.\n"
    "N70 G41 D1 X0 Y-10.\nN80 Y20. F250.\nN90 G2 X20. Y20. I10. J0\nN100 G1 X40.125\nN110 G9 Y0\nN120 G91 X-45.125\nN130 G90 G40 X-20. "
    "Y-20.\n"
    "N140 G0 Z50. M9\nN150 G4 P1500\nN160 T2 M6\nT3\nN170 S900 M4\nN180 G0 X5. Y5.\nN190 G43 H2 Z50.\nN200 G98 G81 X5. Y5. Z-5. R2. "
    "F80.\nN210 X15.\n"
    "N220 G80\nM1\nN230 T3 M6\nN240 S500 M3\nN250 G0 X1. Y2.\nN260 G43 H3 Z50.\nN270 G84 X5. Y5. Z-8. R3. F500.\nN280 G80\nN285 M21\n"
    "N290 G68 X10. Y20. R30.\nN300 G0 X30. Y5.\nN310 G69\nN320 G55 X7. Y7.\nN330 G53 Y-7. Z0\nN340 G91 G28 Z0\nN350 M30\n%\n";
constexpr const char* contour =
    "%\nO1\nG21 G90 G17 G40\nT1 M6\nS2000 M3 G54 G0 X-20. Y-20.\nG43 H1 Z-5.\nG41 D1 G1 X0 Y-10. F100.\nY20. F200.\nG2 X10. Y30. I10. J0\n"
    "G1 X40. F300. (TOP)\nX0 Y-10.\nG40 X-20. Y-20.\nG0 Z50.\nM30\n%\n";
constexpr const char* open_contour =
    "G21 G90 G54 G17\nS800 M3\nG0 X0 Y0\nG0 Z-1\nG1 X10 Y0 F60\nG3 X20 Y5 R20\nG0 Z5\n(MSG, turn the part)\nG0 X50 Y50\nM2\n";
constexpr const char* inches =
    "G20 G90 G54 G17\nS800 M3\nG0 X0 Y0 Z0.5\nG1 Z-0.1 F10\nX1.5\nG2 X2.5 Y1 I0 J1\nG64 P0.002\nG1 X3 Y3\nG4 P0.5\nM2\n";
constexpr const char* turned =
    "N10 T0101\nN20 G50 S2500\nN30 G96 S200 M3\nN40 G0 X60. Z2. M8\nN50 G1 X50. Z0 F0.2\nN60 Z-20. F0.15\nN70 G2 X60. Z-25. R5.\nN80 G0 "
    "X80. Z5.\n"
    "N90 T0202\nN100 G97 S500 M3\nN110 G0 X30. Z5.\nN120 G92 X29. Z-20. F1.5\nN130 X28.5\nN140 G0 X100. Z50.\nN150 M30\n";
constexpr const char* counted =
    "%\nN001 G90 ПС\nN002 G00 X+10000 Y+5000 ПС\nN003 G01 X+20000 F0100 ПС\nN004 Y+25000 F0150 ПС\nN005 M02 ПС\n";

struct Case {
  const char* control;
  const char* text;
  std::vector<std::pair<const char*, const char*>> edits;  // as an option of kadr edit and its word
  char digit = 1;  // by how much the last digit of a number is changed: more where the edit itself rounds it
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"fanuc", mill, {{"renumber", "5"}}},
      {"fanuc", mill, {{"strip", "comments"}, {"strip", "spaces"}}},
      {"fanuc", mill, {{"strip", "numbers"}}},
      {"fanuc", mill, {{"feed", "80%"}}},
      {"fanuc", mill, {{"feed", "T1=85%"}}},
      {"fanuc", mill, {{"speed", "80%"}}},
      {"fanuc", mill, {{"replace-tool", "2=7"}}},
      {"fanuc", mill, {{"replace-zero", "G54=G56"}}},
      {"fanuc", mill, {{"shift", "X2.25"}, {"shift", "Z-1"}}},
      {"fanuc", mill, {{"mirror", "X=3"}}},
      {"fanuc", mill, {{"mirror", "Y"}}},
      {"fanuc", mill, {{"rotate", "90@5,5"}}},
      {"fanuc", contour, {{"rotate", "30"}}, 4},
      {"linuxcnc", open_contour, {{"copy", "2x1:100,5"}, {"lines", "3-7"}}},
      {"fanuc", contour, {{"reverse", "7-12"}}},
      {"linuxcnc", open_contour, {{"reverse", "5-6"}}},
      {"linuxcnc", open_contour, {{"copy", "3@120"}, {"lines", "3-7"}}},
      {"linuxcnc", open_contour, {{"add", "spaces"}}},
      {"linuxcnc", inches, {{"feed", "90%"}}},
      {"linuxcnc", inches, {{"mirror", "X=25.4"}}},
      {"fanuc-t", turned, {{"feed", "50%"}}},
      {"fanuc-t", turned, {{"speed", "75%"}}},
      {"fanuc-t", turned, {{"replace-tool", "1=5"}}},
      {"s2c42", counted, {{"renumber", "5"}}},
      {"s2c42", counted, {{"mirror", "X"}}},
  };
  return all;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end == std::string::npos ? text.size() : end + 1;
  }
  return lines;
}

/// Runs programs of one control.
class Runner {
 public:
  explicit Runner(const std::string& control) : def_(std::make_shared<const ControlDef>(load_control(control).value())) {}

  const ControlDef& def() const { return *def_; }
  tl::expected<std::unique_ptr<Session>, std::string> open(std::shared_ptr<ByteSource> text, const Setup& setup) const {
    static const MachineProfile machine = load_machine("generic").value();
    auto session = Session::open({def_, machine, setup, {"edit_mutants_test", shared_source(std::move(text)), Encoding::utf8}, {}});
    if (!session) return tl::unexpected(session.error().fault.en);
    return std::move(*session);
  }

  /// Returns the trace of a run, without the places of the blocks, without motions that lead nowhere, and without switches that switch
  /// nothing: a block that states again what is in force changes nothing.
  std::string trace(const std::string& text, const Setup& setup) const {
    auto session = open(text_source(text), setup);
    EXPECT_TRUE(session) << session.error();
    char* bytes = nullptr;
    std::size_t size = 0;
    std::FILE* const file = open_memstream(&bytes, &size);
    std::string alarm;
    {
      TraceWriter writer(file, (*session)->control().axes(), 0);
      (*session)->outlets().step = [&](const Step& step) {
        const Motion* const motion = step.motion();
        const bool is_line = motion != nullptr && !motion->detail && !is_arc(motion->kind) && motion->kind != MotionKind::spline;
        if (!is_line || motion->machine != step.from.machine) writer.write(step);
      };
      (*session)->outlets().warning = [](const AlarmReport&) {};
      (*session)->outlets().alarm = [&](const AlarmReport& report) { return alarm = name_of(report.alarm.id), false; };
      while ((*session)->go_on() == Session::State::running) {
      }
      writer.flush();
    }
    std::fclose(file);
    std::string made = without_repeats(without_places(std::string(bytes, size))) + alarm;
    std::free(bytes);
    return made;
  }

 private:
  /// Removes the fields `block`, `line` and `col` of each line.
  static std::string without_places(std::string trace) {
    for (const std::string_view field : {R"("block":)", R"("line":)", R"("col":)"})
      for (std::size_t at = trace.find(field); at != std::string::npos; at = trace.find(field, at))
        trace.erase(at, trace.find_first_of(",}", at) + 1 - at);
    return trace;
  }

  /// Removes the lines of switches that are the same as the last one of their kind.
  static std::string without_repeats(const std::string& trace) {
    std::string made;
    std::map<std::string, std::string> last;
    for (const std::string& line : lines_of(trace)) {
      const std::string kind = line.substr(0, line.find(','));
      const bool is_switch = kind == R"({"do":"spindle")" || kind == R"({"do":"speed")" || kind == R"({"do":"coolant")";
      if (is_switch && last[kind] == line) continue;
      if (is_switch) last[kind] = line;
      made += line + "\n";
    }
    return made;
  }

  std::shared_ptr<const ControlDef> def_;
};

const Runner& runner(const std::string& control) {
  static std::map<std::string, std::unique_ptr<Runner>> known;
  std::unique_ptr<Runner>& one = known[control];
  if (!one) one = std::make_unique<Runner>(control);
  return *one;
}

EditSpec spec_of(const Case& one) {
  const Runner& of = runner(one.control);
  EditSpec spec;
  const std::string text = one.text;
  spec.source_text = text_source(text);
  spec.old_program = [&of, text](const Setup& setup) { return of.open(text_source(text), setup); };
  spec.new_program = [&of](std::shared_ptr<ByteSource> made, const Setup& setup) { return of.open(std::move(made), setup); };
  for (const auto& [name, word] : one.edits) EXPECT_TRUE(add_edit(spec.edits, name, word)) << name << ' ' << word;
  return spec;
}

std::string whole(ByteSource& source) {
  std::string text;
  (void)each_piece(source, [&text](std::string_view piece) { return text += piece, true; });
  return text;
}

/// Returns what a comparison found.
std::string said(const Comparison& found) {
  std::string text;
  for (const CourseDifference& d : found.differences)
    text += fmt::format("line {}: {} '{}' '{}' {:g}\n", d.a.origin.line, int(d.kind), d.a_value, d.b_value, d.distance);
  if (found.stopped_b) text += fmt::format("line {}: {}\n", found.stopped_b->origin.line, name_of(found.stopped_b->alarm.id));
  return text;
}

struct Mutant {
  std::string what, text;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The words of a line outside comments: where each begins and ends.
std::vector<std::pair<std::size_t, std::size_t>> words_of(const std::string& line) {
  std::vector<std::pair<std::size_t, std::size_t>> words;
  const std::size_t code = std::min(line.find('('), line.size());
  for (std::size_t i = 0; i < code; ++i) {
    if (line[i] < 'A' || line[i] > 'Z') continue;
    std::size_t end = i + 1;
    while (end < code && (is_digit(line[end]) || line[end] == '.' || line[end] == '-' || line[end] == '+')) ++end;
    if (end > i + 1) words.emplace_back(i, end);
  }
  return words;
}

std::vector<Mutant> mutants_of(const std::string& text, char digit) {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<Mutant> all;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string& line = lines[k];
    const auto add = [&](const std::string& what, const std::vector<std::string>& instead, std::size_t takes = 1) {
      std::string made;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > k && i < k + takes) continue;
        if (i != k) made += lines[i] + "\n";
        for (std::size_t j = 0; i == k && j < instead.size(); ++j) made += instead[j] + "\n";
      }
      all.push_back({fmt::format("line {}, {}: {}", k + 1, what, fmt::join(instead, " | ")), made});
    };
    add("dropped", {});
    add("doubled", {line, line});
    if (k + 1 < lines.size()) add("exchanged", {lines[k + 1], line}, 2);
    const auto words = words_of(line);
    for (std::size_t w = 0; w < words.size(); ++w) {
      const auto [begin, end] = words[w];
      std::size_t last = end - 1;
      while (!is_digit(line[last])) --last;
      std::string up = line, down = line;
      if (up[last] + digit <= '9') up[last] = char(up[last] + digit), add("a digit more", {up});
      if (down[last] - digit >= '0') down[last] = char(down[last] - digit), add("a digit less", {down});
      if (line[begin + 1] == '-') add("a sign lost", {line.substr(0, begin + 1) + line.substr(begin + 2)});
      add("a word lost", {line.substr(0, begin) + line.substr(end)});
      if (w + 1 == words.size()) continue;
      const auto [next, next_end] = words[w + 1];
      add("letters exchanged",
          {line.substr(0, begin) + line[next] + line.substr(begin + 1, next - begin - 1) + line[begin] + line.substr(next + 1)});
      add("words exchanged", {line.substr(0, begin) + line.substr(next, next_end - next) + line.substr(end, next - end) +
                              line.substr(begin, end - begin) + line.substr(next_end)});
    }
  }
  return all;
}

/// Every how many mutants one is tried; the environment variable KADR_EVERY_MUTANT overrides it.
std::size_t share() {
  const char* const stated = std::getenv("KADR_EVERY_MUTANT");
  return stated == nullptr ? 19 : std::max<std::size_t>(std::strtoul(stated, nullptr, 10), 1);
}

class EditMutants : public testing::TestWithParam<std::size_t> {};

TEST_P(EditMutants, TheProofRefusesEveryTextThatDoesSomethingElse) {
  const Case& one = cases()[GetParam()];
  const Runner& of = runner(one.control);
  EditSpec spec = spec_of(one);
  const auto made = edited(spec, {text_source(one.text), Encoding::utf8, &of.def()});
  ASSERT_TRUE(made) << made.error().line << ": " << made.error().why;
  ASSERT_TRUE(made->proof.is_proven()) << said(made->proof.comparison) << whole(*made->text);
  spec.edits.pieces = made->pieces;
  const std::string text = whole(*made->text);
  auto session = of.open(text_source(text), {});
  const auto names = ProgramShape(text_source(text), of.def(), {}).names();
  const kadr::Setup filled = open_states({}, of.def(), of.def(), (*session)->control().axes(), names, 1).front().setup;
  const std::string right = of.trace(text, filled), right_empty = of.trace(text, {});
  std::size_t tried = 0, equal = 0;
  std::vector<std::string> survivors;
  const std::vector<Mutant> mutants = mutants_of(text, one.digit);
  for (std::size_t i = 0; i < mutants.size(); i += share()) {
    const bool is_equal = of.trace(mutants[i].text, filled) == right && of.trace(mutants[i].text, {}) == right_empty;
    const auto proof = prove_edit(spec, text_source(mutants[i].text));
    ASSERT_TRUE(proof) << proof.error();
    ++tried, equal += is_equal;
    if (!is_equal && proof->is_proven()) survivors.push_back(mutants[i].what);
  }
  RecordProperty("tried", int(tried));
  RecordProperty("equal", int(equal));
  EXPECT_GT(tried, equal);
  EXPECT_TRUE(survivors.empty()) << survivors.size() << " of " << tried << " (" << equal << " do the same):\n"
                                 << fmt::format("{}", fmt::join(survivors, "\n"));
}

INSTANTIATE_TEST_SUITE_P(Edits, EditMutants, testing::Range<std::size_t>(0, 25));

}  // namespace
}  // namespace kadr::edit_mutants_test
