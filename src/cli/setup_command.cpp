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

#include "action/by_kind.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "config/read_file.h"
#include "config/setup/setup_names.h"
#include "lang/text/tool_comment.h"
#include "out/program/setup_template.h"
#include "out/program/tools_template.h"
#include "session/tool_proposals.h"
#include "session/used_key.h"
#include "texts/setup_command_notes.h"

namespace kadr::cli {
namespace {

constexpr std::size_t gives_up_at = 1000;
constexpr std::size_t max_ranges = 20;  // greatest number of ranges of unexecuted lines that are listed

bool is_lathe(const Job& job) { return job.def->behaviour.lathe != Lathe::none; }

/// The results of executing the program.
struct ExecutedBlocks {
  std::size_t faults = 0;
  MotionUnits moved;
};

class TemplateMaker {
 public:
  TemplateMaker(const Job& job, const Control& control, const ExecutedBlocks& done)
      : job_(job),
        control_(control),
        faults_(done.faults),
        lines_(lines_of(control)),
        proposals_(lines_, comments_in_inches(control, done.moved), is_lathe(job)) {}

  SetupTemplate make() {
    for (const Use& use : control_.use().all()) take(use);
    for (const auto& [tool, use] : tools_)
      if (!reported_.contains(tool)) warn_tool(tool, use);
    if (faults_ != 0) note(texts::setup_command_notes::faults, faults_);
    warn_branches();
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

  void take(const Use& use) {
    const UsedKey used = used_key(use, *job_.def);
    switch (use.kind) {
      case UseKind::tool: tools_.emplace(use.number, use); break;
      case UseKind::length:
      case UseKind::radius:
        if (is_lathe(job_)) turret_offset(use, used);
        else offset(use, used, use.kind == UseKind::radius ? "radius" : "length");
        break;
      case UseKind::work_zero: zero(use, used); break;
      case UseKind::corrector: corrector(use, used); break;
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

  SetupTemplate::Row& offset_row(std::uint32_t number) {
    const std::string name = std::to_string(number);
    const auto row = std::find_if(made_.offsets.begin(), made_.offsets.end(), [&](const SetupTemplate::Row& r) { return r.name == name; });
    return row != made_.offsets.end() ? *row : *made_.offsets.insert(made_.offsets.end(), {name, {}});
  }

  /// Adds the offset of a turning tool: geometry and wear of its lengths, or the nose radius and the number of the imaginary tip, which
  /// only nose radius compensation uses (fanuc-t 4.2). A comment's size is not proposed, because it is seldom that of the nose.
  void turret_offset(const Use& use, const UsedKey& used) {
    SetupTemplate::Row& row = offset_row(use.number);
    const auto add = [&](const std::string& key) { row.cells.emplace_back(key, std::nullopt); };
    const std::string used_at = place(use.origin);
    if (use.kind == UseKind::radius) {
      add("radius");
      add("tip");
      return note(texts::setup_command_notes::turret_nose, used.key, used_at);
    }
    for (const std::string& axis : control_.axes())
      if (axis == "X" || axis == "Y" || axis == "Z") {
        add(axis);
        add(axis + "_wear");
      }
    note(texts::setup_command_notes::turret_lengths, used.key, used.word, used_at);
  }

  void offset(const Use& use, const UsedKey& used, const char* what) {
    SetupTemplate::Row* const row = &offset_row(use.number);
    // a value that an earlier use has already added to the row of the offset table is not added again
    if (std::any_of(row->cells.begin(), row->cells.end(), [&](const auto& cell) { return cell.first == what; })) return;
    const std::string used_at = (use.tool != 0 ? fmt::format("T{}, ", use.tool) : "") + place(use.origin);
    const bool is_radius = std::string_view(what) == "radius";
    const auto proposal = is_radius && use.tool != 0 ? proposal_for(use.tool) : std::nullopt;
    row->cells.emplace_back(what, proposal ? std::optional(*proposal->tool_data.diameter / 2) : std::nullopt);
    if (use.tool != 0 && is_radius) reported_.insert(use.tool);
    if (proposal) note(texts::setup_command_notes::offset_proposed, used.key, used_at, proposal->line, proposal->text);
    else
      made_.notes.push_back(
          with_unsure(in_words(texts::setup_command_notes::offset, used.key, used_at, used.word), is_radius ? use.tool : 0));
    if (proposal && proposal->tool_data.corner && has(*job_.def, SetupNeeds::corner_radius))
      row->cells.emplace_back("corner_radius", proposal->tool_data.corner);
  }

  void zero(const Use& use, const UsedKey& used) {
    SetupTemplate::Row row{used.key.substr(used.key.find('.') + 1), {}};
    const std::vector<std::string>& axes = control_.axes();
    for (std::size_t a = 0; a < axes.size() && a < 3; ++a) row.cells.emplace_back(axes[a], std::nullopt);
    (used.key.starts_with("zeros") ? made_.zeros : made_.work_offsets).push_back(std::move(row));
    note(texts::setup_command_notes::zero, used.key, used.word, place(use.origin));
  }

  void corrector(const Use& use, const UsedKey& used) {
    made_.correctors.emplace_back(std::to_string(use.number), std::nullopt);
    note(texts::setup_command_notes::corrector, used.key, place(use.origin));
  }

  /// Returns the number of the line with the block that calls the tool; 0 if the block is in another file.
  std::uint32_t called_at(std::uint32_t tool) const {
    const auto use = tools_.find(tool);
    return use == tools_.end() || use->second.origin.file != 0 ? 0 : use->second.origin.line;
  }
  std::optional<ToolProposal> proposal_for(std::uint32_t tool) const { return proposals_.of(tool, called_at(tool)); }

  /// Returns `sentence`. If a comment of the program mentions the tool, but gives no certain size, the comment and its line number are
  /// added. If `tool` is 0, nothing is added.
  std::string with_unsure(const std::string& sentence, std::uint32_t tool) const {
    const auto comment = tool == 0 ? std::nullopt : proposals_.unsure(tool, called_at(tool));
    return comment ? in_words(texts::setup_command_notes::not_sure, sentence, comment->line, comment->text) : sentence;
  }

  void warn_tool(std::uint32_t tool, const Use& use) {
    if (const auto proposal = proposal_for(tool))
      note(texts::setup_command_notes::diameter_by_comment, tool, place(use.origin), number_text(*proposal->tool_data.diameter),
           proposal->line, proposal->text);
    else made_.notes.push_back(with_unsure(fmt::format("T{}: {}", tool, place(use.origin)), tool));
  }

  /// True if the line contains a block that the control executes, not only % or the number of the program.
  static bool holds_block(const std::string& text) {
    const std::string rest = without_comments(text);
    if (rest.empty() || rest[0] == '%') return false;
    const bool is_name = (rest[0] == 'O' || rest[0] == ':') && rest.find_first_not_of("0123456789 ", 1) == std::string::npos;
    return !is_name;
  }

  /// Reports the ranges of lines that were not executed, because no jump or condition led to them.
  void warn_branches() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;
    bool open = false;
    for (const auto& [number, text] : lines_) {
      if (!holds_block(text)) continue;
      const bool passed = control_.use().passed(number);
      if (!passed && open) ranges.back().second = number;
      if (!passed && !open) ranges.emplace_back(number, number);
      open = !passed;
    }
    if (ranges.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < ranges.size() && i < max_ranges; ++i) {
      const auto [from, to] = ranges[i];
      list += fmt::format("{}{}", i == 0 ? "" : ", ", from == to ? fmt::format("{}", from) : fmt::format("{}–{}", from, to));
    }
    if (ranges.size() > max_ranges) list += ", …";
    note(texts::setup_command_notes::not_executed, list);
  }

  const Job& job_;
  const Control& control_;
  const std::size_t faults_;
  const ProgramLines lines_;
  const ToolProposals proposals_;
  std::map<std::uint32_t, Use> tools_;
  std::set<std::uint32_t> reported_;
  SetupTemplate made_;
};

/// Returns a tools file for the user to complete. It contains the tools that the program uses.
std::string tools_text(const Job& job, const Control& control, const MotionUnits& moved) {
  const ToolProposals proposals(lines_of(control), comments_in_inches(control, moved), is_lathe(job));
  ToolsTemplate made{std::filesystem::path(job.file).filename().string(), job.lang, {}};
  for (const Use& use : control.use().all()) {
    if (use.kind != UseKind::tool) continue;
    ToolsTemplate::Row row{use.number, use.origin, {}, {}, {}};
    const std::uint32_t called_at = use.origin.file == 0 ? use.origin.line : 0;
    if (const auto proposal = proposals.of(use.number, called_at))
      row.tool_data = proposal->tool_data, row.why = fmt::format("{} \"{}\"", proposal->line, proposal->text);
    else if (const auto comment = proposals.unsure(use.number, called_at))
      row.not_sure = fmt::format("{} \"{}\"", comment->line, comment->text);
    made.rows.push_back(std::move(row));
  }
  return tools_template_text(made);
}

/// Executes a limited number of blocks of the program. The execution continues after faults.
ExecutedBlocks execute_past_faults(Session& session) {
  ExecutedBlocks done;
  Outlets& outlets = session.outlets();
  outlets.stop = stop_token();
  outlets.warning = [](const AlarmReport&) {};
  outlets.programmed = [&](const Action& action) {
    if (const auto* const motion = motion_of(action)) done.moved.take(*motion);
  };
  outlets.alarm = [&](const AlarmReport& report) {
    const bool fatal = report.alarm.id == AlarmId::endless_program || report.alarm.id == AlarmId::interrupted;
    if (!fatal) ++done.faults;
    return !fatal && done.faults < gives_up_at;
  };
  // the programs of other channels are not available, so the program does not wait for them
  session.control().set_waiting(Control::Waiting::pass);
  (void)session.run();
  return done;
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
  session->control().watch_use();
  const ExecutedBlocks done = execute_past_faults(*session);
  if (interrupted()) return interrupted_status();
  const std::string text = options.tools ? tools_text(*job, session->control(), done.moved)
                                         : template_text(TemplateMaker(*job, session->control(), done).make());
  if (!may_write(outputs, options.output) || !outputs.open()) return wrong_usage;
  write_data(outputs.stream("--out"), text);
  return outputs.keep(session->control().files_read()) ? ok : wrong_usage;
}

}  // namespace kadr::cli
