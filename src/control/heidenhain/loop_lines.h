#pragma once
// LoopLines: blocks of a program that jumps back which only compute, jump, call labels or move on plain lines (Q1 = Q1 + 1, FN 9, CALL LBL
// 5 REP 9, L X+Q1), read once and executed one after the other without the general path of a block. Where it meets anything else, also a
// fault, it stops before that block, and the general path executes it. Only src/control/heidenhain includes this file.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "action/origin.h"
#include "base/vec.h"
#include "lang/block/block_reader.h"
#include "lang/klartext/klartext_block.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::heidenhain {

class Heidenhain;

class LoopLines {
 public:
  explicit LoopLines(Heidenhain& own) : own_(own) {}

  /// Executes the blocks from the present position of the program on. Returns false if none was executed.
  bool run(Interpreter& m);
  /// To be called when the numbers of the files may mean other files.
  void forget_all();
  /// To be called for each block of the general path, with the number of its chain of calls (Origin::calls).
  void note_block(std::size_t depth, std::uint16_t calls) {
    if (depth > 0) knows_chains_ = true, records_chains_ = calls != 0;
  }

 private:
  enum class Kind : std::uint8_t { other, nothing, assign, jump, repeat, call, leave, line };
  struct AxisValue {
    std::size_t axis = 0;
    bool incremental = false;
    double number = 0;
    KlartextExpression value;
  };
  /// A block as it is executed. `other`: by the general path.
  struct Line {
    Kind kind = Kind::other;
    Position at, after, target;           // target: of the jump, of the call
    std::int32_t next = -1, jumped = -1;  // line at `after`, at `target`; -1: not looked for yet
    std::shared_ptr<const KlartextBlock> read;
    Origin origin;
    std::vector<AxisValue> axes;  // line
    const KlartextWord* feed = nullptr;
    bool rapid = false;
  };
  struct File {
    std::unique_ptr<BlockReader> reader;
    std::unordered_map<std::uint64_t, std::int32_t> lines;  // by offset
  };
  enum class Step : std::uint8_t { on, jumps, stops };

  std::int32_t line_at(Interpreter& m, const Position& at);
  void compile(Interpreter& m, Line& line, const Block& block);
  bool compile_motion(const BlockContext& m, Line& line) const;
  bool value(const KlartextBlock& block, KlartextExpression expression, double& to) const;
  Step execute(Interpreter& m, Line& line, std::uint64_t done);
  Step jump(const Line& line) const;
  Step repeat(const BlockContext& m, const Line& line);
  Step call(Interpreter& m, const Line& line, std::uint64_t done);
  Step leave(Interpreter& m, const Line& line);
  Step move(Interpreter& m, const Line& line, std::uint64_t done);
  bool moves_plainly(Interpreter& m) const;
  Origin origin_of(const Interpreter& m, const Line& line, std::uint64_t done) const;

  static constexpr std::size_t most_values = 32;  // on the stack of an expression
  static constexpr std::size_t most_lines = 50'000;

  Heidenhain& own_;
  std::unordered_map<std::uint16_t, File> files_;
  std::deque<Line> lines_;  // its elements stay where they are
  bool knows_chains_ = false, records_chains_ = false;
  bool moved_ = false;
};

}  // namespace kadr::heidenhain
