// Handles the requests of a page (PageSession). Used by server/connection; tested by tests/serve.py.

#include "view/page/page_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "config/json_text.h"
#include "texts/page.h"
#include "view/memory_bound.h"
#include "view/page/page_inside.h"

namespace kadr {

PageSession::PageSession(const PageServer& server, PageLine& line) : inside_(std::make_unique<Inside>(server, line)) {}
PageSession::~PageSession() { inside_->leave_machine(); }

void PageSession::begin(bool stopped) { inside_->stops = stopped; }
void PageSession::stop() { inside_->stops = true; }

bool PageSession::asks_to_stop(std::string_view message) {
  if (message.size() > 200) return false;
  const auto json = ordered_json_of(message);
  return json.is_object() && value_in<std::string>(json, "do", "") == "stop";
}

bool PageSession::asks_for_emergency(std::string_view message) {
  if (message.size() > 200) return false;
  const auto json = ordered_json_of(message);
  return json.is_object() && value_in<std::string>(json, "do", "") == "press" && value_in<std::string>(json, "key", "") == "emergency";
}

void PageSession::emergency() { inside_->stop_machine(); }

bool PageSession::take(std::string_view message) {
  Inside& in = *inside_;
  set_thread_language(in.lang);
  const auto question = ordered_json_of(message);
  const PageJson id = question.is_object() && question.contains("id") && question["id"].is_number() ? question["id"] : PageJson();
  const auto wrong = [&](const std::string& text) {
    in.send({{"re", id}, {"error", {{"text", text}}}});
    if (++in.mistakes < max_mistakes) return true;
    in.send({{"event", "closed"}, {"text", translated(texts::page::too_many_mistakes)}});
    return false;
  };
  if (!question.is_object() || id.is_null()) return wrong(translated(texts::page::no_question));
  const std::string what = value_in<std::string>(question, "do", "");
  if (!in.greeted && what != "hello") return wrong(translated(texts::page::hello_first));
  Inside::Answer answer = in.answer(what, question);
  if (!answer && answer.error().text.empty()) return wrong(translated(texts::page::unknown_question, what));
  PageJson json = {{"re", id}};
  if (answer) json.update(*answer);
  else json["error"] = {{"text", answer.error().text}};
  if (!answer && answer.error().changed) json["error"]["changed"] = true;
  in.send(json);
  if (answer && in.afterwards) std::exchange(in.afterwards, nullptr)();
  return !in.gone;
}

PageSession::Inside::Answer PageSession::Inside::answer(const std::string& what, const PageJson& question) {
  struct Known {
    std::string_view name;
    Answer (Inside::*answer)(const PageJson&);
    bool of_program;     // true if the request needs an open program
    bool heavy = false;  // true if the request may need much memory
  };
  static constexpr Known all[] = {
      {"hello", &Inside::hello, false},
      {"language", &Inside::language, false},
      {"files", &Inside::files, false},
      {"open", &Inside::open, false, true},
      {"stop", &Inside::nothing, false},
      {"save", &Inside::save, false},
      {"read", &Inside::read, false},
      {"digest", &Inside::digest, false},
      {"rename", &Inside::rename, false},
      {"copy", &Inside::copy, false},
      {"delete", &Inside::remove, false},
      {"restore", &Inside::restore_file, false},
      {"trash", &Inside::trash, false},
      {"empty_trash", &Inside::empty_trash, false},
      {"examples", &Inside::examples, false},
      {"take_example", &Inside::take_example, false},
      {"new_program", &Inside::new_program, false},
      {"source", &Inside::source_lines, true},
      {"state", &Inside::state, true},
      {"passes", &Inside::passes, true},
      {"check", &Inside::check, true},
      {"explain", &Inside::explain, true},
      {"outline", &Inside::outline, true},
      {"cut", &Inside::cut, true, true},
      {"part", &Inside::part, true},
      {"proposals", &Inside::proposals, true},
      {"keep_tools", &Inside::keep_tools, true},
      {"sheet", &Inside::sheet, true},
      {"report", &Inside::report, true, true},
      {"setup_form", &Inside::setup_form, true},
      {"keep_setup", &Inside::keep_setup, true},
      {"compare", &Inside::compare, true, true},
      {"machines", &Inside::machines, false},
      {"machine", &Inside::machine, false, true},
      {"ports", &Inside::ports, false},
      {"prove", &Inside::prove_machine, false, true},
      {"panel", &Inside::panel, false},
      {"machine_source", &Inside::machine_source, false},
      {"press", &Inside::press, false},
      {"switches", &Inside::switches, false},
      {"enter", &Inside::enter, false},
      {"undo", &Inside::undo, false},
      {"jog", &Inside::jog, false},
      {"jogging", &Inside::jogging, false},
      {"probe", &Inside::probe, false},
      {"stops", &Inside::stops_at, false},
      {"restart", &Inside::restart, false},
      {"go_there", &Inside::go_there, false},
      {"lead", &Inside::move_along_path, false},
      {"tables", &Inside::tables, false},
      {"edit", &Inside::edit, false},
      {"keep_tables", &Inside::keep_tables, false},
      {"shift", &Inside::shift, false},
      {"answer", &Inside::answer_to_machine, false},
      {"watch", &Inside::watch, false},
      {"mill", &Inside::mill, false, true},
      {"tape", &Inside::tape, false, true},
      {"convert", &Inside::convert, false, true},
      {"edit_program", &Inside::edit_program, false, true},
      {"write_blocks", &Inside::write_blocks, true},
  };
  const auto* const known = std::find_if(std::begin(all), std::end(all), [&](const Known& k) { return k.name == what; });
  if (known == std::end(all)) return tl::unexpected(Refusal{});
  if (known->of_program && !run) return tl::unexpected(Refusal{translated(texts::page::no_program_open)});
  if (known->heavy && is_memory_full()) return tl::unexpected(Refusal{memory_full_message()});
  return (this->*known->answer)(question);
}

bool PageSession::Inside::is_memory_full() const { return server.memory != nullptr && server.memory->is_full(); }

std::string PageSession::Inside::memory_full_message() { return translated(texts::page::memory_full); }

void PageSession::Inside::end_if_memory_is_full() {
  if (gone || !is_memory_full()) return;
  send({{"event", "closed"}, {"text", memory_full_message()}});
  gone = stops = true;
}

void PageSession::Inside::show_files(PageJson& calls) const {
  for (PageJson& call : calls)
    if (call["file"].is_string()) call["file"] = server.folder.shown(call["file"].get<std::string>());
}

PageSession::Inside::Answer PageSession::Inside::language(const PageJson& question) {
  speak(question);
  set_thread_language(lang);
  return PageJson::object();
}

}  // namespace kadr
