// Questions of a page. For server/connection; tested by tests/view/page_session_test.cpp, tests/serve.py.

#include "view/page_session.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <set>

#include "config/control_file.h"
#include "config/told.h"
#include "view/page_json.h"
#include "view/source_text.h"

namespace kadr {
namespace {

constexpr std::uint64_t most_text = std::uint64_t{8} << 20;  // bytes: longer programs are looked at by lines, and not edited
constexpr std::uint32_t most_lines = 5000;
constexpr std::size_t most_passes = 1000, most_problems = 1000;
constexpr std::size_t most_again = 100'000;  // repetitions of faults that are known

/// An answer that is none: why.
struct Refusal {
  std::string text;
  bool changed = false;
};

/// A value of the question; `fallback` where it is missing or of another kind.
template <class T>
T value_in(const PageJson& question, const char* key, T fallback) {
  const auto found = question.find(key);
  if (found == question.end()) return fallback;
  if constexpr (std::is_same_v<T, std::string>) return found->is_string() ? found->template get<std::string>() : fallback;
  else return found->is_number() ? found->template get<T>() : fallback;
}

/// A count or a number of a line: what is none, or too great, is `fallback`.
std::uint32_t count_in(const PageJson& question, const char* key, std::uint32_t fallback) {
  const double value = value_in<double>(question, key, fallback);
  return value >= 0 && value <= 4e9 ? std::uint32_t(value) : fallback;
}

}  // namespace

struct PageSession::Inside {
  Inside(const PageServer& its_server, PageLine& its_line) : server(its_server), line(its_line), lang(its_server.lang) {}

  using Answer = tl::expected<PageJson, Refusal>;
  Answer answer(const std::string& what, const PageJson& question);
  Answer hello(const PageJson& question);
  Answer files(const PageJson& question);
  Answer open(const PageJson& question);
  Answer source_lines(const PageJson& question);
  Answer state(const PageJson& question);
  Answer passes(const PageJson& question);
  Answer check(const PageJson& question);
  Answer save(const PageJson& question);

  tl::expected<OpeningWish, Refusal> wish_of(const PageJson& question) const;
  void carry_out();
  void say(const PageJson& event) { gone = !line.text(dumped(event)) || gone; }
  PageJson problem(const AlarmReport& report) const { return problem_json(finding_of(report, *run->opened().texts, lang), report.origin.file); }
  void speak(const PageJson& question) {
    lang = value_in<std::string>(question, "lang", lang == Lang::ru ? "ru" : "en") == "ru" ? Lang::ru : Lang::en;
  }
  StopToken token() const { return StopToken(stops); }

