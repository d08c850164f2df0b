#pragma once
// FlatWriter: writes the actions of a run as flat blocks of the target control. FlatProgram writes blocks of word addresses,
// KlartextProgram conversational blocks.

#include <cstdint>
#include <optional>

#include "action/action.h"
#include "action/tool_position.h"

namespace kadr {

struct OffsetsInForce;

class FlatWriter {
 public:
  virtual ~FlatWriter() = default;
  ///   stand  position of the axes at the beginning; `placement` contains the work offset in force
  virtual Status begin(const ToolPosition& stand, const Placement& placement) = 0;
  /// Writes one action of the run.
  ///   alarms  function_has_no_code  the target control has no code for the action
  ///           word_has_no_room
  virtual Status take(const Action& action, const OffsetsInForce& now) = 0;
  /// Writes the T word of a lathe if the source block that has just been executed has put other offsets into force, without an action.
  virtual Status note_offsets(const OffsetsInForce& now) = 0;
  /// Ends the flat blocks that together express one block of the source program.
  virtual Status end_block() = 0;
  virtual Status finish() = 0;
  /// Returns the number of the work system that all motions in work coordinates use; nullopt if they use several, or none.
  virtual std::optional<std::uint16_t> counts_from() const = 0;
};

}  // namespace kadr
