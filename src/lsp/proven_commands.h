#pragma once
// Commands that write a new text and prove it: the program for another control, the program with new block numbers. They run the program
// several times, so that they take longer than other requests.

#include <functional>
#include <optional>
#include <string>

#include "base/stop_token.h"
#include "lsp/editor_abilities.h"
#include "lsp/open_document.h"

namespace kadr {

/// Names of the commands, and their arguments:
inline constexpr const char* convert_command = "kadr.convert";    // [URI, id of the control]
inline constexpr const char* renumber_command = "kadr.renumber";  // [URI]

/// What a command has done: an edit that the editor applies.
struct CommandOutcome {
  LspJson edit;             // WorkspaceEdit
  std::string label, told;  // name of the edit; what the user reads afterwards
  std::string created;      // URI of the new file; empty: there is none
};

/// Returns the actions that run the commands, as CodeAction, or as Command for an editor that knows no others. An editor that cannot apply
/// their edits is offered none.
///   wanted  returns true if the editor asks for actions of this kind
LspJson command_actions_json(const OpenDocument& document, const EditorAbilities& editor,
                             const std::function<bool(const char* kind)>& wanted);

/// Converts the program for another control. The edit creates a file next to the program: "flange-mach3.nc" for "flange.nc".
///   taken    returns true if a file may not have this path
///   returns  nullopt if the stop token ended the work
///   throws   LspFault with the reasons, if no conversion can be proven
std::optional<CommandOutcome> converted_document(const OpenDocument& document, const std::string& to,
                                                 const std::function<bool(const std::string& path)>& taken, const StopToken& stop);
/// Gives the blocks the numbers 10, 20, 30 …; words that name blocks follow.
///   returns, throws  as converted_document()
std::optional<CommandOutcome> renumbered_document(const OpenDocument& document, const EditorAbilities& editor, const StopToken& stop);

}  // namespace kadr