  const PageServer& server;
  PageLine& line;
  Lang lang;
  std::atomic<bool> stops = false;
  bool greeted = false, may_change = false, gone = false;
  int mistakes = 0;
  std::set<std::string> opened_names;  // files that were opened: what may be saved over
  std::unique_ptr<SourceText> source;
  std::unique_ptr<ProgramRun> run;
  std::unique_ptr<Instants> instants;
};

PageSession::PageSession(const PageServer& server, PageLine& line) : inside_(std::make_unique<Inside>(server, line)) {}
PageSession::~PageSession() = default;

void PageSession::begin(bool stopped) { inside_->stops = stopped; }
void PageSession::stop() { inside_->stops = true; }

bool PageSession::asks_to_stop(std::string_view message) {
  if (message.size() > 200) return false;
  const auto json = PageJson::parse(message, nullptr, false);
  return json.is_object() && value_in<std::string>(json, "do", "") == "stop";
}

bool PageSession::take(std::string_view message) {
  Inside& in = *inside_;
  tell_here_in(in.lang);
  const auto question = PageJson::parse(message, nullptr, false);
  const PageJson id = question.is_object() && question.contains("id") && question["id"].is_number() ? question["id"] : PageJson();
  const auto wrong = [&](const std::string& text) {
    in.say({{"re", id}, {"error", {{"text", text}}}});
    return ++in.mistakes < most_mistakes;
  };
  if (!question.is_object() || id.is_null()) return wrong(told("no question: an object with `id` and `do` is wanted", "это не вопрос: нужен объект с `id` и `do`"));
  const std::string what = value_in<std::string>(question, "do", "");
  if (!in.greeted && what != "hello") return wrong(told("the first question is hello", "первый вопрос — hello"));
  Inside::Answer answer = in.answer(what, question);
  if (!answer && answer.error().text.empty()) return wrong(fmt::format("{}: {}", what, told("nothing of that name is known", "такого вопроса нет")));
  PageJson json = {{"re", id}};
  if (answer) json.update(*answer);
  else json["error"] = {{"text", answer.error().text}};
  if (!answer && answer.error().changed) json["error"]["changed"] = true;
  in.say(json);
  if (what == "open" && answer) in.carry_out();
  return !in.gone;
}

PageSession::Inside::Answer PageSession::Inside::answer(const std::string& what, const PageJson& question) {
  if (what == "hello") return hello(question);
  if (what == "language") return speak(question), tell_here_in(lang), PageJson::object();
  if (what == "files") return files(question);
  if (what == "open") return open(question);
  if (what == "stop") return PageJson::object();
  if (what == "save") return save(question);
  for (const char* const later : {"explain", "cut", "part", "proposals", "sheet", "compare"})
    if (what == later) return tl::unexpected(Refusal{what + ": " + told("not served yet", "пока не отвечает")});
  if (what != "source" && what != "state" && what != "passes" && what != "check") return tl::unexpected(Refusal{});
  if (!run) return tl::unexpected(Refusal{told("no program is open", "программа не открыта")});
  if (what == "source") return source_lines(question);
  if (what == "state") return state(question);
  return what == "passes" ? passes(question) : check(question);
}

PageSession::Inside::Answer PageSession::Inside::hello(const PageJson& question) {
  const bool knows = value_in<std::string>(question, "token", "") == server.token;
  if (server.all_need_token && !knows)
    return tl::unexpected(Refusal{told("this server is open to its printed address alone, with its token", "сервер отвечает только по напечатанному адресу с ключом")});
  greeted = true;
  may_change = knows;
  speak(question);
  tell_here_in(lang);
  PageJson controls = PageJson::array();
  for (const std::string& control : built_in_controls())
    if (const auto def = load_control(control)) controls.push_back({{"id", control}, {"name", lang == Lang::ru ? def->name.ru : def->name.en}});
  return PageJson{{"version", server.version}, {"folder", server.folder.name()}, {"may_change", may_change},
                  {"last", nullptr},         {"controls", std::move(controls)},  {"machines", built_in_machines()}};
}

PageSession::Inside::Answer PageSession::Inside::files(const PageJson& question) {
  const auto list = server.folder.list(value_in<std::string>(question, "folder", ""));
  if (!list) return tl::unexpected(Refusal{list.error()});
  return files_json(*list);
}

/// Files beneath the folder; a control or a machine is one of the built-in ones, or such a file.
tl::expected<OpeningWish, Refusal> PageSession::Inside::wish_of(const PageJson& question) const {
  OpeningWish wish;
  wish.lang = lang;
  wish.encoding = value_in<std::string>(question, "encoding", "");
  const auto place = [&](const char* key, std::string& to, bool may_be_a_name) -> std::string {
    const std::string name = value_in<std::string>(question, key, "");
    if (name.empty() || (may_be_a_name && !name.ends_with(".toml") && name.find('/') == std::string::npos)) return to = name, std::string();
    const auto path = server.folder.path_of(name);
    if (!path) return path.error();
    return to = *path, std::string();
  };
  for (const std::string& fault : {place("file", wish.path, false), place("control", wish.control, true), place("machine", wish.machine, true),
                                   place("setup", wish.setup, false)})
    if (!fault.empty()) return tl::unexpected(Refusal{fault});
  if (wish.path.empty()) return tl::unexpected(Refusal{told("open: no file is named", "open: файл не назван")});
  if (question.contains("text") && question["text"].is_string()) wish.text = question["text"].get<std::string>();
  return wish;
}

PageSession::Inside::Answer PageSession::Inside::open(const PageJson& question) {
  const auto wish = wish_of(question);
  if (!wish) return tl::unexpected(wish.error());
  const std::string file = value_in<std::string>(question, "file", "");
  const auto digest = server.folder.digest(file);
  if (!digest) return tl::unexpected(Refusal{digest.error()});
  auto opened = open_for_page(*wish);
  if (!opened) return tl::unexpected(Refusal{opened.error()});
  instants.reset(), run.reset(), source.reset();
  auto made = ProgramRun::make(*opened, token());
  if (!made) return tl::unexpected(Refusal{made.error()});
  run = std::move(*made);
  source = std::make_unique<SourceText>(opened->text ? OpenedText{text_source(*opened->text), Encoding::utf8} : open_text(wish->path, opened->encoding));
  opened_names.insert(file);
  const bool whole = source->bytes() <= most_text;
  PageJson control = {{"id", opened->def->id}, {"name", lang == Lang::ru ? opened->def->name.ru : opened->def->name.en}, {"guessed", opened->guess.has_value()}};
  control["decisive"] = !opened->guess || opened->guess->decisive;
  control["why"] = !opened->guess ? std::string() : lang == Lang::ru ? opened->guess->reason_ru : opened->guess->reason_en;
  PageJson json = {{"file", file},
                   {"size", source->bytes()},
                   {"digest", *digest},
                   {"encoding", name_of(source->encoding())},
                   {"control", std::move(control)},
                   {"machine", opened->machine.id},
                   {"setup", value_in<std::string>(question, "setup", "")},
                   {"editable", whole && may_change && source->encoding() == Encoding::utf8},
                   {"lines", source->lines()}};
  if (whole) json["text"] = source->whole();
  return json;
}

void PageSession::Inside::carry_out() {
  run->on_piece = [this](const ViewPiece& piece) {
    if (gone) return;
    gone = !line.frame(path_frame(piece, 0, 0)) || (!piece.directions.empty() && !line.frame(directions_frame(piece, 0, 0)));
    if (gone) stops = true;
  };
  run->on_alarm = [this](const AlarmReport& report, double at) { say({{"event", "alarm"}, {"at", at}, {"problem", problem(report)}}); };
  run->on_progress = [this](double part, std::uint64_t blocks, double seconds) {
    say({{"event", "progress"}, {"part", part}, {"blocks", blocks}, {"seconds", seconds}});
    if (gone) stops = true;
  };
  run->carry_out();
  PageJson done = {{"event", "done"}};
  done.update(done_json(*run, lang));
  say(done);
}

PageSession::Inside::Answer PageSession::Inside::source_lines(const PageJson& question) {
  const std::uint32_t from = count_in(question, "from", 1), count = std::min(count_in(question, "count", most_lines), most_lines);
  const std::uint32_t file = count_in(question, "file", 0);
  if (file == 0) return PageJson{{"lines", source->from(from, count)}};
  if (file >= run->control().files_read().size()) return tl::unexpected(Refusal{told("no such file", "такого файла нет")});
  std::set<std::uint32_t> numbers;
  for (std::uint32_t n = from; n < from + count; ++n) numbers.insert(numbers.end(), n);
  PageJson lines = PageJson::array();
  for (const auto& [number, text] : run->control().texts_of(numbers, std::uint16_t(file))) lines.push_back(text);
  return PageJson{{"lines", std::move(lines)}, {"name", run->control().file_name(std::uint16_t(file))}};
}

PageSession::Inside::Answer PageSession::Inside::state(const PageJson& question) {
  if (!instants) instants = std::make_unique<Instants>(*run);
  const auto state = instants->at(value_in<double>(question, "at", 0), token());
  if (!state) return tl::unexpected(Refusal{state.error()});
  PageJson json = state_json(*state, *run);
  json["file_name"] = server.folder.shown(state->line.file);
  return json;
}

PageSession::Inside::Answer PageSession::Inside::passes(const PageJson& question) {
  if (!instants) instants = std::make_unique<Instants>(*run);
  std::size_t count = 0;
  PageJson list = PageJson::array();
  for (const Instants::Pass& pass : instants->passes(count_in(question, "line", 0), std::uint16_t(count_in(question, "file", 0)), most_passes, count))
    list.push_back({{"from", pass.from}, {"to", pass.to}, {"number", pass.number}});
  return PageJson{{"passes", std::move(list)}, {"count", count}};
}

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
  const auto take = [&](const AlarmReport& report) {
    if (report.alarm.id == AlarmId::program_begins_again || report.alarm.id == AlarmId::passes_done) return true;
    if (!seen.insert({report.origin.line, report.origin.column, report.alarm.id}).second) return ++again < most_again;
    problems.push_back(problem(report));
    return report.alarm.id != AlarmId::interrupted && problems.size() < most_problems;
  };
  Outlets& outlets = (*session)->outlets();
  outlets.warning = [&](const AlarmReport& report) { (void)take(report); };
  outlets.alarm = take;
  outlets.stop = token();
  (*session)->control().set_waiting(Control::Waiting::pass);
  (void)(*session)->run();
  if (!stops) (*session)->control().check_uncalled([&](const AlarmReport& report) { (void)take(report); });
  return PageJson{{"problems", std::move(problems)}};
}

/// A program or set-up that was opened here, or a new file.
PageSession::Inside::Answer PageSession::Inside::save(const PageJson& question) {
  if (!may_change) return tl::unexpected(Refusal{told("open the page by its printed address to save", "чтобы сохранять, откройте страницу по напечатанному адресу")});
  const std::string file = value_in<std::string>(question, "file", "");
  if (!question.contains("text") || !question["text"].is_string()) return tl::unexpected(Refusal{told("save: no text", "save: нет текста")});
  const bool replaces = question.contains("digest") && question["digest"].is_string();
  if (replaces && !opened_names.contains(file)) return tl::unexpected(Refusal{file + ": " + told("was not opened here", "здесь не открывался")});
  const auto saved = server.folder.save(file, question["text"].get_ref<const std::string&>(),
                                        replaces ? std::optional(question["digest"].get<std::string>()) : std::nullopt);
  if (!saved) return tl::unexpected(Refusal{saved.error().text, saved.error().changed});
  opened_names.insert(file);
  return PageJson{{"digest", *saved}};
}

}  // namespace kadr
