// Reads the description of a tool in a comment: "(T1 D8 ENDMILL)", «ФРЕЗА 8», "T01 FREZA D=10 R0.5". Used by session/tool_proposals,
// view/sheet; tested by tests/lang/tool_comment_test.cpp.
//
//   text ─▶ tool_comment_tokens ─▶ tool_figures: the meaning of each number ─▶ here: which number is the size of the tool
//
// A wrong diameter is worse than no diameter. The sources are tried in this order, and a step gives a result only if all its findings
// agree: a number that the comment calls diameter; a size in the name of the tool (1/2 ENDMILL, {6 mm}), the number or letter of a drill,
// the thread of a tap; a size after the name (ENDMILL 10).

#include "lang/text/tool_comment.h"

#include <algorithm>

#include "lang/text/tool_size.h"

namespace kadr {
namespace {

std::optional<std::uint32_t> tool_of(const std::vector<CommentPiece>& pieces) {
  for (const CommentPiece& p : pieces)
    if (p.is_figure() && p.figure == FigureIs::tool) return static_cast<std::uint32_t>(p.value);
  return std::nullopt;
}

/// Keeps only the pieces about the first tool in a comment about several tools (T1 = D16 ENDMILL, T2 = DRILL 6.8).
void keep_first_tool(std::vector<CommentPiece>& pieces) {
  const auto first = tool_of(pieces);
  const auto other = std::find_if(pieces.begin(), pieces.end(), [&](const CommentPiece& p) {
    return p.is_figure() && p.figure == FigureIs::tool && static_cast<std::uint32_t>(p.value) != *first;
  });
  pieces.erase(other, pieces.end());
}

/// Returns the full point angle in degrees. CAM systems give half of it in TAPER=45DEG of a chamfer mill, so this value is doubled.
std::optional<double> angle_of(const std::vector<CommentPiece>& pieces, ToolWord kind) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].is_figure() || pieces[i].figure != FigureIs::angle) continue;
    const bool is_half = i > 1 && pieces[i - 2].text == "TAPER" && kind != ToolWord::drill;
    const double angle = pieces[i].value * (is_half ? 2 : 1);
    if (angle > 0 && angle < 180) return angle;
  }
  return std::nullopt;
}

}  // namespace

ToolComment read_tool_comment(std::string_view text, bool inch) {
  std::vector<CommentPiece> pieces = comment_pieces(text);
  keep_first_tool(pieces);
  ToolComment found;
  found.tool = tool_of(pieces);
  const ToolNames names(pieces);
  found.kind = names.kind();
  found.angle = angle_of(pieces, found.kind);
  const ToolSize size(pieces, names, inch);
  found.diameter = size.diameter();
  const std::optional<double> corner = size.corner(found.diameter);
  if (!found.diameter && found.kind == ToolWord::ball && corner.value_or(0) > 0) found.diameter = 2 * *corner;
  if (found.diameter || found.tool) found.corner = corner;
  found.unsure = !found.diameter && !names.all().empty();
  return found;
}

std::vector<std::string> comments_of(std::string_view line) {
  std::vector<std::string> comments;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ';') {
      comments.emplace_back(line.substr(i + 1));
      break;
    }
    if (line[i] != '(') continue;
    const std::size_t end = std::min(line.find(')', i), line.size());
    comments.emplace_back(line.substr(i + 1, end - i - 1));
    i = end;
  }
  return comments;
}

std::string without_comments(std::string_view line) {
  std::string rest;
  for (std::size_t i = 0; i < line.size() && line[i] != ';'; ++i) {
    if (line[i] == '(') {
      i = std::min(line.find(')', i), line.size() - 1);
      continue;
    }
    rest += line[i];
  }
  const auto from = rest.find_first_not_of(" \t\r"), to = rest.find_last_not_of(" \t\r");
  return from == std::string::npos ? std::string() : rest.substr(from, to - from + 1);
}

}  // namespace kadr
