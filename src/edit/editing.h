#pragma once
// Edits a program and proves the result.
//
//   program ─▶ LineUses (a run) ─▶ ProgramEditor (new text) ─▶ prove_edit() ─▶ Edited

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "edit/edit_proof.h"
#include "edit/program_editor.h"
#include "lang/text/text_spool.h"

namespace kadr {

struct Edited {
  std::shared_ptr<ByteSource> text;  // the new program, in the encoding of the old one
  EditedText changes;
  EditProof proof;
  std::vector<EditLines> pieces;  // lines of the old program whose course is repeated or reversed
};

/// Edits the program.
///   program  the program's bytes and its encoding; `use` is not read
///   returns  a fault if the program cannot be edited as asked for, or a session could not be opened
tl::expected<Edited, EditFault> edited(const EditSpec& spec, const EditedSource& program);

}  // namespace kadr
