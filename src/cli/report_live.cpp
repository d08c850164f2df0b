// Collects the files of a program for a live report: program, set-up, tools, control, machine, called subprograms, bodies. Used by
// cli/report_run; tested by tests/report.py and web/e2e/alone_live.mjs.

#include "cli/report_live.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "config/json_text.h"
#include "config/read_file.h"
#include "texts/live_report.h"
#include "view/report/live_report.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_page = 64u << 20;   // greatest size in bytes of the page
constexpr std::size_t most_file = 512u << 20;  // greatest size in bytes of a program or a body

/// The files of the report. A file below the folder of the program keeps its place there; another one lies next to the program.
class Collected {
 public:
  explicit Collected(const std::string& program) : folder_(fs::absolute(program).parent_path()) {}

  std::string place_of(const std::string& path) const {
    const fs::path below = fs::absolute(path).lexically_normal().lexically_relative(folder_.lexically_normal());
    return below.empty() || *below.begin() == ".." ? fs::path(path).filename().string() : below.generic_string();
  }
  /// Adds a file, at `place` or where place_of() puts it. Without a path, or if the file has been added, does nothing.
  void add(const std::string& path, std::string place = {}) {
    if (path.empty() || !fault.empty()) return;
    if (place.empty()) place = place_of(path);
    if (!places_.insert(place).second) return;
    auto bytes = read_file(path, most_file);
    if (!bytes) fault = bytes.error();
    else files.push_back({std::move(place), std::move(*bytes)});
  }

  std::vector<LiveFile> files;
  std::string fault;  // why a file cannot be read; empty if all could

 private:
  fs::path folder_;
  std::set<std::string> places_;
};

/// Adds the mesh of a body, if the body is a mesh. Returns the body as the page states it.
std::string take_body(const std::string& body, Collected& to) {
  std::error_code none;
  if (!fs::is_regular_file(body, none)) return body;
  to.add(body);
  return to.place_of(body);
}

/// Adds the set-up with the blank and the fixtures that the options state. Returns its place; empty if there is nothing to state.
std::string take_setup(const ReportOptions& options, const Job& job, Collected& to) {
  if (options.cut.stock.empty()) {
    to.add(job.setup_file);
    return job.setup_file.empty() ? std::string() : to.place_of(job.setup_file);
  }
  const auto text = job.setup_file.empty() ? std::string("{}") : read_file(job.setup_file).value_or("{}");
  auto json = ordered_json_of(text);
  if (!json.is_object()) json = nlohmann::ordered_json::object();
  json["stock"] = take_body(options.cut.stock, to);
  if (!options.cut.fixtures.empty()) json["fixtures"] = nlohmann::ordered_json::array();
  for (const std::string& fixture : options.cut.fixtures) json["fixtures"].push_back(take_body(fixture, to));
  const std::string place = to.place_of(job.setup_file.empty() ? fs::path(job.file).replace_extension(".json").string() : job.setup_file);
  to.files.push_back({place, json_text(json, 2) + "\n"});
  return place;
}

}  // namespace

std::string live_fault_message(const ReportOptions& options) {
  const Options& run = options.cut.run;
  if (run.programs.front() == "-") return translated(texts::live_report::from_input);
  const bool by_options = !run.tools.empty() || !run.zeros.empty() || !run.correctors.empty() || !run.skip.empty() || run.optional_stop;
  return by_options ? translated(texts::live_report::by_setup) : std::string();
}

tl::expected<std::string, std::string> live_report(const ReportOptions& options, const Job& job, const std::vector<std::string>& called) {
  const auto page = read_file(options.live, most_page);
  if (!page) return tl::unexpected(page.error());
  if (!is_page_alone(*page)) return tl::unexpected(translated(texts::live_report::no_page, options.live));
  Collected collected(job.file);
  const std::string& machine = options.cut.run.machine;
  const bool own_control = options.cut.run.control.ends_with(".toml"), own_machine = machine.ends_with(".toml");
  collected.add(job.file);
  const std::string setup = take_setup(options, job, collected);
  if (own_control) collected.add(options.cut.run.control);
  if (own_machine) collected.add(machine);
  collected.add(options.cut.tools, collected.place_of(fs::path(job.file).replace_extension(".toml").string()));
  for (const std::string& file : called) collected.add(file);
  if (!collected.fault.empty()) return tl::unexpected(collected.fault);
  const LiveOpening opening{collected.place_of(job.file), own_control ? collected.place_of(options.cut.run.control) : job.def->id,
                            own_machine ? collected.place_of(machine) : machine, setup};
  return live_report_html(*page, opening, collected.files);
}

}  // namespace kadr::cli
