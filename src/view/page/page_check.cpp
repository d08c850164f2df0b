// Answers the requests `check` and `explain`, about the text of a program. Used by view/page/page_session; tested by tests/serve.py.

#include <algorithm>

#include "config/machine/machine_codes.h"
#include "out/text/explain/line_words.h"
#include "session/checklist/program_check.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_problems = 1000;
constexpr std::size_t max_explained = 10'000;  // greatest length in bytes of a line that is explained; the rest of a longer line is ignored

/// Returns the name that the machine's file gives to an M code; nullptr if it gives none, or if the control executes the code itself.
const Text* name_by_machine(const OpenedProgram& opened, const std::string& code) {
  const auto found = std::find_if(opened.machine.m_codes.begin(), opened.machine.m_codes.end(),
                                  [&](const auto& named) { return "M" + std::to_string(named.first) == code; });
  if (found == opened.machine.m_codes.end()) return nullptr;
  const CodeRow* const row = machine_row(*opened.def, found->first);
  return row == nullptr || row->function == Function::machine_function ? &found->second : nullptr;
}

}  // namespace

/// Checks the text of the request. The answer contains the findings of `kadr check` for this text, in the same order.
PageSession::Inside::Answer PageSession::Inside::check(const PageJson& question) {
  auto program = run->opened().program_of(value_in<std::string>(question, "text", ""));
  if (!program) return tl::unexpected(Refusal{program.error()});
  SessionSpec spec = run->opened().spec(std::move(*program), token());
  spec.limits.restarts = 0;
  spec.setup.channels.clear();
  auto session = Session::open(std::move(spec));
  if (!session) return tl::unexpected(Refusal{in_thread_language(session.error().fault.en, session.error().fault.ru)});
  PageJson problems = PageJson::array();
  ProgramCheck({.stated = run->opened().stated,
                .basis = {run->opened().tools, run->opened().number == 0, run->opened().number == 0},
                .stop = token()},
               [&](std::size_t, const AlarmReport& report) {
                 problems.push_back(problem(report));
                 return problems.size() < max_problems;
               })
      .check(**session);
  return PageJson{{"problems", std::move(problems)}};
}

/// Explains the words of a program line. The request contains the text of the line, or the number of the line in the file.
PageSession::Inside::Answer PageSession::Inside::explain(const PageJson& question) {
  std::string text;
  if (question.contains("text")) {
    text = value_in<std::string>(question, "text", "");
  } else if (const auto lines = source->from(count_in(question, "line", 0), 1); !lines.empty()) {
    text = lines.front();
  }
  if (text.size() > max_explained) text.resize(max_explained);
  PageJson words = PageJson::array();
  for (LineWord& w : words_of_line(*run->opened().def, *run->opened().texts, text, lang)) {
    if (const Text* const named = name_by_machine(run->opened(), w.code)) w.title = lang == Lang::ru ? named->ru : named->en;
    words.push_back({{"from", w.from}, {"to", w.to}, {"code", w.code}, {"title", w.title}, {"text", w.text}});
  }
  return PageJson{{"words", std::move(words)}};
}

}  // namespace kadr
