// Answers the requests `examples`, `take_example` and `new_program`: the examples that are in the program, and the beginning of a new
// program. Used by view/page/page_session; tested by tests/serve_files.py.

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "config/control/control_file.h"
#include "config/embedded.h"
#include "config/tools/toml_tools.h"
#include "out/program/part_program.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::string_view folder_of_examples = "kadr-examples";

/// An example that is in the program.
struct Example {
  std::string program, control, machine;  // `program` is a file in `examples` of the source; `machine` may be empty
  std::string setup, tools;               // files in `examples`, or empty
  std::string title;                      // in the language of the page
};

std::vector<Example> all_examples(Lang lang) {
  std::vector<Example> all;
  const auto table = toml_tools::embedded_table("examples/offered.toml");
  const toml::array* const rows = table ? (*table)["example"].as_array() : nullptr;
  if (rows == nullptr) return all;
  for (const toml::node& node : *rows) {
    const toml::table* const row = node.as_table();
    if (row == nullptr) continue;
    const auto text = [&](const char* key) { return (*row)[key].value_or(std::string()); };
    Example example{text("program"), text("control"), text("machine"), text("setup"), text("tools"), text(lang == Lang::ru ? "ru" : "en")};
    if (embedded(fmt::format("examples/{}", example.program)) != nullptr) all.push_back(std::move(example));
  }
  return all;
}

std::string place_of_example(std::string_view name) { return fmt::format("{}/{}", folder_of_examples, name.substr(name.rfind('/') + 1)); }

/// The tools file of a program has the name of the program.
std::string place_of_tools(std::string_view program) {
  const std::string place = place_of_example(program);
  return place.substr(0, place.rfind('.')) + ".toml";
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::examples(const PageJson&) {
  PageJson list = PageJson::array();
  for (const Example& example : all_examples(lang))
    list.push_back({{"name", example.program}, {"control", example.control}, {"title", example.title}});
  return PageJson{{"examples", std::move(list)}};
}

/// Copies an example with its set-up and its tools to the folder `kadr-examples`. A copy that exists already, changed or not, remains.
PageSession::Inside::Answer PageSession::Inside::take_example(const PageJson& question) {
  if (!may_change) return refused(translated(texts::page::may_not_save));
  const std::string name = value_in<std::string>(question, "name", "");
  const std::vector<Example> all = all_examples(lang);
  const auto row = std::find_if(all.begin(), all.end(), [&](const Example& example) { return example.program == name; });
  if (row == all.end()) return refused(translated(texts::page::no_such_example, name));
  if (const auto made = server.folder.make_folder(std::string(folder_of_examples)); !made) return refused(made.error().text);
  for (const auto& [file, place] :
       {std::pair(row->program, place_of_example(row->program)), std::pair(row->setup, place_of_example(row->setup)),
        std::pair(row->tools, place_of_tools(row->program))}) {
    const EmbeddedFile* const content = file.empty() ? nullptr : embedded(fmt::format("examples/{}", file));
    if (content == nullptr) continue;
    const auto saved = server.folder.save(place, content->text, std::nullopt);
    if (!saved && !saved.error().changed) return refused(saved.error().text);
  }
  PageJson answer{{"file", place_of_example(row->program)}, {"control", row->control}};
  if (!row->machine.empty()) answer["machine"] = row->machine;
  if (!row->setup.empty()) answer["setup"] = place_of_example(row->setup);
  return answer;
}

/// Answers with a program that only begins and ends as the control requires. It is not saved here.
PageSession::Inside::Answer PageSession::Inside::new_program(const PageJson& question) {
  const std::string control = value_in<std::string>(question, "control", "");
  const auto known = built_in_controls();
  const auto def = std::find(known.begin(), known.end(), control) == known.end() ? tl::unexpected(std::string()) : load_control(control);
  if (!def) return refused(translated(texts::page::no_new_program, control));
  const auto text = bare_program(*def);
  if (!text) return refused(translated(texts::page::no_new_program, control));
  return PageJson{{"text", *text}};
}

}  // namespace kadr
