// Writes a tools file for the user to complete. Used by cli/setup_command.

#include "out/program/tools_template.h"

#include <fmt/core.h>

namespace kadr {
namespace {

constexpr std::size_t comments_at = 32;  // column at which comments begin

/// Replaces control characters by blanks, since a TOML comment must not contain them.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) c = ' ';
  return text;
}

class RowText {
 public:
  RowText(const ToolsTemplate::Row& row, bool ru) : row_(row), ru_(ru) {}

  std::string text() {
    text_ = "\n[[tool]]\n";
    std::string at = (ru_ ? "строка " : "line ") + std::to_string(row_.called.line);
    if (!row_.why.empty()) at += (ru_ ? "; предложено по строке " : "; proposed from line ") + one_line(row_.why);
    if (!row_.not_sure.empty()) at += (ru_ ? "; не ясно: строка " : "; not sure: line ") + one_line(row_.not_sure);
    line(fmt::format("number = {}", row_.number), at);
    const ToolComment said = row_.said.value_or(ToolComment{});
    const std::string_view kind = kind_word(said);
    if (kind.empty())
      wanted("kind = \"\"", "flat, ball, bull, drill, taper, chamfer, tslot, form", "flat, ball, bull, drill, taper, chamfer, tslot, form");
    else line(fmt::format("kind = \"{}\"", kind));
    number("diameter", said.diameter, "mm", "мм");
    if (kind == "bull") number("corner", said.corner, "", "");
    if (kind == "drill" || kind == "chamfer") number("angle", said.angle, "of the whole point, degrees", "полный при вершине, градусы");
    if (kind == "taper") number("angle", half(said.angle), "half of the cone's, degrees", "половина угла конуса, градусы");
    wanted("flute_length = ", "how high above its tip it cuts, mm", "на какую высоту от вершины режет, мм");
    wanted("length = ", "stick-out: from the tip to the holder, mm", "вылет: от вершины до оправки, мм");
    wanted("holder = [[32, 0], [40, 45]]", "diameter and height above its face, mm", "диаметр и высота над его торцом, мм");
    return std::move(text_);
  }

 private:
  static std::optional<double> half(std::optional<double> whole) { return whole ? std::optional(*whole / 2) : std::nullopt; }

  void line(const std::string& what, const std::string& comment = {}) {
    text_ += comment.empty() ? what + "\n" : fmt::format("{:<{}} # {}\n", what, comments_at, comment);
  }
  void wanted(const std::string& what, const char* en, const char* ru) { line("# " + what, ru_ ? ru : en); }
  void number(const char* key, std::optional<double> value, const char* en, const char* ru) {
    if (value) line(fmt::format("{} = {}", key, number_text(*value)));
    else wanted(fmt::format("{} = ", key), en, ru);
  }

  const ToolsTemplate::Row& row_;
  bool ru_;
  std::string text_;
};

}  // namespace

const char* kind_word(const ToolComment& said) {
  switch (said.kind) {
    case ToolWord::ball: return "ball";
    case ToolWord::drill: return "drill";
    case ToolWord::chamfer: return "chamfer";
    case ToolWord::taper: return "taper";
    case ToolWord::mill: return said.corner.value_or(0) > 0 ? "bull" : "flat";
    case ToolWord::none:
    case ToolWord::tap:
    case ToolWord::reamer: return "";
  }
  return "";
}

std::string tools_template_text(const ToolsTemplate& made) {
  const bool ru = made.lang == Lang::ru;
  const std::string program = one_line(made.program);
  std::string text =
      ru ? fmt::format("# Инструменты программы {} для kadr cut --tools. Размеры из её комментариев проверьте; строки с «#» допишите.\n",
                       program)
         : fmt::format("# Tools of {} for kadr cut --tools. Check what its comments propose; fill in the lines with `#`.\n", program);
  for (const ToolsTemplate::Row& row : made.rows) text += RowText(row, ru).text();
  if (made.rows.empty()) text += ru ? "# Программа не вызывает ни одного инструмента.\n" : "# The program calls no tool.\n";
  return text;
}

}  // namespace kadr
