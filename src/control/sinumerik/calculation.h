#pragma once
// Calculation: lines of a program that only compute numbers and jump (R1=R1+1, WHILE, IF … GOTOB), compiled once and executed one after the
// other without the general path of a block. Where it meets anything else, it stops before that line, and the general path executes it:
// also a line with a fault, so that the alarms are those of the general path. Only src/control/sinumerik includes this file.

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "action/origin.h"
#include "control/sinumerik/number.h"
#include "control/sinumerik/program_index.h"
#include "lang/block/block_reader.h"
#include "lang/named/named_block.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::sinumerik {

class Sinumerik;

class Calculation {
 public:
  explicit Calculation(Sinumerik& own) : own_(own) {}

  /// Executes the lines from the present position of the program on. Returns false if none was executed.
  bool run(Interpreter& m);
  /// To be called when a name may mean another variable: after DEF, PROC, a call and a return.
  void forget_variables() { std::fill(slots_.begin(), slots_.end(), &unknown_); }
  // ---- expressions, for the lines that others keep
  struct Code {
    std::uint32_t begin = 0, end = 0;
  };
  /// Compiles an expression of numbers; nullopt if it has anything else.
  std::optional<Code> compiled(const NamedBlock& read, NamedExpression expression);
  /// Computes an expression. Returns false if its value is no number, or if it causes an alarm.
  bool value(Code code, Number& to);
  std::uint32_t slot_of(const std::string& name);
  /// Returns the variable that the name of the slot means now; nullptr if there is none.
  Variable* variable(std::uint32_t slot);

  /// To be called when the numbers of the files may mean other files.
  void forget_all();

 private:
  /// A step of an expression for a stack machine of numbers.
  struct Step {
    enum class Kind : std::uint8_t { number, parameter, parameter_at, variable, apply_one, apply_two, function };
    Kind kind = Kind::number;
    NamedOp op = NamedOp::add;
    std::uint16_t operands = 0;  // variable: indices of the element
    std::uint32_t index = 0;     // parameter: its number; variable: its slot
    Number number;
    const NumberFunction* function = nullptr;
  };
  /// What an assignment writes to.
  struct Target {
    std::optional<std::uint32_t> slot;  // variable; nullopt: an R parameter
    std::uint32_t parameter = 0;
    std::vector<Code> indices;  // of the element; of R[…]: its number
    Code value;
  };
  enum class Kind : std::uint8_t { other, nothing, assign, jump, jump_unless, jump_if, count, count_on, call, parameters, leave };
  /// A line that calls a program or returns from it, as the call stack needs it.
  struct Call {
    Origin origin;
    NamedBlock read;  // PROC
    std::string name;
    FoundProgram program;
    std::vector<Code> arguments;
    std::vector<std::string> references;  // by argument: its name, if it is only a name; else empty
  };
  /// A compiled line. `other`: the general path executes it.
  struct Line {
    Kind kind = Kind::other;
    Position at, after, target;               // target: of the jump
    std::int32_t next = -1, jumped = -1;      // line at `after`, at `target`; -1: not looked for yet
    std::vector<Target> targets;              // assign, count
    Code condition;                           // jump_if, jump_unless; count: the last value
    std::optional<std::uint32_t> label_slot;  // the label's name, if it could also be that of a variable with the label
    bool acts = false;                        // a jump, after which DEF is too late
    std::shared_ptr<const Call> call;         // call, parameters, leave
  };
  struct File {
    std::unique_ptr<BlockReader> reader;
    std::unordered_map<std::uint64_t, std::int32_t> lines;  // by offset
  };
  struct Written {
    double* to;
    double before;
  };

  // calculation_lines.cpp
  std::int32_t line_at(Interpreter& m, const Position& at);
  void compile(Interpreter& m, const ProgramIndex& index, Line& line, Block& block);
  bool structure(const ProgramIndex& index, const NamedBlock& read, Keyword keyword, Line& line);
  bool counted(const NamedBlock& read, Line& line);
  bool conditional(const ProgramIndex& index, const NamedBlock& read, Line& line);
  bool to_label(const ProgramIndex& index, const NamedItem& item, Line& line);
  bool assignments(const NamedBlock& read, Line& line);
  bool target_of(const NamedBlock& read, const NamedItem& item, Target& target);
  bool call_of(Interpreter& m, const NamedItem& item, const NamedBlock& read, const Origin& origin, Line& line);
  bool step(const NamedStep& from, std::size_t& depth);

  // calculation.cpp
  bool pushed_variable(const Step& step, Number* stack, std::size_t& count);
  double* place(const Target& target, Type& type);
  bool write(double* to, Type type, Number value);
  /// Executes a line. Returns nullopt if the general path must execute it; then nothing has changed. Otherwise: whether it jumps.
  std::optional<bool> execute(const Line& line);
  std::optional<bool> count(const Line& line);
  /// Executes a line that calls, takes its arguments or returns. Returns false if the general path must execute it.
  bool steer(Interpreter& m, const Line& line);
  bool call(Interpreter& m, const Call& of);
  void undo();

  static constexpr std::size_t most_values = 32;  // on the stack of an expression
  static constexpr std::size_t most_lines = 50'000;

  Sinumerik& own_;
  std::unordered_map<std::uint16_t, File> files_;
  std::deque<Line> lines_;  // its elements stay where they are
  std::vector<Step> code_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> slot_by_name_;
  Variable unknown_;                       // marks a slot whose variable has not been looked for
  std::vector<Variable*> slots_;           // nullptr: no variable has the name
  std::array<Number, most_values> stack_;  // of value(); a member, because initialising it takes longer than most expressions
  std::vector<Written> written_;           // by the line that is being executed
};

}  // namespace kadr::sinumerik
