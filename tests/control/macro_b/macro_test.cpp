// control/macro_b: executes custom macros (spec/nct/23): programs compared with a slow reference, loops with their unrolled bodies,
// calls with the same code inline, arguments with the manual's table, and each program with other spellings and units of it.

#include <set>

#include "control/run_program.h"
#include "macro_trees.h"

namespace kadr::macro_test {
namespace {

using namespace test;

constexpr int variables = 9;            // the program uses #1 … #9; #20 … count loops
constexpr double same_distance = 1e-9;  // mm

// ---- programs as trees

struct Step;
using Steps = std::vector<Step>;

struct Step {
  enum class Kind { assign, move, unless, loop, leave } kind = Kind::assign;
  int target = 1;        // assign: target #; loop: number of passes
  Tree value;            // assign, move: the value of #target, of X
  Tree left, right;      // unless, leave: IF[left relation right]GOTO after the body, or out of the loop
  std::string relation;  // … assign: "" or IF[…]THEN
  Steps body;
};

Tree plain_number(const std::string& text) {
  Tree t;
  t.text = text;
  return t;
}

/// Bounds the value of the tree, so that X stays within its range.
Tree within_reach(Tree tree) {
  Tree bounded;
  bounded.kind = Tree::Kind::pair;
  bounded.text = "MOD";
  bounded.parts = {std::move(tree), plain_number("100")};
  return bounded;
}

Steps random_steps(Choices& choose, int depth, bool in_loop) {
  Steps steps;
  for (std::size_t n = 1 + choose.below(4); n > 0; --n) {
    Step step;
    const std::size_t kind = choose.below(depth == 0 ? 3 : 6);
    step.left = random_tree(choose, 1, variables);
    step.right = random_tree(choose, 1, variables);
    if (kind < 2 || kind == 5) {
      step.kind = Step::Kind::assign;
      step.target = choose.between(1, variables);
      step.value = random_tree(choose, 2, variables);
      if (kind == 5 || choose.one_in(3)) step.relation = choose.of(tree_relations);
    } else if (kind == 2) {
      step.kind = Step::Kind::move;
      step.value = within_reach(random_tree(choose, 2, variables));
    } else {
      step.kind = kind == 3 ? Step::Kind::loop : Step::Kind::unless;
      step.relation = choose.of(tree_relations);
      step.target = choose.between(0, 3);
      step.body = random_steps(choose, depth - 1, in_loop || kind == 3);
    }
    steps.push_back(step);
    if (in_loop && choose.one_in(8)) {
      step = Step();
      step.kind = Step::Kind::leave;
      step.relation = choose.of(tree_relations);
      step.left = random_tree(choose, 1, variables);
      step.right = random_tree(choose, 1, variables);
      steps.push_back(step);
    }
  }
  return steps;
}

/// Prints steps as a program. Loops are nested at most three deep; `depth` is the current level.
class ProgramPrinter {
 public:
  ProgramPrinter(Choices& choose, bool plain, bool unrolled = false, std::string scale = "")
      : print_(choose, plain), unrolled_(unrolled), scale_(std::move(scale)) {}

  std::string operator()(const Steps& steps) {
    text_.clear();
    all(steps, 0, 0);
    return text_;
  }

 private:
  std::string condition(const Step& step) { return "[" + print_(step.left) + " " + step.relation + " " + print_(step.right) + "]"; }

  void all(const Steps& steps, int loops, int exit_label) {
    for (const Step& step : steps) one(step, loops, exit_label);
  }

  void one(const Step& step, int loops, int exit_label) {
    switch (step.kind) {
      case Step::Kind::assign:
        text_ += (step.relation.empty() ? "" : "IF" + condition(step) + "THEN") + "#" + std::to_string(step.target) + "=" +
                 print_(step.value) + "\n";
        return;
      case Step::Kind::move:
        text_ += "G1 X" + (scale_.empty() ? "[" + print_(step.value) + "]" : "[[" + print_(step.value) + "]" + scale_ + "]") + " F[100" +
                 scale_ + "]\n";
        return;
      case Step::Kind::leave: text_ += "IF" + condition(step) + "GOTO" + std::to_string(exit_label) + "\n"; return;
      case Step::Kind::unless: {
        const int label = ++labels_;
        text_ += "IF" + condition(step) + "GOTO" + std::to_string(label) + "\n";
        all(step.body, loops, exit_label);
        text_ += "N" + std::to_string(label) + "G90\n";
        return;
      }
      case Step::Kind::loop: loop(step, loops + 1); return;
    }
  }

