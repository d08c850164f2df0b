// Answers the request `mill`: converts a drawing of the served folder to a program. The program is not saved here; the page saves it if the
// user requests that. Used by view/page/page_session; tested by tests/serve_making.py.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "config/control/control_file.h"
#include "lang/text/end_mark.h"
#include "out/picture/plot/plot_page.h"
#include "session/milling/mill_summary.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_made_bytes = std::size_t{8} << 20;  // greatest size in bytes of a program or of its picture

/// A number in the request. The key of the number is the name of an option of `kadr mill`.
struct MillNumber {
  std::string_view key;
  double MillRequest::*value;
};
struct MillText {
  std::string_view key;
  std::string MillRequest::*value;
};
constexpr MillNumber mill_numbers[] = {
    {"tool_diameter", &MillRequest::tool_diameter},
    {"depth", &MillRequest::depth},
    {"pass", &MillRequest::pass},
    {"allowance", &MillRequest::allowance},
    {"top", &MillRequest::top},
    {"clearance", &MillRequest::clearance},
    {"overrun", &MillRequest::overrun},
    {"angle", &MillRequest::angle},
    {"ramp_angle", &MillRequest::ramp_angle},
    {"width", &MillRequest::width},
    {"feed", &MillRequest::feed},
    {"plunge_feed", &MillRequest::plunge_feed},
    {"speed", &MillRequest::speed},
};
constexpr MillText mill_texts[] = {
    {"task", &MillRequest::task},         {"scheme", &MillRequest::scheme}, {"direction", &MillRequest::direction},
    {"stepover", &MillRequest::stepover}, {"plunge", &MillRequest::plunge}, {"mark", &MillRequest::mark},
};
constexpr std::string_view of_the_question[] = {"id", "do", "drawing", "control"};
constexpr std::string_view tasks[] = {"pocket", "face", "slot"}, marks[] = {"", end_mark_in_text, "LF"};

template <class Rows>
auto row_of(const Rows& rows, std::string_view key) {
  return std::find_if(std::begin(rows), std::end(rows), [&](const auto& row) { return row.key == key; });
}

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Stores one value of the JSON request in `request`. Returns false if the key is unknown, or the value has the wrong type.
bool take_word(MillRequest& request, const std::string& key, const PageJson& value) {
  if (const auto row = row_of(mill_numbers, key); row != std::end(mill_numbers)) {
    if (!value.is_number()) return false;
    request.*row->value = value.get<double>();
    return true;
  }
  if (const auto row = row_of(mill_texts, key); row != std::end(mill_texts)) {
    if (!value.is_string()) return false;
    request.*row->value = value.get<std::string>();
    return true;
  }
  if (key == "coolant") return value.is_boolean() && (request.coolant = value.get<bool>(), true);
  if (key == "tool") {
    const double number = value.is_number() ? value.get<double>() : -1;
    return number >= 0 && number <= 4294967295.0 && number == std::floor(number) && (request.tool = std::uint32_t(number), true);
  }
  if (key != "hole" || !value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) return false;
  request.hole = {value[0].get<double>(), value[1].get<double>()};
  return true;
}

/// Reads the request. Unknown keys and invalid values are refused, because the program will run on a machine.
tl::expected<MillRequest, Refusal> mill_request_in(const PageJson& question) {
  MillRequest request;
  for (const auto& [key, value] : question.items())
    if (!is_one_of(of_the_question, key) && !take_word(request, key, value))
      return tl::unexpected(Refusal{translated(texts::page::mill_not_understood, key)});
  if (!is_one_of(tasks, request.task)) return tl::unexpected(Refusal{translated(texts::page::mill_tasks)});
  if (!is_one_of(marks, request.mark)) return tl::unexpected(Refusal{translated(texts::page::mill_marks, marks[1], marks[2])});
  return request;
}

/// Returns the key of the request that the alarm concerns, such as "plunge_feed"; empty if the alarm concerns the drawing.
std::string word_of(const Alarm& alarm) {
  if (alarm.id == AlarmId::mill_stepover) return "stepover";
  if (alarm.id != AlarmId::mill_value) return {};
  std::string word(alarm.args[0].text());
  std::replace(word.begin(), word.end(), '-', '_');
  return word;
}

PageJson summary_json(const Milled& made, Lang lang) {
  PageJson lines = PageJson::array();
  for (const MillLine& line : mill_summary(made, lang)) lines.push_back({{"name", line.name}, {"value", line.value}});
  return lines;
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::mill(const PageJson& question) {
  const auto request = mill_request_in(question);
  if (!request) return tl::unexpected(request.error());
  const std::string file = value_in<std::string>(question, "drawing", "");
  const auto drawing = server.folder.read(file, limits::drawing_bytes);
  if (!drawing) return tl::unexpected(Refusal{drawing.error()});
  std::string control;
  if (const std::string fault = place_of(question, "control", control, true); !fault.empty()) return tl::unexpected(Refusal{fault});
  if (control.empty()) return tl::unexpected(Refusal{translated(texts::page::mill_names_no_control)});
  const auto def = load_control(control, &server.folder);
  if (!def) return tl::unexpected(Refusal{def.error()});
  const auto texts = AlarmTexts::load(&*def);
  if (!texts) return tl::unexpected(Refusal{texts.error()});
  const auto made = milled(*request, drawing->bytes, *def, {token(), {}});
  if (!made) {
    const DrawingFault& fault = made.error();
    if (fault.alarm.id == AlarmId::interrupted) return tl::unexpected(Refusal{translated(texts::page::interrupted)});
    const Finding finding = finding_of(report_of(fault, drawing->bytes, file), *texts, lang);
    return PageJson{{"problem", problem_json(finding, 0, std::nullopt)}, {"word", word_of(fault.alarm)}, {"line_text", finding.line_text}};
  }
  if (made->program.text.size() > max_made_bytes) return tl::unexpected(Refusal{translated(texts::page::too_long_to_mill)});
  std::string picture = milling_svg(mill_picture(*made, *def, name_of_file(file), lang));
  if (picture.size() > max_made_bytes) picture.clear();
  return PageJson{{"text", made->program.text},
                  {"picture", std::move(picture)},
                  {"summary", summary_json(*made, lang)},
                  {"warning", warning_of_holes(*made, lang)},
                  {"name", free_name(file, ".nc")}};
}

}  // namespace kadr
