// Puts the files of a program into the page without a server. Used by cli/report_run; tested by tests/view/live_report_test.cpp and
// web/e2e/alone_live.mjs.

#include "view/report/live_report.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "config/json_text.h"
#include "out/text/base64.h"
#include "view/report/packed_columns.h"

namespace kadr {
namespace {

constexpr std::string_view mark_of_page = "id=\"kadr-engine-wasm\"";
constexpr std::string_view end_of_page = "</body>";

/// Returns a text each character of which is a byte, in UTF-8.
std::string bytes_as_characters(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) text += c;
    else text += {char(0xC0 | (byte >> 6)), char(0x80 | (byte & 0x3F))};
  }
  return text;
}

}  // namespace

bool is_page_alone(std::string_view html) {
  return html.find(mark_of_page) != std::string_view::npos && html.rfind(end_of_page) != std::string_view::npos;
}

tl::expected<std::string, std::string> live_report_html(std::string_view page, const LiveOpening& opening,
                                                        const std::vector<LiveFile>& files) {
  nlohmann::ordered_json json = {{"open", {{"file", opening.file}}}, {"files", nlohmann::ordered_json::object()}};
  for (const auto& [key, value] :
       {std::pair("control", &opening.control), std::pair("machine", &opening.machine), std::pair("setup", &opening.setup)})
    if (!value->empty()) json["open"][key] = *value;
  for (const LiveFile& file : files) json["files"][file.place] = bytes_as_characters(file.bytes);
  const auto packed = zlib_packed(json_text(json));
  if (!packed) return tl::unexpected(packed.error());
  const std::size_t end = page.rfind(end_of_page);
  std::string html(page.substr(0, end));
  html += "<script type=\"text/plain\" id=\"kadr-files\">" + base64_of(*packed) + "</script>\n";
  html += page.substr(end);
  return html;
}

}  // namespace kadr
