// kadr setup: writes a set-up for the user to complete, which contains only the keys that a program uses. To find these keys, the
// interpreter executes the program and continues after faults, as in `kadr check`. The comments of the program are only used for suggesting
// values.

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>

#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "config/read_file.h"
#include "out/program/setup_template.h"
#include "out/program/tools_template.h"
#include "session/setup_use.h"
#include "texts/setup_command_notes.h"

namespace kadr::cli {
namespace {

constexpr std::size_t max_ranges = 20;  // greatest number of ranges of unexecuted lines that are listed

bool is_lathe(const Job& job) { return job.def->behaviour.lathe != Lathe::none; }

/// Writes what a program uses as a template with notes.
class TemplateMaker {
 public:
  TemplateMaker(const Job& job, const Control& control, const SetupUse& use) : job_(job), control_(control), use_(use) {}

  SetupTemplate make() {
    for (const SetupUseRow& row : use_.rows) take(row);
    for (const auto& [tool, row] : tools_)
      if (!reported_.contains(tool)) note_tool(*row);
    if (use_.faults != 0) note(texts::setup_command_notes::faults, use_.faults);
    note_branches();
    return std::move(made_);
  }

 private:
  template <std::size_t Holes, typename... Args>
  void note(TextId<Holes> text, const Args&... args) {
    made_.notes.push_back(in_words(text, args...));
  }
  template <std::size_t Holes, typename... Args>
  std::string in_words(TextId<Holes> text, const Args&... args) const {
    return translated_in(job_.lang, text, args...);
  }

  std::string place(const Origin& origin) const {
    const std::string block = origin.has_block ? fmt::format(" N{}", origin.block) : "";
    const std::string file = origin.file == 0 ? "" : control_.file_name(origin.file) + " ";
    return file + in_words(texts::setup_command_notes::line, origin.line) + block;
  }

  void take(const SetupUseRow& row) {
    const Use& use = row.use;
    const UsedKey& used = row.used;
    switch (use.kind) {
      case UseKind::tool: tools_.emplace(use.number, &row); break;
      case UseKind::length:
      case UseKind::radius:
        if (is_lathe(job_)) turret_offset(row);
        else offset(row);
        break;
      case UseKind::work_zero:
        add_row(used.key.starts_with("zeros") ? made_.zeros : made_.work_offsets, row);
        note(texts::setup_command_notes::zero, used.key, used.word, place(use.origin));
        break;
      case UseKind::corrector:
        made_.correctors.emplace_back(row.row, std::nullopt);
        note(texts::setup_command_notes::corrector, used.key, place(use.origin));
        break;
      case UseKind::variable:
      case UseKind::parameter:
        made_.variables.emplace_back(used.word, std::nullopt);
        note(texts::setup_command_notes::variable, used.word, place(use.origin));
        break;
      case UseKind::skip_switch:
        made_.has_skip = true;
        note(texts::setup_command_notes::skip, used.word, place(use.origin), use.number);
        break;
      case UseKind::optional_stop:
        made_.has_optional_stop = true;
        note(texts::setup_command_notes::optional_stop, place(use.origin));
        break;
      default: break;
    }
  }

  static void add_row(std::vector<SetupTemplate::Row>& rows, const SetupUseRow& from) {
    const auto known = std::find_if(rows.begin(), rows.end(), [&](const SetupTemplate::Row& r) { return r.name == from.row; });
    SetupTemplate::Row& row = known != rows.end() ? *known : *rows.insert(rows.end(), {from.row, {}});
    for (const SetupUseRow::Cell& cell : from.cells) row.cells.emplace_back(cell.key, cell.proposed);
  }

  void turret_offset(const SetupUseRow& row) {
    add_row(made_.offsets, row);
    const std::string used_at = place(row.use.origin);
    if (row.use.kind == UseKind::radius) note(texts::setup_command_notes::turret_nose, row.used.key, used_at);
    else note(texts::setup_command_notes::turret_lengths, row.used.key, row.used.word, used_at);
  }

