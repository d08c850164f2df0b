#pragma once
// Converts or edits an opened program, and proves the new text (convert/conversion.h, edit/editing.h). The page and the language server
// show the result and the reasons of a refusal in their own forms.

#include <cstdint>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "convert/conversion.h"
#include "edit/editing.h"
#include "view/opening.h"

namespace kadr {

/// Greatest size of a program, bytes, that is converted or edited for a person who waits.
inline constexpr std::size_t max_proven_text = std::size_t{8} << 20;

/// Converts a program for another control.
///   text     the text of the program, UTF-8, lines separated by '\n'
///   flat     writes out calls, loops and cycles (ConversionSpec::flat)
///   returns  an error sentence if a session could not be opened
tl::expected<Converted, std::string> converted_program(const OpenedProgram& from, const std::shared_ptr<const ControlDef>& to,
                                                       std::string text, bool flat, const StopToken& stop);

/// Edits a program in one respect.
///   text  the text of the program, UTF-8
tl::expected<Edited, EditFault> edited_program(const OpenedProgram& opened, const std::string& text, Edits edits, const StopToken& stop);

/// A reason why an edit is refused.
struct EditReason {
  std::string text;
  std::uint32_t line = 0;  // line of the program; 0: none
};

/// Returns why an edit that could not be proven is refused: the alarm that stops the program, or the differences that nobody asked for.
std::vector<EditReason> edit_reasons(const Comparison& proof, const OpenedProgram& opened, Lang lang);

}  // namespace kadr
