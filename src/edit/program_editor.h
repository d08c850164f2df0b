#pragma once
// ProgramEditor: writes a program with edits. Lines that no edit concerns are written byte by byte as they are.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/stop_token.h"
#include "edit/edits.h"
#include "edit/line_patches.h"
#include "edit/line_uses.h"
#include "edit/renumbering.h"
#include "lang/text/encoding.h"

namespace kadr {

struct EditedText {
  std::size_t lines = 0;         // number of lines that differ from those of the program, removed ones included
  std::size_t not_executed = 0;  // number of changed words in blocks that the run did not execute
};

struct EditedSource {
  std::shared_ptr<ByteSource> source;  // the program
  std::optional<Encoding> encoding;    // nullopt: the encoding is guessed
  const ControlDef* control = nullptr;
  const LineUses* use = nullptr;         // needed if needs_use() is true
  const LinePatches* patches = nullptr;  // lines that are written as a whole; nullptr: there are none
};

/// True if the edits depend on what the lines are used for.
bool needs_use(const Edits& edits);

/// Writes the program with the edits. Needs memory for one line, and for renumbering also for the numbers that some block names.
///   put      receives the new text in pieces, in the encoding of the program
///   returns  a fault if some line cannot be edited as asked for
tl::expected<EditedText, EditFault> edit_program(const EditedSource& program, const Edits& edits, const StopToken& stop,
                                                 const std::function<void(std::string_view)>& put);

}  // namespace kadr