  void loop(const Step& step, int depth) {
    const int exit_label = ++labels_;
    const std::string count = "#" + std::to_string(20 + depth), number = std::to_string(depth);
    text_ += count + "=0\n";
    if (unrolled_) {
      for (int pass = 0; pass < step.target; ++pass) {
        all(step.body, depth, exit_label);
        text_ += count + "=" + count + "+1\n";
      }
    } else {
      text_ += "WHILE[" + count + "LT" + std::to_string(step.target) + "]DO" + number + "\n";
      all(step.body, depth, exit_label);
      text_ += count + "=" + count + "+1\nEND" + number + "\n";
    }
    text_ += "N" + std::to_string(exit_label) + "G90\n";
  }

  TreePrinter print_;
  bool unrolled_;
  std::string scale_;
  std::string text_;
  int labels_ = 100;
};

/// Evaluates the steps directly, without their text.
class Twin {
 public:
  std::vector<double> values = std::vector<double>(variables + 1, no_value());  // #1 … #9
  std::vector<double> ends;                                                     // X of each motion that changes it
  std::optional<AlarmId> alarm;
  bool unknown = false;  // the program read a system variable, which the reference does not have

  enum class Next { on, left, stopped };

  Next run(const Steps& steps) {
    for (const Step& step : steps)
      if (const Next next = run(step); next != Next::on) return next;
    return Next::on;
  }

 private:
  TreeValue read(double n) {
    if (is_empty(n)) return AlarmId::variable_unknown;
    const double nearest = std::round(n);
    if (nearest < 0 || std::fabs(n - nearest) > 1e-6) return AlarmId::variable_unknown;
    if (std::fabs(n - nearest) > 0) unknown = true;  // the reference does not decide how close to a whole number counts as whole
    if (nearest > 20 && nearest <= 33) unknown = true;
    if (nearest <= 33) return nearest == 0 || nearest > variables ? no_value() : values[static_cast<std::size_t>(nearest)];
    if (nearest >= 100 && nearest <= 999) return no_value();
    if (nearest >= 1000) unknown = true;
    return AlarmId::variable_unknown;
  }

  std::optional<double> value(const Tree& tree) {
    const TreeValue v = value_of(tree, [this](double n) { return read(n); });
    if (v.index() == 0) return std::get<0>(v);
    alarm = std::get<1>(v);
    return std::nullopt;
  }

  /// Returns whether the condition is true; nullopt if it raises an alarm.
  std::optional<bool> condition(const Step& step) {
    if (step.relation.empty()) return true;
    const auto left = value(step.left);
    if (!left) return std::nullopt;
    const auto right = value(step.right);
    if (!right) return std::nullopt;
    return test::holds(step.relation, *left, *right);
  }

