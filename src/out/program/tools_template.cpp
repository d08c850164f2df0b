// Writes a tools file for the user to complete. This file is used by cli/setup_command.

#include "out/program/tools_template.h"

#include <fmt/core.h>

#include "texts/tools_template.h"

namespace kadr {
namespace {

constexpr std::size_t comments_at = 32;  // column at which comments begin

/// Replaces control characters by blanks, since a comment in TOML must not contain them.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) c = ' ';
  return text;
}

class RowText {
 public:
  RowText(const ToolsTemplate::Row& row, Lang lang) : row_(row), lang_(lang) {}

  std::string text() {
    text_ = "\n[[tool]]\n";
    std::string at = translated_in(lang_, texts::tools_template::line, row_.called.line);
    if (!row_.why.empty()) at += "; " + translated_in(lang_, texts::tools_template::proposed_from, one_line(row_.why));
    if (!row_.not_sure.empty()) at += "; " + translated_in(lang_, texts::tools_template::not_sure, one_line(row_.not_sure));
    line(fmt::format("number = {}", row_.number), at);
    const ToolComment tool_data = row_.tool_data.value_or(ToolComment{});
    const std::string_view kind = kind_word(tool_data);
    if (kind.empty()) missing_line("kind = \"\"", "flat, ball, bull, drill, taper, chamfer, tslot, form");
    else line(fmt::format("kind = \"{}\"", kind));
    number("diameter", tool_data.diameter, in_words(texts::tools_template::diameter));
    if (kind == "bull") number("corner", tool_data.corner, "");
    if (kind == "drill" || kind == "chamfer") number("angle", tool_data.angle, in_words(texts::tools_template::whole_angle));
    if (kind == "taper") number("angle", half(tool_data.angle), in_words(texts::tools_template::half_angle));
    missing_line("flute_length = ", in_words(texts::tools_template::flute_length));
    missing_line("length = ", in_words(texts::tools_template::stick_out));
    missing_line("holder = [[32, 0], [40, 45]]", in_words(texts::tools_template::holder));
    return std::move(text_);
  }

 private:
  static std::optional<double> half(std::optional<double> whole) { return whole ? std::optional(*whole / 2) : std::nullopt; }

  const char* in_words(PlainText text) const { return plain_text(text, lang_); }
  void line(const std::string& what, const std::string& comment = {}) {
    text_ += comment.empty() ? what + "\n" : fmt::format("{:<{}} # {}\n", what, comments_at, comment);
  }
  void missing_line(const std::string& what, const char* comment) { line("# " + what, comment); }
  void number(const char* key, std::optional<double> value, const char* comment) {
    if (value) line(fmt::format("{} = {}", key, number_text(*value)));
    else missing_line(fmt::format("{} = ", key), comment);
  }

  const ToolsTemplate::Row& row_;
  Lang lang_;
  std::string text_;
};

}  // namespace

const char* kind_word(const ToolComment& tool_data) {
  switch (tool_data.kind) {
    case ToolWord::ball: return "ball";
    case ToolWord::drill: return "drill";
    case ToolWord::chamfer: return "chamfer";
    case ToolWord::taper: return "taper";
    case ToolWord::mill: return tool_data.corner.value_or(0) > 0 ? "bull" : "flat";
    case ToolWord::none:
    case ToolWord::tap:
    case ToolWord::reamer: return "";
  }
  return "";
}

std::string tools_template_text(const ToolsTemplate& made) {
  std::string text = "# " + translated_in(made.lang, texts::tools_template::heading, one_line(made.program)) + "\n";
  for (const ToolsTemplate::Row& row : made.rows) text += RowText(row, made.lang).text();
  if (made.rows.empty()) text += "# " + translated_in(made.lang, texts::tools_template::no_tool) + "\n";
  return text;
}

}  // namespace kadr
