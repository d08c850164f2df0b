// Loads blank, fixtures, tools and target part. This file is used by cli/cut.

#include "cli/cut_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "cli/cut_guess.h"
#include "cli/cut_portion.h"
#include "cli/job/terminal.h"
#include "config/setup/setup_names.h"
#include "session/cutting/cut_cells.h"
#include "session/cutting/named_body.h"
#include "stock/mesh/mesh_file.h"
#include "texts/cut_command.h"

namespace kadr::cli {
namespace {

constexpr double bytes_per_mb = 1 << 20;

/// Reads the value of --until. For a time ("12.5s") the function returns the seconds. For a line number it stores the line in `line` and
/// returns 1e300, which means that there is no time limit. An empty text also returns 1e300, and any other text returns nullopt.
std::optional<double> seconds_of(const std::string& text, std::string& line) {
  if (text.empty()) return 1e300;
  if (!text.ends_with('s')) {
    const bool is_line = text.find_first_not_of("0123456789") == std::string::npos && text.size() < 10;
    return is_line ? (line = text, std::optional(1e300)) : std::nullopt;
  }
  double seconds = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size() - 1, seconds);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() - 1 || !(seconds >= 0)) return std::nullopt;
  return seconds;
}

/// Reads a solid that the command line describes. If an error occurs, it is printed and the function returns nullptr.
std::shared_ptr<const Blank> named_body(const char* option, const std::string& text, double most) {
  const auto named = body_of(text, most);
  if (!named) {
    complain(fmt::format("{} {}", option, named.error()));
    return nullptr;
  }
  for (const std::string& note : named->notes) write_message(note + "\n");
  return named->body;
}

/// Determines the window from --window, and the cell sizes of the window and of the whole blank. --resolution is the cell size of the
/// window or, without a window, of the blank. If an error occurs, it is printed and the function returns false.
bool find_lattices(const CutOptions& options, const std::optional<Mesh>& part, double most, CutJob& job) {
  std::optional<Box3> window;
  if (!options.window.empty()) {
    const auto box = window_of(options.window);
    if (!box) {
      complain("--window " + box.error());
      return false;
    }
    window = *box;
  }
  if (!find_cells(options.resolution, window, most, job)) {
    complain(translated(texts::cut_command::window_beside_blank, options.window));
    return false;
  }
  if (part && !part_meets_window(job, *part)) {
    complain(translated(texts::cut_command::window_beside_part));
    return false;
  }
  return true;
}

/// Chooses the cell size and creates the stock within the memory limit. If an error occurs, it is printed and the function returns false.
bool find_material(const CutOptions& options, const std::optional<Mesh>& part, CutJob& job) {
  const double most = options.max_memory * bytes_per_mb;
  job.blank = named_body("--stock", options.stock, most);
  if (!job.blank) return false;
  if (job.blank->overlaps()) write_message(translated(texts::cut_command::bodies_overlap, options.stock) + "\n");
  for (const std::string& text : options.fixtures)
    if (!job.fixtures.emplace_back(named_body("--fixture", text, most))) return false;
  if (!find_lattices(options, part, most, job) || !find_bricks(options, job)) return false;
  const double bytes = bytes_of_material(job, nullptr), with_part = bytes_of_material(job, part ? &*part : nullptr);
  if (with_part <= most) return true;
  if (bytes > most) complain(translated(texts::cut_command::material_too_large, bytes / bytes_per_mb));
  else complain(translated(texts::cut_command::material_and_part_too_large, with_part / bytes_per_mb));
  return false;
}

/// Reads the tools, unless they were guessed before. The tools are read before the stock is created, since the cell size depends on them.
/// If an error occurs, it is printed and the function returns false.
bool find_tools(const CutOptions& options, CutJob& job) {
  if (options.tools == guess_word) return true;
  auto tools = load_tools(options.tools);
  if (!tools) {
    complain(tools.error());
    return false;
  }
  for (const std::string& note : tools->notes) write_message(note + "\n");
  job.tools = std::move(*tools);
  return true;
}

}  // namespace

bool find_tools_and_end(CutOptions& options, CutJob& job) {
  const auto until = seconds_of(options.until, options.run.to);
  if (!until) {
    complain(translated(texts::cut_command::until_wrong, options.until));
    return false;
  }
  job.until = *until;
  job.stop = options.run.limits.stop;
  job.wants_coolant = options.coolant;
  return find_tools(options, job);
}

bool find_part(const CutOptions& options, std::optional<Mesh>& part) {
  if (options.part.empty()) {
    const char* const lonely = options.allow >= 0                  ? "--allow"
                               : options.allow_left >= 0           ? "--allow-left"
                               : !options.deviation.empty()        ? "--deviation"
                               : options.run.colour == "deviation" ? "--colour deviation"
                                                                   : nullptr;
    if (lonely != nullptr) complain(translated(texts::cut_command::part_missing, lonely));
    return lonely == nullptr;
  }
  MeshRules rules;
  rules.memory = std::size_t(options.max_memory * bytes_per_mb);
  auto solid = read_mesh_file(options.part, rules);
  if (!solid) {
    complain("--part " + solid.error());
    return false;
  }
  for (const std::string& note : solid->notes) write_message(note + "\n");
  part = std::move(solid->mesh);
  return true;
}

bool find_cut_job(CutOptions& options, CutJob& job, const std::optional<Mesh>& part) {
  if (!find_material(options, part, job)) return false;
  job.threads = options.threads > 0 ? options.threads : threads_at_once();
  job.keeps_rates = options.run.colour == "load";
  return true;
}

bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint16_t>& system) {
  if (options.stock_zero.empty()) return true;
  const std::vector<std::string> names = system_names(*job.def);
  const auto found = std::find(names.begin(), names.end(), options.stock_zero);
  if (found == names.end() || found == names.begin()) {
    complain(translated(texts::cut_command::no_such_system, options.stock_zero));
    return false;
  }
  system = std::uint16_t(found - names.begin());
  return true;
}

}  // namespace kadr::cli