  Next run(const Step& step) {
    if (step.kind == Step::Kind::loop) {
      for (int pass = 0; pass < step.target; ++pass) {
        const Next next = run(step.body);
        if (next == Next::stopped) return next;
        if (next == Next::left) break;
      }
      return Next::on;
    }
    if (step.kind != Step::Kind::move) {
      const auto holds = condition(step);
      if (!holds) return Next::stopped;
      if (step.kind == Step::Kind::leave) return *holds ? Next::left : Next::on;
      if (step.kind == Step::Kind::unless) return *holds ? Next::on : run(step.body);
      if (!*holds) return Next::on;
    }
    const auto v = value(step.value);
    if (!v) return Next::stopped;
    if (step.kind == Step::Kind::assign) values[static_cast<std::size_t>(step.target)] = *v;
    else if (*v != (ends.empty() ? 0.0 : ends.back())) ends.push_back(*v);
    return Next::on;
  }
};

/// Returns X of each motion that changes the position.
std::vector<double> ends_of(const Run& r) {
  std::vector<double> ends;
  for (const Motion& m : r.motions())
    if (m.to[0] != (ends.empty() ? 0.0 : ends.back())) ends.push_back(m.to[0]);
  return ends;
}

double variable_of(const FinalState& e, int n) {
  for (const auto& [name, value] : e.variables)
    if (name == "#" + std::to_string(n)) return value;
  return no_value();
}

RC_GTEST_PROP(macro_programs, do_what_the_twin_does, ()) {
  Choices choose = choices(400);
  const Steps steps = random_steps(choose, 3, false);
  const std::string text = ProgramPrinter(choose, choose.one_in(3))(steps);
  Twin twin;
  twin.run(steps);
  RC_PRE(!twin.unknown);
  RC_TAG(twin.alarm.has_value());
  const auto r = run("nct", text);
  const std::string expected = twin.alarm ? std::string(name_of(*twin.alarm)) : "";
  if (r.first_alarm() != expected) RC_FAIL(text + "gave '" + r.first_alarm() + "', not '" + expected + "'");
  for (int n = 1; n <= variables; ++n)
    if (!same_value(variable_of(r.ending, n), twin.values[static_cast<std::size_t>(n)]))
      RC_FAIL(text + "#" + std::to_string(n) + ": " + value_text(variable_of(r.ending, n)) + ", not " +
              value_text(twin.values[static_cast<std::size_t>(n)]));
  if (ends_of(r) != twin.ends) RC_FAIL(text + "goes elsewhere");
}

// ---- blocks that are kept for a loop stay the same blocks

RC_GTEST_PROP(macro_programs, in_a_loop_do_what_they_do_unrolled, ()) {
  Choices choose = choices(400);
  const Steps steps = random_steps(choose, 3, false);
  const std::string looped = ProgramPrinter(choose, true)(steps);
  const std::string unrolled = ProgramPrinter(choose, true, true)(steps);
  const auto a = run("nct", looped), b = run("nct", unrolled);
  if (a.first_alarm() != b.first_alarm()) RC_FAIL(looped + "gave '" + a.first_alarm() + "', unrolled '" + b.first_alarm() + "'");
  if (exactly(a.actions) != exactly(b.actions)) RC_FAIL(looped + "does something else unrolled");
  if (exactly(a.ending) != exactly(b.ending)) RC_FAIL(looped + "ends differently unrolled");
}

/// Words of all types, some of them vacant now and then, in repeated passes.
TEST(macro_blocks, in_a_loop_do_what_they_do_unrolled) {
  const char* bodies[] = {
      "G#2 X#1 Y-#3 Z[#1*2] F#4",
      "G91 X#3 AX[#1+1]=#1 M#5",
      "IF[#1EQ2]THEN#3=#0\nG90 G1 X#1 Y#3 S#6 M3",
      "G54 X#1\nG55 X#3\nG17 G2 X[#1*10] Y0 R50\nG1 X0",
      "G65 P300 A#1 B#3 I#2",
      "M98 P300 L2",
      "G66 P300 A#3\nX#1\nG67",
      "G10 L2 P#1 X#1\nG54 X1\nG55 X2",
      "T#1 M6 G43 H#1 Z#2",
      "G16 X#1 Y[#1*30]\nG15",
      "G#7 X#1 P#8",
      "G4 P#3\nG4 P#1",
  };
  const std::string head = "F100 G1 X1\n#2=1\n#3=1\n#4=200\n#5=8\n#6=700\n#7=0\n#8=#0\n#1=0\n";
  const std::string tail = "M30\nO300\n#100=#100+#1\nG91 Y#1 Z#4\nG90\nM99\n";
  const std::string step = "#1=#1+1\nIF[#1EQ3]THEN#3=-2\n";
  for (const char* body : bodies) {
    const std::string once = step + body + "\n";
    const auto looped = run("nct", head + "WHILE[#1LT5]DO1\n" + once + "END1\n" + tail);
    const auto jumped = run("nct", head + "N10" + once + "IF[#1LT5]GOTO10\n" + tail);
    const auto unrolled = run("nct", head + once + once + once + once + once + tail);
    EXPECT_EQ(looped.first_alarm(), unrolled.first_alarm()) << body;
    EXPECT_EQ(exactly(looped.actions), exactly(unrolled.actions)) << body;
    EXPECT_EQ(exactly(looped.ending), exactly(unrolled.ending)) << body;
    EXPECT_EQ(exactly(jumped.actions), exactly(unrolled.actions)) << body;
    EXPECT_EQ(exactly(jumped.ending), exactly(unrolled.ending)) << body;
    EXPECT_EQ(looped.state, unrolled.state) << body;
  }
}

// ---- arguments

/// The manual's table (23.3): variable, letter of type 1, letter of type 2.
struct ArgumentRow {
  int variable;
  const char* type_1;
  const char* type_2;
};
constexpr ArgumentRow argument_table[] = {
    {1, "A", "A"},   {12, "L", "K3"},  {23, "W", "J7"}, {2, "B", "B"},   {13, "M", "I4"},  {24, "X", "K7"},  {3, "C", "C"},
    {14, "N", "J4"}, {25, "Y", "I8"},  {4, "I", "I1"},  {15, "O", "K4"}, {26, "Z", "J8"},  {5, "J", "J1"},   {16, "P", "I5"},
    {27, "-", "K8"}, {6, "K", "K1"},   {17, "Q", "J5"}, {28, "-", "I9"}, {7, "D", "I2"},   {18, "R", "K5"},  {29, "-", "J9"},
    {8, "E", "J2"},  {19, "S", "I6"},  {30, "-", "K9"}, {9, "F", "K2"},  {20, "T", "J6"},  {31, "-", "I10"}, {10, "G", "I3"},
    {21, "U", "K6"}, {32, "-", "J10"}, {11, "H", "J3"}, {22, "V", "I7"}, {33, "-", "K10"},
};

struct Argument {
  char letter;
  double value;
};

/// Returns the locals by the table, or nullopt if a letter is illegal.
std::optional<std::map<int, double>> locals_by_table(const std::vector<Argument>& arguments) {
  std::map<int, double> locals;
  std::map<char, int> nth;  // the last row of I, J, K that each letter used
  for (const Argument& a : arguments) {
    const bool row_of_ten = a.letter >= 'I' && a.letter <= 'K';
    int found = 0;
    do {
      const std::string name = row_of_ten ? a.letter + std::to_string(++nth[a.letter]) : std::string(1, a.letter);
      found = 0;
      for (const ArgumentRow& row : argument_table)
        if (name == (row_of_ten ? row.type_2 : row.type_1)) found = row.variable;
    } while (row_of_ten && found != 0 && locals.contains(found));
    if (found == 0 || locals.contains(found)) return std::nullopt;
    locals[found] = a.value;
  }
  return locals;
}

std::string shows_locals() {
  std::string text = "M30\nO300\n";
  for (int n = 1; n <= 33; ++n) text += "#" + std::to_string(100 + n) + "=#" + std::to_string(n) + "\n";
  return text + "M99\n";
}

RC_GTEST_PROP(macro_arguments, go_where_the_table_says, ()) {
  static constexpr char letters[] = {'I', 'J', 'K', 'A', 'B', 'C', 'D', 'E', 'F', 'H', 'M', 'Q', 'R', 'S',
                                     'T', 'U', 'V', 'W', 'X', 'Y', 'Z', 'I', 'J', 'K', 'N', 'O', 'I'};
  Choices choose = choices(60);
  std::vector<Argument> arguments = {{'G', 65}};
  std::string text = "N1 G65";
  const std::size_t count = choose.below(14), program = choose.below(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    const Argument a = i == program ? Argument{'P', 300} : Argument{choose.of(letters), double(choose.between(1, 99))};
    arguments.push_back(a);
    text += std::string(choose.below(2), ' ') + a.letter + std::to_string(static_cast<int>(a.value));
  }
  const auto expected = locals_by_table(arguments);
  RC_TAG(expected.has_value());
  const auto r = run("nct", text + "\n" + shows_locals());
  if (r.first_alarm() != (expected ? "" : "illegal_address")) RC_FAIL(text + " gave '" + r.first_alarm() + "'");
  for (int n = 1; expected && n <= 33; ++n) {
    const auto found = expected->find(n);
    const double value = found == expected->end() ? no_value() : found->second;
    if (!same_value(variable_of(r.ending, 100 + n), value))
      RC_FAIL(text + " gave #" + std::to_string(n) + " " + value_text(variable_of(r.ending, 100 + n)));
  }
}

TEST(macro_arguments, are_those_of_the_manual) {
  const auto local = [](const std::string& block, int n) { return variable_of(run("nct", block + "\n" + shows_locals()).ending, 100 + n); };
  const std::string good = "G65 A2.12 B3.213 J36.9 E129.73 J-12 P300";
  EXPECT_EQ(local(good, 1), 2.12);
  EXPECT_EQ(local(good, 5), 36.9);
  EXPECT_EQ(local(good, 8), 129.73);
  EXPECT_EQ(local(good, 11), -12);
  EXPECT_EQ(run("nct", "G65 A2.12 B3.213 J36.9 J-12 E129.73 P300\n" + shows_locals()).first_alarm(), "illegal_address");
  const std::string numbered = "/N130 G65 P300 X12.3 Y32.6 N250";
  EXPECT_EQ(local(numbered, 24), 12.3);
  EXPECT_EQ(local(numbered, 14), 250);
  EXPECT_TRUE(is_empty(local("G65 P300 A#50000", 1)));
  EXPECT_TRUE(is_empty(local("G65 P300 A#7", 1)));
  EXPECT_EQ(local("G65 P300 A[#7]B-#7C[#7+0]", 3), 0);
}

TEST(macro_arguments, are_no_codes_of_the_block) {
  const auto r = run("nct", "G65 P300 M3 S500 T7 F20 H2.5 D-0.5\nG65 S100 M30 P300\n" + shows_locals());
  EXPECT_EQ(r.first_alarm(), "");
  EXPECT_TRUE(r.motions().empty());
  for (const Action& a : r.actions) EXPECT_TRUE(std::holds_alternative<FrameChange>(a.what) || is_report(a));
  EXPECT_EQ(variable_of(r.ending, 113), 30);
  EXPECT_EQ(variable_of(r.ending, 119), 100);
  const auto signs = run("nct", "#1=0.4\nG65 P300 H2.5 D#1 F-3 T-1.5\n" + shows_locals());
  EXPECT_EQ(variable_of(signs.ending, 111), 2.5);
  EXPECT_EQ(variable_of(signs.ending, 107), 0.4);
  EXPECT_EQ(variable_of(signs.ending, 109), -3);
  EXPECT_EQ(variable_of(signs.ending, 120), -1.5);
}

// ---- calls compared with the same code inline

RC_GTEST_PROP(macro_calls, do_what_the_body_does_inline, ()) {
  Choices choose = choices(400);
  const Steps steps = random_steps(choose, 2, false);
  const std::string body = ProgramPrinter(choose, true)(steps);
  static constexpr const char* letters[] = {"A", "B", "C", "I", "J", "K", "D", "E", "F"};  // #1 … #9
  std::string call = "G65 P300", set;
  for (int n = 1; n <= variables; ++n) {
    if (choose.one_in(2)) continue;
    const std::string value = std::to_string(choose.between(0, 20)) + ".5";
    call += letters[n - 1] + value;
    set += "#" + std::to_string(n) + "=" + value + "\n";
  }
  const std::string shown = "#101=#1\n#102=#2\n#103=#3\n#104=#4\n#105=#5\n";
  const auto called = run("nct", call + "\nM30\nO300\n#10=#0\n#16=#0\n" + body + shown + "M99\n");
  const auto written = run("nct", set + body + shown + "M30\n");
  if (called.first_alarm() != written.first_alarm())
    RC_FAIL(call + "\n" + body + "gave '" + called.first_alarm() + "', inline '" + written.first_alarm() + "'");
  if (exactly(untold(called.actions)) != exactly(untold(written.actions))) RC_FAIL(call + "\n" + body + "does something else inline");
  for (int n = 101; called.alarms.empty() && n <= 105; ++n)
    if (!same_value(variable_of(called.ending, n), variable_of(written.ending, n))) RC_FAIL(call + "\n" + body + "has other values inline");
}

TEST(macro_calls, keep_the_locals_of_their_caller) {
  const auto r =
      run("nct",
          "#1=5\n#2=6\nG65 P300 A7\n#103=#1\n#104=#2\nM98 P301\n#105=#1\nM30\nO300\n#101=#1\n#102=#2\n#1=8\n#2=9\nG65 P302\n#106=#1\nM99\n"
          "O301\n#1=#1+10\nM99\nO302\n#1=77\nM99\n");
  EXPECT_EQ(r.first_alarm(), "");
  EXPECT_EQ(variable_of(r.ending, 101), 7);
  EXPECT_TRUE(is_empty(variable_of(r.ending, 102)));
  EXPECT_EQ(variable_of(r.ending, 103), 5);
  EXPECT_EQ(variable_of(r.ending, 104), 6);
  EXPECT_EQ(variable_of(r.ending, 105), 15);
  EXPECT_EQ(variable_of(r.ending, 106), 8);
}

TEST(macro_calls, repeated_begin_with_the_same_arguments) {
  const auto r = run("nct", "G65 P300 L3 A1\nM30\nO300\n#100=#100+#1\n#1=50\n#101=#101+1\nM99\n");
  EXPECT_EQ(variable_of(r.ending, 100), 3);
  EXPECT_EQ(variable_of(r.ending, 101), 3);
}

TEST(macro_calls, nest_sixteen_deep) {
  const auto deepest = [](int depth) {
    return run("nct", "G65 P300 A1\nM30\nO300\n#100=#1\nIF[#1LT" + std::to_string(depth) + "]THEN#101=1\nIF[#1GE" + std::to_string(depth) +
                          "]GOTO9\nG65 P300 A[#1+1]\nN9M99\n");
  };
  EXPECT_EQ(deepest(16).first_alarm(), "");
  EXPECT_EQ(variable_of(deepest(16).ending, 100), 16);
  EXPECT_EQ(deepest(17).first_alarm(), "call_too_deep");
}

// ---- other spellings, other units

RC_GTEST_PROP(macro_programs, in_other_letters_and_with_blanks_are_the_same, ()) {
  Choices choose = choices(400);
  const Steps steps = random_steps(choose, 2, false);
  const auto plain = run("nct", ProgramPrinter(choose, true)(steps));
  const std::string text = ProgramPrinter(choose, false)(steps);
  const auto other = run("nct", text);
  if (plain.first_alarm() != other.first_alarm()) RC_FAIL(text + "gave '" + other.first_alarm() + "', not '" + plain.first_alarm() + "'");
  if (exactly(plain.actions) != exactly(other.actions) || exactly(plain.ending) != exactly(other.ending))
    RC_FAIL(text + "does something else");
}

/// Words of NC blocks and whole statements; blanks and comments are allowed between them.
const std::vector<std::vector<std::string>> words_of_program = {
    {"N5", "G21", "G90", "F200"},
    {"#1=3"},
    {"N10", "G1", "X[#1*2]", "Y-#1", "M8"},
    {"G2", "X#1", "Y0", "R20", "F[50+#1]"},
    {"#2=#5041"},
    {"G65", "P300", "A#1", "I1", "J2", "I3"},
    {"M98", "P301", "L2"},
    {"IF [#1 LT 6] THEN #1=#1+1"},
    {"IF [#1 LT 6] GOTO 10"},
    {"WHILE [#1 GT 4] DO 1"},
    {"G91", "XI5", "AX[2]=#1", "S500", "M3"},
    {"#1=#1-1"},
    {"END 1"},
    {"G90", "G54.1", "P2", "X1", "/"},
    {"G92", "X#1"},
    {"G17", "X", "Y", "G3", "X5", "Y5", "R30"},
    {"M30"},
    {"O300"},
    {"#100=#7+#5"},
    {"G0", "Z#1"},
    {"M99"},
    {"O301"},
    {"G91", "Z-1"},
    {"M99"},
};

std::string spelled(Choices& choose, const std::vector<std::vector<std::string>>& program, bool comments, bool small) {
  std::string text;
  for (const auto& line : program) {
    const bool statement = line[0][0] == '#' || line[0].rfind("IF", 0) == 0 || line[0].rfind("WH", 0) == 0 || line[0].rfind("EN", 0) == 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == "/") continue;
      std::string word = line[i];
      for (char& c : word)
        if (small && c >= 'A' && c <= 'Z' && choose.one_in(2)) c = static_cast<char>(c - 'A' + 'a');
      text += word + std::string(1 + choose.below(3), ' ');
      if (comments && (!statement || i + 1 == line.size()) && choose.one_in(3)) text += choose.one_in(2) ? "(G0 X99)" : "(TWO\nLINES) ";
    }
    text += "\n";
    if (comments && choose.one_in(4)) text += "(A LINE)\n\n";
  }
  return text;
}