  void offset(const SetupUseRow& row) {
    const Use& use = row.use;
    add_row(made_.offsets, row);
    const std::string used_at = (use.tool != 0 ? fmt::format("T{}, ", use.tool) : "") + place(use.origin);
    if (use.tool != 0 && use.kind == UseKind::radius) reported_.insert(use.tool);
    if (row.by) note(texts::setup_command_notes::offset_proposed, row.used.key, used_at, row.by->line, row.by->text);
    else made_.notes.push_back(with_unsure(in_words(texts::setup_command_notes::offset, row.used.key, used_at, row.used.word), row));
  }

  /// Returns `sentence`. If a comment of the program mentions the tool, but gives no certain size, the comment and its line number are
  /// added.
  std::string with_unsure(const std::string& sentence, const SetupUseRow& row) const {
    return row.unsure ? in_words(texts::setup_command_notes::not_sure, sentence, row.unsure->line, row.unsure->text) : sentence;
  }

  void note_tool(const SetupUseRow& row) {
    const std::uint32_t tool = row.use.number;
    if (row.by)
      note(texts::setup_command_notes::diameter_by_comment, tool, place(row.use.origin), number_text(*row.by->tool_data.diameter),
           row.by->line, row.by->text);
    else made_.notes.push_back(with_unsure(fmt::format("T{}: {}", tool, place(row.use.origin)), row));
  }

  /// Reports the ranges of lines that were not executed.
  void note_branches() {
    if (use_.not_executed.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < use_.not_executed.size() && i < max_ranges; ++i) {
      const auto [from, to] = use_.not_executed[i];
      list += fmt::format("{}{}", i == 0 ? "" : ", ", from == to ? fmt::format("{}", from) : fmt::format("{}–{}", from, to));
    }
    if (use_.not_executed.size() > max_ranges) list += ", …";
    note(texts::setup_command_notes::not_executed, list);
  }

  const Job& job_;
  const Control& control_;
  const SetupUse& use_;
  std::map<std::uint32_t, const SetupUseRow*> tools_;
  std::set<std::uint32_t> reported_;
  SetupTemplate made_;
};

/// Returns a tools file for the user to complete. It contains the tools that the program uses.
std::string tools_text(const Job& job, const SetupUse& used) {
  ToolsTemplate made{std::filesystem::path(job.file).filename().string(), job.lang, {}};
  for (const SetupUseRow& use : used.rows) {
    if (use.use.kind != UseKind::tool) continue;
    ToolsTemplate::Row row{use.use.number, use.use.origin, {}, {}, {}};
    if (use.by) row.tool_data = use.by->tool_data, row.why = fmt::format("{} \"{}\"", use.by->line, use.by->text);
    else if (use.unsure) row.not_sure = fmt::format("{} \"{}\"", use.unsure->line, use.unsure->text);
    made.rows.push_back(std::move(row));
  }
  return tools_template_text(made);
}

/// Returns true if the output file does not exist yet. Prints an error otherwise, so that no file is overwritten.
bool may_write(const Outputs& outputs, const std::string& name) {
  struct stat there {};
  if (name.empty() || name == "-" || ::lstat(name.c_str(), &there) != 0) return outputs.check();
  complain(fmt::format("{}: {}", name, errno_message(EEXIST)));
  return false;
}

}  // namespace

int write_setup(const SetupOptions& options) {
  auto job = make_job(options.program, options.program.programs.front());
  if (!job) return wrong_usage;
  auto program = open_program(*job);
  if (!program) return wrong_usage;
  Outputs outputs(job->lang);
  outputs.reads(job->file);
  outputs.reads(job->setup_file);
  outputs.writes("--out", options.output.empty() ? "-" : options.output);
  RunLimits limits = options.program.limits;
  limits.restarts = 0;
  limits.stop = stop_token();
  job->setup.channels.clear();
  const auto session = make_session(*job, std::move(*program), limits);
  if (!session) return wrong_usage;
  const ExecutedBlocks done = execute_for_use(*session, stop_token());
  if (interrupted()) return interrupted_status();
  const SetupUse use = setup_use(session->control(), *job->def, done);
  const std::string text = options.tools ? tools_text(*job, use) : template_text(TemplateMaker(*job, session->control(), use).make());
  if (!may_write(outputs, options.output) || !outputs.open()) return wrong_usage;
  write_data(outputs.stream("--out"), text);
  return outputs.keep(session->control().files_read()) ? ok : wrong_usage;
}

}  // namespace kadr::cli
