#pragma once
// The implementation of PageSession. The functions that answer requests are in several files, one file for each type of request
// (docs/panel-protocol.md).

#include <atomic>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "lang/text/tape.h"
#include "panel/panel_hub.h"
#include "texts/page.h"
#include "view/page/page_json.h"
#include "view/page/page_session.h"
#include "view/part_run.h"
#include "view/report/page_report.h"
#include "view/source_text.h"
#include "view/stock_guess.h"

namespace kadr {

struct PageConversion;
struct RealConnection;
struct Converted;

/// The reason why a request is refused, as the page receives it.
struct Refusal {
  std::string text;
  bool changed = false;
};
inline tl::unexpected<Refusal> refused(std::string text) { return tl::unexpected(Refusal{std::move(text)}); }

/// Returns a value from the request; `fallback` if the value is missing or has another type.
template <class T>
T value_in(const PageJson& question, const char* key, T fallback) {
  const auto found = question.find(key);
  if (found == question.end()) return fallback;
  if constexpr (std::is_same_v<T, std::string>) return found->is_string() ? found->template get<std::string>() : fallback;
  else if constexpr (std::is_same_v<T, bool>) return found->is_boolean() ? found->template get<bool>() : fallback;
  else return found->is_number() ? found->template get<T>() : fallback;
}

/// Returns a count or a line number from the request; `fallback` if the number is missing or too large.
inline std::uint32_t count_in(const PageJson& question, const char* key, std::uint32_t fallback) {
  const double value = value_in<double>(question, key, fallback);
  return value >= 0 && value <= 4e9 ? std::uint32_t(value) : fallback;
}

using PageAnswer = tl::expected<PageJson, Refusal>;

inline PageAnswer not_served(const std::string& what) { return tl::unexpected(Refusal{translated(texts::page::not_served, what)}); }

/// Returns the condition at which a program must stop, as the request states it.
StopPoint stop_point_of(const PageJson& question);

struct PageSession::Inside {
  Inside(const PageServer& its_server, PageLine& its_line) : server(its_server), line(its_line), lang(its_server.lang) {}

  using Answer = PageAnswer;
  Answer answer(const std::string& what, const PageJson& question);
  Answer language(const PageJson& question);
  Answer nothing(const PageJson&) { return PageJson::object(); }
  // ---- requests that are answered in page_folder.cpp
  Answer hello(const PageJson& question);
  Answer files(const PageJson& question);
  Answer read(const PageJson& question);
  Answer save(const PageJson& question);
  // ---- requests that are answered in page_changes.cpp
  Answer digest(const PageJson& question);
  Answer rename(const PageJson& question);
  Answer copy(const PageJson& question);
  Answer remove(const PageJson& question);
  Answer restore_file(const PageJson& question);
  Answer trash(const PageJson& question);
  Answer empty_trash(const PageJson& question);
  std::string fault_of_change(const std::string& file) const;
  // ---- requests that are answered in page_examples.cpp
  Answer examples(const PageJson& question);
  Answer take_example(const PageJson& question);
  Answer new_program(const PageJson& question);
  // ---- requests that are answered in page_program.cpp
  Answer open(const PageJson& question);
  Answer source_lines(const PageJson& question);
  Answer state(const PageJson& question);
  Answer passes(const PageJson& question);
  // ---- requests that are answered in page_check.cpp
  Answer check(const PageJson& question);
  Answer explain(const PageJson& question);
  // ---- requests that are answered in page_outline.cpp
  Answer outline(const PageJson& question);
  // ---- requests that are answered in page_part.cpp
  Answer cut(const PageJson& question);
  Answer part(const PageJson& question);
  Answer proposals(const PageJson& question);
  Answer keep_tools(const PageJson& question);
  void take_setup_blank(PageJson& json) const;
  PageJson kept_tools_file() const;
  void cut_part();
  // ---- requests that are answered in page_setup.cpp
  Answer setup_form(const PageJson& question);
  Answer keep_setup(const PageJson& question);
  std::optional<FileText> setup_file(const std::string& file) const;
  // ---- requests that are answered in page_sheet.cpp
  Answer sheet(const PageJson& question);
  // ---- requests that are answered in page_reporting.cpp
  Answer report(const PageJson& question);
  // ---- requests that are answered in page_compare.cpp
  Answer compare(const PageJson& question);
  // ---- requests that are answered in page_making.cpp and page_tape.cpp
  Answer mill(const PageJson& question);
  Answer tape(const PageJson& question);
  Answer punch(const PageJson& question, std::optional<TapeCode> code) const;
  Answer read_punched(const std::string& file, std::optional<TapeCode> code) const;
  // ---- requests that are answered in page_conversion.cpp
  Answer convert(const PageJson& question);
  Answer conversion_answer(const PageConversion& conversion, const Converted& made, const SourceText& text, const PageJson& question) const;
  // ---- requests that are answered in page_edit.cpp and page_blocks.cpp
  Answer edit_program(const PageJson& question);
  Answer write_blocks(const PageJson& question);
  // ---- requests that are answered in page_panel.cpp
  Answer machines(const PageJson& question);
  Answer machine(const PageJson& question);
  Answer panel(const PageJson& question);
  Answer machine_source(const PageJson& question);
  Answer press(const PageJson& question);
  Answer switches(const PageJson& question);
  Answer enter(const PageJson& question);
  Answer undo(const PageJson& question);
  Answer jog(const PageJson& question);
  Answer jogging(const PageJson& question);
  Answer stops_at(const PageJson& question);
  Answer answer_to_machine(const PageJson& question);
  Answer watch(const PageJson& question);
  void note(const char* kind, const std::string& text, std::uint32_t line) const;
  // ---- requests that are answered in page_drive.cpp
  Answer ports(const PageJson& question);
  Answer prove_machine(const PageJson& question);
  Answer probe(const PageJson& question);
  std::string keep(const char* what, const std::string& text) const;
  tl::expected<RealConnection, Refusal> connect_for(const PageJson& question, OpenedProgram& opened) const;
  tl::expected<std::shared_ptr<PanelHub::HubMachine>, Refusal> switch_on(const std::string& file, const PageJson& question);
  // ---- requests that are answered in page_tables.cpp
  Answer tables(const PageJson& question);
  Answer edit(const PageJson& question);
  Answer keep_tables(const PageJson& question);
  Answer shift(const PageJson& question);
  // ---- requests that are answered in page_restart.cpp
  Answer restart(const PageJson& question);
  Answer go_there(const PageJson& question);
  Answer move_along_path(const PageJson& question);
  tl::expected<PanelSearch::Answer, Refusal> find_place(PanelMachine& machine, const PageJson& question) const;
  bool is_machine_on(const std::string& file) const;
  void leave_machine();
  void stop_machine();
  tl::expected<PanelMachine*, Refusal> held_machine() const;

