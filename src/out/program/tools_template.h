#pragma once
// Writes a tools file to be filled in, with the tool data that the program's comments suggest.

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
    Origin called;                    // where the program first calls the tool
    std::optional<ToolComment> said;  // nullopt: no comment describes the tool
    std::string why;                  // line and text of that comment
    std::string not_sure;             // the text of a comment that mentions the tool without a certain size
  };
  std::string program;
  Lang lang = Lang::en;
  std::vector<Row> rows;
};

/// Returns the tools-file word for the kind of tool that the comment describes; empty if the kind is not certain.
const char* kind_word(const ToolComment& said);

/// Returns the TOML text (docs/commands/cut.md, "Tools"). A key whose value nobody stated is written as a comment: until it is filled in,
/// the file is refused with an error that names the tool and the key.
std::string tools_template_text(const ToolsTemplate& made);

}  // namespace kadr
