// control/sinumerik/calculation and word_lines: compiled lines do the same as the general path of a block. A control that returns after
// each block compiles no line: it is the reference.

#include <random>

#include "control/run_program.h"

namespace kadr::sinumerik_calculation_test {
namespace {

struct Given {
  std::vector<std::string> actions;
  std::string alarms, ending;
  std::uint64_t blocks = 0;
  bool ended = false;
};

Given run_as(const std::string& program, bool each_block) {
  constexpr std::uint64_t most_repeated = 3000;
  constexpr int most_alarms = 30;
  int alarms = 0;
  Control control(test::control("sinumerik"), {}, Program{"p", text_source(program), {}}, RunLimits{most_repeated, 10});
  Given given;
  if (each_block) control.return_each_block();
  ActionBatch batch;
  for (;;) {
    const Control::State state = control.run(batch);
    for (const Action& action : batch)
      given.actions.push_back(test::exactly(action) + " " + std::to_string(action.origin.line) + " " +
                              std::to_string(action.origin.number) + " " + std::to_string(action.origin.depth));
    if (state == Control::State::ended) break;
    if (state != Control::State::stopped) continue;
    const AlarmReport& report = control.report();
    given.alarms +=
        std::string(name_of(report.alarm.id)) + " " + std::to_string(report.origin.line) + " " + std::to_string(report.alarm.where.begin);
    for (const AlarmReport::Call& call : report.calls) given.alarms += " " + std::to_string(call.line);
    given.alarms += "\n";
    if (++alarms > most_alarms) break;
    control.go_on();
  }
  given.ended = alarms <= most_alarms;
  given.ending = test::exactly(control.ending());
  given.blocks = control.blocks();
  return given;
}

class Writer {
 public:
  explicit Writer(std::mt19937& choose) : choose_(choose) {}

  std::string program() {
    text_ = "%_N_MAIN_MPF\n";
    if (below(2) == 0) text_ += "DEF INT II=2, JJ\nDEF REAL AA[4]\nDEF BOOL ON\nDEF STRING[8] TEXT=\"AB\"\n";
    text_ += "G90 F500\nFOR R9=1 TO 4\n";
    statements(10, 0);
    text_ += "ENDFOR\nM30\n%_N_PART_SPF\nPROC PART(REAL XX, INT YY)\n";
    if (below(3) == 0) text_ += "\nDEF REAL AA[4]\n";
    statements(4, 2);
    text_ += below(2) == 0 ? "M17\n" : below(2) == 0 ? "RET\n" : "";
    text_ += "%_N_REF_SPF\nPROC REF(VAR REAL XX)\nXX=XX+1\nM17\n%_N_BARE_SPF\n";
    statements(3, 2);
    return text_;
  }

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(choose_); }
  std::string any(std::initializer_list<const char*> of) { return of.begin()[below(of.size())]; }

  std::string value() {
    return any({"R1", "R2", "R[R3]", "II", "JJ", "AA[II]", "AA[1]", "XX", "YY", "3", "2.5", "0", "'HF'", "TRUE", "PI", "ON", "-R4"});
  }
  std::string expression() {
    switch (below(5)) {
      case 0: return value();
      case 1: return any({"SIN(", "SQRT(", "ABS(", "ROUND(", "TRUNC(", "POT(", "LN("}) + value() + ")";
      case 2: return "(" + value() + any({"+", "-", "*"}) + value() + ")*" + value();
      default: return value() + any({"+", "-", "*", "/", " DIV ", " MOD ", " B_AND "}) + value();
    }
  }
  std::string condition() { return value() + any({"<", ">", "==", "<>", "<=", ">="}) + value() + any({"", " AND R1<5", " OR NOT ON"}); }
  std::string target() { return any({"R1", "R2", "R3", "R4", "R[II]", "II", "JJ", "AA[R1]", "AA[2]", "ON", "XX"}); }

  void statements(std::size_t count, int depth) {
    for (std::size_t i = 0; i < count; ++i) statement(depth);
  }
  void statement(int depth) {
    switch (below(14)) {
      case 0:
        if (depth > 2) return;
        text_ += "IF " + condition() + "\n";
        statements(2, depth + 1);
        if (below(2) == 0) text_ += "ELSE\nR2=R2+1\n";
        text_ += "ENDIF\n";
        return;
      case 1:
        if (depth > 2) return;
        text_ += any({"WHILE R1<4", "REPEAT", "FOR II=1 TO 3", "FOR R5=R1 TO 3"}) + "\nR1=R1+1\n";
        {
          const bool repeats = text_.find("REPEAT\nR1", text_.size() - 16) != std::string::npos;
          const bool loop = text_.find("WHILE", text_.size() - 18) != std::string::npos;
          statements(2, depth + 1);
          text_ += repeats ? "UNTIL R1>3\n" : loop ? "ENDWHILE\n" : "ENDFOR\n";
        }
        return;
      case 2: text_ += "IF " + condition() + any({" GOTOF END", " GOTOB END", " GOTO END"}) + std::to_string(label_) + "\n"; return;
      case 3: text_ += "END" + std::to_string(label_++) + ": " + any({"", "R2=R2+1", "R1=0"}) + "\n"; return;
      case 4: text_ += "G1 X=" + expression() + any({"", " Y=IC(R1)", " Z=-R2"}) + any({"", " F=R4", " F300", " G91"}) + "\n"; return;
      case 5:
        text_ += any({"G1 X10\n", "X5 Y5\n", "\n", "; text\n", "STOPRE\n", "TRANS X=R1\n", "MSG(\"A\"<<R1)\n", "R1=1 R2=2\n"});
        return;
      case 6:
        if (depth > 1) return;
        text_ += any({"PART(R1,2)\n", "PART(R2+1,II)\n", "REF(R1)\n", "REF(AA[1])\n", "BARE\n", "PART\n", "PART(II,R1,R2)\n", "L77\n"});
        return;
      default: text_ += target() + "=" + expression() + any({"", "", "", " ; text"}) + "\n"; return;
    }
  }

  std::mt19937& choose_;
  std::string text_;
  int label_ = 0;
};

TEST(sinumerik_calculation, does_the_same_as_the_general_path) {
  std::mt19937 choose(20261130);
  std::size_t ended = 0;
  constexpr int programs = 3000;
  for (int i = 0; i < programs; ++i) {
    const std::string program = Writer(choose).program();
    const Given compiled = run_as(program, false), reference = run_as(program, true);
    ASSERT_EQ(compiled.alarms, reference.alarms) << program;
    ASSERT_EQ(compiled.ending, reference.ending) << program;
    ASSERT_EQ(compiled.actions, reference.actions) << program;
    ASSERT_EQ(compiled.blocks, reference.blocks) << program;
    ended += compiled.ended ? 1 : 0;
  }
  EXPECT_GT(ended, programs / 4);
}

}  // namespace
}  // namespace kadr::sinumerik_calculation_test
