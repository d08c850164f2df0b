// Answers the requests `hello`, `files`, `read` and `save`, about the served folder. Used by view/page/page_session; tested by
// tests/serve.py.

#include <fmt/core.h>

#include "config/control/control_file.h"
#include "out/text/base64.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_read = std::size_t{8} << 20;  // greatest size in bytes of a file that can be read

/// Returns the contents to be saved from the request; nullopt if the request has neither text nor bytes, or has both.
std::optional<std::string> text_to_save(const PageJson& question) {
  const auto text = question.find("text"), bytes = question.find("bytes");
  if ((text == question.end()) == (bytes == question.end())) return std::nullopt;
  if (text != question.end()) return text->is_string() ? std::optional(text->get<std::string>()) : std::nullopt;
  return bytes->is_string() ? bytes_of_base64(bytes->get_ref<const std::string&>()) : std::nullopt;
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::hello(const PageJson& question) {
  const bool knows = value_in<std::string>(question, "token", "") == server.token;
  if (server.all_need_token && !knows) return tl::unexpected(Refusal{translated(texts::page::token_wanted)});
  greeted = true;
  may_change = knows;
  speak(question);
  set_thread_language(lang);
  const std::string last = server.last != nullptr ? server.last->get() : std::string();
  PageJson controls = PageJson::array();
  for (const std::string& control : built_in_controls())
    if (const auto def = load_control(control))
      controls.push_back({{"id", control}, {"name", lang == Lang::ru ? def->name.ru : def->name.en}});
  return PageJson{{"version", server.version},       {"folder", server.folder.name()},
                  {"may_change", may_change.load()}, {"last", last.empty() ? PageJson() : PageJson(last)},
                  {"controls", std::move(controls)}, {"machines", built_in_machines()}};
}

PageSession::Inside::Answer PageSession::Inside::files(const PageJson& question) {
  const auto list = server.folder.list(value_in<std::string>(question, "folder", ""));
  if (!list) return tl::unexpected(Refusal{list.error()});
  return files_json(*list);
}

/// Answers with the text of another file, which the page compares or edits.
PageSession::Inside::Answer PageSession::Inside::read(const PageJson& question) {
  const std::string file = value_in<std::string>(question, "file", "");
  const auto found = server.folder.read(file, max_read);
  if (!found) return tl::unexpected(Refusal{found.error()});
  const SourceText source_text(as_text(text_source(found->bytes)));
  std::string text = source_text.whole();
  if (text.find('\0') != std::string::npos) return tl::unexpected(Refusal{translated(texts::page::not_a_text, file)});
  return PageJson{{"text", std::move(text)}, {"digest", found->digest}, {"encoding", name_of(source_text.encoding())}};
}

std::string PageSession::Inside::free_name(const std::string& like, const std::string& ending) const {
  const std::size_t last = like.find_last_of('/') == std::string::npos ? 0 : like.find_last_of('/') + 1;
  const std::size_t dot = like.find_last_of('.');
  const std::string front = dot == std::string::npos || dot <= last ? like : like.substr(0, dot);
  constexpr int max_tries = 1000;
  std::string name = front + ending;
  for (int i = 2; i < max_tries && server.folder.path_of(name); ++i) name = fmt::format("{}_{}{}", front, i, ending);
  return name;
}

/// Saves a new file, or a file that this page has opened. The contents are a text, or the rows of a punched tape in base64.
PageSession::Inside::Answer PageSession::Inside::save(const PageJson& question) {
  if (!may_change) return tl::unexpected(Refusal{translated(texts::page::may_not_save)});
  const std::string file = value_in<std::string>(question, "file", "");
  const auto text = text_to_save(question);
  if (!text) return tl::unexpected(Refusal{translated(texts::page::nothing_to_save)});
  const bool replaces = question.contains("digest") && question["digest"].is_string();
  if (replaces && !opened_names.contains(file)) return tl::unexpected(Refusal{translated(texts::page::not_opened_here, file)});
  const auto saved = server.folder.save(file, *text, replaces ? std::optional(question["digest"].get<std::string>()) : std::nullopt);
  if (!saved) return tl::unexpected(Refusal{saved.error().text, saved.error().changed});
  opened_names.insert(file);
  return PageJson{{"digest", *saved}};
}

}  // namespace kadr
