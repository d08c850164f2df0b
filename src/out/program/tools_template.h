#pragma once
// A tools file to be filled in, with what comments of a program propose.

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
    Origin called;                    // where the program calls it first
    std::optional<ToolComment> said;  // nothing: no comment speaks of it
    std::string why;                  // line and text of that comment
    std::string not_sure;             // of one that speaks of it without a size that is sure
  };
  std::string program;
  Lang lang = Lang::en;
  std::vector<Row> rows;
};

/// The kind of a tools file that a comment means; empty: none of them for certain.
const char* kind_word(const ToolComment& said);

/// TOML as design.md 10 has it. What nobody said is a comment with the key: the file is refused by name of tool and key until that is
/// filled in.
std::string tools_template_text(const ToolsTemplate& made);

}  // namespace kadr
