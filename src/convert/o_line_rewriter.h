#pragma once
// OLineRewriter: rewrites macro statements (spec/fanuc 5, nct 23) as O lines of RS274/NGC (spec/linuxcnc 6): loops, conditions, jumps
// that nest like loops, and calls with arguments.

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "convert/block_maker.h"
#include "convert/flow_rewriter.h"
#include "lang/block/block.h"

namespace kadr {

/// The jumps and macros of a program, which are collected before the program is rewritten.
struct MacroShape {
  std::set<std::uint32_t> jumped_back;            // block numbers N to which a later GOTO jumps back
  std::set<std::uint32_t> leaves;                 // lines whose GOTO jumps out of the loop that contains it
  std::map<std::uint32_t, std::uint32_t> macros;  // label of each subprogram called with arguments → the last line of the subprogram
};

class OLineRewriter {
 public:
  /// `flow` rewrites the expressions, and must exist longer than this object.
  explicit OLineRewriter(FlowRewriter& flow) : flow_(flow) {}
  void set_shape(MacroShape shape) { shape_ = std::move(shape); }

  /// Ends the jumps that lead to the block with this number N, or begins the loop that replaces jumps back to the block. The caller must
  /// call this function for the N of each block.
  Status number(std::uint32_t number, BlockMaker& out);
  /// Rewrites a macro statement. `words` writes the other words of the block, which follow a condition in the statement.
  ///   alarms  function_has_no_code
  Status write(const Block& block, const std::function<Status()>& words, BlockMaker& out);
  /// Rewrites G65, the call of a macro with arguments.
  Status call(const Block& block, const std::function<Status(const Word&, std::string&)>& value, BlockMaker& out);
  /// True if a subprogram with this label begins here and is called with arguments. Then end() must be called to write the return of the
  /// subprogram.
  bool begins(std::uint32_t label) const { return shape_.macros.count(label) != 0; }
  Status begin(std::uint32_t label, BlockMaker& out);
  bool is_in_macro() const { return macro_ != 0; }
  Status end(std::uint32_t line, BlockMaker& out);

 private:
  struct Skip {
    std::uint32_t to, label;  // `to`: block number N that a jump leads to; `label`: number of the O line that replaces this jump
  };
  Status line(std::string text, BlockMaker& out) const;
  std::uint32_t next_label() { return ++last_label_; }

  FlowRewriter& flow_;
  MacroShape shape_;
  std::vector<std::uint32_t> loops_;              // labels of the loops (O lines) that are open at the present line
  std::vector<Skip> skips_;                       // forward jumps whose target block has not been read yet
  std::map<std::uint32_t, std::uint32_t> backs_;  // block number N → label of the `do` line that was written at this block
  std::uint32_t macro_ = 0;                       // label of the subprogram that is being rewritten; 0: none
  std::uint32_t last_label_ = 70000;
};

}  // namespace kadr
