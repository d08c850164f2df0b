// Questions about a text: check, explain. For view/page_session; tested by tests/serve.py.

#include "out/text/line_words.h"
#include "session/checklist/checklist.h"
#include "view/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t most_problems = 1000;
constexpr std::size_t most_again = 100'000;     // repetitions of faults that are known
constexpr std::size_t most_explained = 10'000;  // bytes of a line

}  // namespace

/// Past its faults, each once, as kadr check does.
PageSession::Inside::Answer PageSession::Inside::check(const PageJson& question) {
  auto program = run->opened().program_of(value_in<std::string>(question, "text", ""));
  if (!program) return tl::unexpected(Refusal{program.error()});
  SessionSpec spec = run->opened().spec(std::move(*program), token());
  spec.limits.restarts = 0;
  spec.setup.channels.clear();
  auto session = Session::open(std::move(spec));
  if (!session) return tl::unexpected(Refusal{told(session.error().fault.en, session.error().fault.ru)});
  PageJson problems = PageJson::array();
  std::set<std::tuple<std::uint32_t, std::uint32_t, AlarmId>> seen;
  std::size_t again = 0;
  bool alarms = false;
  const auto take = [&](const AlarmReport& report) {
    if (report.alarm.id == AlarmId::program_begins_again || report.alarm.id == AlarmId::passes_done) return true;
    if (!seen.insert({report.origin.line, report.origin.column, report.alarm.id}).second) return ++again < most_again;
    alarms = alarms || report.alarm.severity == Severity::alarm;
    problems.push_back(problem(report));
    return report.alarm.id != AlarmId::interrupted && problems.size() < most_problems;
  };
  Outlets& outlets = (*session)->outlets();
  outlets.warning = [&](const AlarmReport& report) { (void)take(report); };
  outlets.alarm = take;
  outlets.stop = token();
  Checklist checklist(**session, (*session)->own(), {run->opened().tools, run->opened().number == 0, run->opened().number == 0});
  checklist.attach();
  (*session)->control().set_waiting(Control::Waiting::pass);
  (void)(*session)->run();
  if (!stops) (*session)->control().check_uncalled([&](const AlarmReport& report) { (void)take(report); });
  if (!stops && !alarms)
    for (const AlarmReport& report : checklist.reports(token())) (void)take(report);
  return PageJson{{"problems", std::move(problems)}};
}

/// The words of a line as it stands in the editor, or in the file.
PageSession::Inside::Answer PageSession::Inside::explain(const PageJson& question) {
  std::string text;
  if (question.contains("text")) {
    text = value_in<std::string>(question, "text", "");
  } else if (const auto lines = source->from(count_in(question, "line", 0), 1); !lines.empty()) {
    text = lines.front();
  }
  if (text.size() > most_explained) text.resize(most_explained);
  PageJson words = PageJson::array();
  for (const LineWord& w : words_of_line(*run->opened().def, *run->opened().texts, text, lang))
    words.push_back({{"from", w.from}, {"to", w.to}, {"code", w.code}, {"title", w.title}, {"text", w.text}});
  return PageJson{{"words", std::move(words)}};
}

}  // namespace kadr
