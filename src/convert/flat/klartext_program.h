#pragma once
// KlartextProgram: writes the actions of a run as conversational blocks of a Heidenhain control (spec/heidenhain): L, CC and C, helices as
// CP, TOOL CALL, presets by cycle 247. The class does not check the result; the proof (convert/conversion) does.

#include <string>

#include "convert/flat/flat_program.h"
#include "convert/flat/flat_writer.h"

namespace kadr {

class KlartextProgram final : public FlatWriter {
 public:
  KlartextProgram(BlockMaker& blocks, FlatSource source, FlatForm form) : blocks_(blocks), source_(std::move(source)), form_(form) {}

  Status begin(const ToolPosition& stand, const Placement& placement) override;
  Status take(const Action& action, const OffsetsInForce& now) override;
  Status note_offsets(const OffsetsInForce&) override { return {}; }
  Status end_block() override { return {}; }
  Status finish() override;
  std::optional<std::uint16_t> counts_from() const override { return counts_from_several_ ? std::nullopt : counts_from_; }

 private:
  Status write(const std::string& block);
  Status motion(const Motion& motion);
  Status preset(const Motion& motion);
  Status line(const Motion& motion, bool in_machine);
  Status arc(const Motion& motion);
  Status tail(std::string& block, const Motion& motion, bool in_machine);
  bool is_allowed_axis(std::size_t axis) const;
  std::string word(std::size_t axis, double value) const;
  Status spindle(const Spindle& spindle);
  Status speed(double rpm);
  Status tool(std::uint32_t number);
  Status machine_code(std::uint32_t code);
  Axes base() const;

  BlockMaker& blocks_;
  const FlatSource source_;
  const FlatForm form_;
  Axes at_{};  // machine coordinates
  Placement placement_;
  AxisMask known_ = 0;  // axes whose coordinate the text has given since the base last changed
  std::uint16_t system_ = 0;
  std::int8_t side_ = 0;
  double feed_ = -1, rpm_ = -1;
  SpindleDir turns_ = SpindleDir::stop;
  std::string pole_;  // CC as written last
  std::optional<std::uint16_t> counts_from_;
  bool counts_from_several_ = false;
};

}  // namespace kadr
