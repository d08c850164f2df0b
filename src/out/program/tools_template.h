#pragma once
// Writes a tools file for the user to complete. It contains the tool data that the comments of the program suggest.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "config/alarm_texts.h"
#include "lang/text/tool_comment.h"

namespace kadr {

struct ToolsTemplate {
  struct Row {
    std::uint32_t number = 0;
    Origin called;                         // location of the block that calls the tool first
    std::optional<ToolComment> tool_data;  // data from the comment that describes the tool; nullopt: no comment describes the tool
    std::string why;                       // line number and text of the comment from which `tool_data` comes
    std::string not_sure;                  // text of a comment that mentions the tool but states no certain dimension
  };
  std::string program;
  Lang lang = Lang::en;
  std::vector<Row> rows;
};

/// Returns the key word of a tools file for the type of tool that the comment describes; empty if the type is uncertain.
const char* kind_word(const ToolComment& tool_data);

/// Returns the text of the tools file in TOML (docs/commands/cut.md, "Tools"). A key without a known value is written as a TOML comment.
/// Until the user completes the key, Kadr refuses the file with an error that names the tool and the key.
std::string tools_template_text(const ToolsTemplate& made);

}  // namespace kadr
