#pragma once
// OLineRewriter: rewrites macro statements (spec/fanuc 5, nct 23) as O lines of RS274/NGC (spec/linuxcnc 6): loops, conditions, nested
// jumps, and calls with arguments.

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

/// What is known of the program's jumps and macros before it is rewritten.
struct MacroShape {
  std::set<std::uint32_t> jumped_back;            // N of blocks that a later GOTO jumps back to
  std::set<std::uint32_t> leaves;                 // lines with a GOTO that leaves the loop around it
  std::map<std::uint32_t, std::uint32_t> macros;  // label of a subprogram called with arguments → its last line
};

class OLineRewriter {
 public:
  /// `flow` rewrites expressions; it must outlive this object.
  explicit OLineRewriter(FlowRewriter& flow) : flow_(flow) {}
  void set_shape(MacroShape shape) { shape_ = std::move(shape); }

  /// Handles N of a block: jumps to it end or begin there.
  Status number(std::uint32_t number, BlockMaker& out);
  /// Rewrites a statement; `words` writes the words of the block that follow a condition.
  ///   alarms  function_has_no_code
  Status write(const Block& block, const std::function<Status()>& words, BlockMaker& out);
  /// Rewrites a macro call, G65.
  Status call(const Block& block, const std::function<Status(const Word&, std::string&)>& value, BlockMaker& out);
  /// True if this O… begins a subprogram that is called with arguments; end() writes its M99.
  bool begins(std::uint32_t label) const { return shape_.macros.count(label) != 0; }
  Status begin(std::uint32_t label, BlockMaker& out);
  bool is_in_macro() const { return macro_ != 0; }
  Status end(std::uint32_t line, BlockMaker& out);

 private:
  struct Skip {
    std::uint32_t to, label;  // N; label of the O line
  };
  Status line(std::string text, BlockMaker& out) const;
  std::uint32_t next_label() { return ++last_label_; }

  FlowRewriter& flow_;
  MacroShape shape_;
  std::vector<std::uint32_t> loops_;              // labels of O lines
  std::vector<Skip> skips_;                       // forward jumps that are open
  std::map<std::uint32_t, std::uint32_t> backs_;  // N → label of its `do`
  std::uint32_t macro_ = 0;                       // the present subprogram; 0: none
  std::uint32_t last_label_ = 70000;
};

}  // namespace kadr