RC_GTEST_PROP(macro_programs, with_comments_and_small_letters_are_the_same, ()) {
  Choices choose = choices(300);
  kadr::Setup setup;
  setup.work_offsets["G54.1 P2"] = {{"X", 5}};
  Choices none({});
  const auto plain = run("nct", spelled(none, words_of_program, false, false), setup);
  RC_ASSERT(plain.first_alarm() == "");
  const std::string text = spelled(choose, words_of_program, true, true);
  const auto other = run("nct", text, setup);
  if (plain.first_alarm() != other.first_alarm()) RC_FAIL(text + "gave '" + other.first_alarm() + "', not '" + plain.first_alarm() + "'");
  if (exactly(plain.actions) != exactly(other.actions) || exactly(plain.ending) != exactly(other.ending))
    RC_FAIL(text + "does something else");
}

RC_GTEST_PROP(macro_programs, in_inches_move_the_same, ()) {
  Choices choose = choices(400);
  const Steps steps = random_steps(choose, 2, false);
  const std::string millimetres = "G21\n" + ProgramPrinter(choose, true)(steps);
  const std::string inches = "G20\n" + ProgramPrinter(choose, true, false, "/25.4")(steps);
  const auto a = run("nct", millimetres), b = run("nct", inches);
  RC_ASSERT(a.first_alarm() == b.first_alarm());
  const auto one = a.motions(), other = b.motions();
  RC_ASSERT(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    if (std::fabs(one[i].to[0] - other[i].to[0]) > same_distance || std::fabs(one[i].feed - other[i].feed) > same_distance)
      RC_FAIL(inches + "moves elsewhere");
}

TEST(macro_variables, of_lengths_are_read_in_the_unit_in_force) {
  kadr::Setup setup;
  setup.offsets[1].length = 50.8;
  const auto r =
      run("nct", "G21 G0 X25.4\n#101=#5041\n#102=#10001\nG20\n#103=#5041\n#104=#10001\n#10001=1\n#5221=2\nG21\n#105=#10001\n#106=#5221\n",
          setup);
  EXPECT_EQ(r.first_alarm(), "");
  EXPECT_EQ(variable_of(r.ending, 101), 25.4);
  EXPECT_EQ(variable_of(r.ending, 102), 50.8);
  EXPECT_NEAR(variable_of(r.ending, 103), 1, same_distance);
  EXPECT_NEAR(variable_of(r.ending, 104), 2, same_distance);
  EXPECT_NEAR(variable_of(r.ending, 105), 25.4, same_distance);
  EXPECT_NEAR(variable_of(r.ending, 106), 50.8, same_distance);
}

// ---- loops and jumps of the manual (23.2.8, 23.2.11)

TEST(macro_loops, that_are_wrong_say_so) {
  const auto first = [](const std::string& text) { return run("nct", text).first_alarm(); };
  EXPECT_EQ(first("DO1\nGOTO9\nN9G90\n"), "do_without_end");
  EXPECT_EQ(first("END1\n"), "end_without_do");
  EXPECT_EQ(first("DO1\nDO1\nEND1\nEND1\n"), "do_without_end");
  EXPECT_EQ(first("WHILE[#1EQ#0]DO1\nDO2\nEND1\nEND2\n"), "loops_overlap");
  EXPECT_EQ(first("GOTO5\n"), "block_not_found");
  EXPECT_EQ(first("N1GOTO[1+1]\n"), "block_not_found");
  EXPECT_EQ(first("#1=#1+1\nM99\n"), "");  // a main program that restarts is not a loop: a note follows after --max-passes
  EXPECT_EQ(first("DO1\n#1=#1+1\nEND1\n"), "endless_program");
  EXPECT_EQ(first("N1GOTO1\n"), "endless_program");
}

TEST(macro_loops, may_be_entered_by_a_jump) {
  const auto before = run("nct", "GOTO150\nDO1\n#1=#1+1\nN150#2=#2+1\nIF[#2EQ3]GOTO9\nEND1\nN9G90\n");
  EXPECT_EQ(before.first_alarm(), "");
  EXPECT_EQ(variable_of(before.ending, 1), 2);
  const auto after = run("nct", "#2=0\nWHILE[#2LT3]DO1\n#1=#1+1\nN150#2=#2+1\nEND1\n#3=#3+1\nIF[#3EQ1]GOTO150\n");
  EXPECT_EQ(after.first_alarm(), "");
  EXPECT_EQ(variable_of(after.ending, 2), 4);
}

TEST(macro_loops, find_the_next_of_two_blocks_with_one_number) {
  const auto r = run("nct", "N5#101=#101+1\nIF[#101GT2]GOTO6\nGOTO5\n#102=1\nN5#103=#103+1\nIF[#103LT3]GOTO1\nN6M30\nN1GOTO5\n");
  EXPECT_EQ(r.first_alarm(), "");
  EXPECT_TRUE(is_empty(variable_of(r.ending, 102)));
  EXPECT_EQ(variable_of(r.ending, 103), 2);
}

}  // namespace
}  // namespace kadr::macro_test