  tl::expected<OpeningRequest, Refusal> opening_request_in(const PageJson& question) const;
  /// Sets `to` to the path of the file that the request names at `key`. If `may_be_a_name` is true, the value may also be the name of a
  /// built-in control or machine.
  ///   returns  an error sentence; empty if `to` has been set
  std::string place_of(const PageJson& question, const char* key, std::string& to, bool may_be_a_name) const;
  /// Returns the name of a file that does not exist yet: the name `like` with the given ending, and a number if the name is already used.
  std::string free_name(const std::string& like, const std::string& ending) const;
  void execute();
  /// Sends a segment of the path as frames; `which` is the path's number in the protocol. If the page is closed, the current work ends.
  void send(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);
  void send(const PageJson& event) { gone = !line.text(dumped(event)) || gone; }
  PageJson problem(const AlarmReport& report) const {
    PageJson json = problem_json(finding_of(report, *run->opened().texts, lang), report.origin.file, quick_fix(report, lang));
    if (report.origin.file != 0) json["file_name"] = server.folder.shown(report.file);
    return json;
  }
  bool is_memory_full() const;
  static std::string memory_full_message();
  /// If all sessions of the server together use too much memory, reports this to the page, and ends the current work and this session.
  void end_if_memory_is_full();
  /// Makes the file paths in a list of calls relative to the served folder, because the page displays them.
  void show_files(PageJson& calls) const;
  PageJson problem_of_channel(const AlarmReport& report, int channel) const;
  void speak(const PageJson& question) { lang = language_named(value_in<std::string>(question, "lang", id_of(lang))).value_or(Lang::en); }
  StopToken token() const { return StopToken(stops); }

  const PageServer& server;
  PageLine& line;
  Lang lang;
  std::atomic<bool> stops = false;
  std::function<void()> afterwards;  // work that the request has started; it is executed after the answer has been sent
  bool greeted = false, gone = false;
  std::atomic<bool> may_change = false;
  int mistakes = 0;
  std::set<std::string> opened_names;  // names of the files that this page has opened; the page may overwrite only these files
  OpeningRequest opened_request;
  std::unique_ptr<SourceText> source;
  // Texts of the files with called subprograms; the key is Origin::file.
  std::map<std::uint32_t, std::unique_ptr<SourceText>> called_sources;
  std::unique_ptr<ProgramRun> run;
  std::unique_ptr<Instants> instants;
  StockGuess guess;
  std::unique_ptr<PartRun> part_run;      // the run that cuts the blank; nullptr if nothing has been cut yet
  std::vector<ReportPart::Hit> cut_hits;  // findings of that run
  std::uint64_t page = 0;  // number of this page in the hub of the panel machines; 0 if the page has not displayed a machine yet
  std::mutex place_lock;   // mutex for hub_machine, which another thread uses for an emergency stop
  std::shared_ptr<PanelHub::HubMachine> hub_machine;
};

}  // namespace kadr
