// kadr edit: changes a program in one respect and proves that nothing else has changed. The command is tested by tests/edit.py.

#include "texts/edit_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "compare/comparison_text.h"
#include "config/language.h"
#include "edit/editing.h"
#include "out/text/alarm_print.h"
#include "out/text/source_line.h"
#include "texts/values.h"
#include "view/source_text.h"

namespace kadr::cli {
namespace {

constexpr double least_edit_tolerance = 1e-6, most_edit_tolerance = 1;  // limits of the value of --tolerance, mm
constexpr std::size_t shown_differences = 5;                            // greatest number of unexpected differences that are printed

class EditCommand {
 public:
  explicit EditCommand(const EditOptions& options) : o_(options), outputs_(language(options.run)) {}

  int run() {
    if (o_.edits.empty()) {
      complain(translated(texts::edit_command::nothing_asked));
      return wrong_usage;
    }
    if (places_edited(o_.edits) > 1) {
      complain(translated(texts::edit_command::one_at_a_time));
      return wrong_usage;
    }
    Options of_program = o_.run;
    of_program.programs = {o_.program};
    job_ = make_job(of_program, o_.program);
    if (!job_) return wrong_usage;
    outputs_.reads(job_->file);
    outputs_.reads(job_->setup_file);
    outputs_.writes("--out", o_.out.empty() ? "-" : o_.out);
    if (!outputs_.check()) return wrong_usage;
    auto program = open_program(*job_);
    if (!program) return wrong_usage;
    encoding_ = program->encoding;
    if (encoding_ && is_tape(*encoding_)) {
      complain(translated(texts::edit_command::tape_refused, job_->file));
      return wrong_usage;
    }
    const auto made = edited(spec(), {shared_source(std::move(program->source)), encoding_, job_->def.get()});
    if (interrupted()) return interrupted_status();
    if (!made) {
      const std::string place = made.error().line == 0 ? job_->file : fmt::format("{}:{}", job_->file, made.error().line);
      complain(fmt::format("{}: {}", place, translated(texts::edit_command::not_edited, made.error().why)));
      return alarms;
    }
    return made->proof.is_proven() ? write(*made) : refuse(*made);
  }

 private:
  EditSpec spec() {
    const auto opened = [](auto session) -> tl::expected<std::unique_ptr<Session>, std::string> {
      if (session) return std::move(*session);
      const auto& fault = session.error().fault;
      return tl::unexpected(fault.key + ": " + in_thread_language(fault.en, fault.ru));
    };
    EditSpec spec;
    spec.old_program = [this, opened](const Setup& setup) -> tl::expected<std::unique_ptr<Session>, std::string> {
      auto program = open_program(*job_);
      if (!program) return tl::unexpected(std::string());
      return opened(Session::open({job_->def, job_->profile, setup, std::move(*program), o_.run.limits}));
    };
    spec.new_program = [this, opened](std::shared_ptr<ByteSource> text, const Setup& setup) {
      return opened(
          Session::open({job_->def, job_->profile, setup, {job_->file, shared_source(std::move(text)), encoding_}, o_.run.limits}));
    };
    spec.source_text = utf8_text(open_text(job_->file, job_->encoding));
    spec.setup = job_->setup;
    spec.edits = o_.edits;
    spec.tolerance = o_.tolerance;
    spec.stop = o_.run.limits.stop;
    return spec;
  }

  int write(const Edited& made) {
    if (!outputs_.open()) return wrong_usage;
    std::FILE* const file = outputs_.stream("--out");
    (void)each_piece(*made.text, [file](std::string_view piece) {
      write_data(file, std::string(piece));
      return true;
    });
    if (!outputs_.keep()) return wrong_usage;
    if (made.changes.lines == 0) write_message(translated(texts::edit_command::nothing_changes) + "\n");
    else write_message(counted(texts::edit_command::lines_changed, made.changes.lines) + "\n");
    write_message(translated(texts::edit_command::proven, summary_of(made.proof.comparison, language(o_.run)), made.proof.states) + "\n");
    if (made.changes.not_executed > 0) write_message(counted(texts::edit_command::not_executed, made.changes.not_executed) + "\n");
    return ok;
  }

  /// Prints why the edit is refused: the alarm that stops the program, or the differences that nobody asked for.
  int refuse(const Edited& made) {
    const Comparison& proof = made.proof.comparison;
    const Lang lang = language(o_.run);
    if (proof.stopped_a) {
      complain(translated(texts::edit_command::program_stops));
      write_message(alarm_text(*proof.stopped_a, job_->texts(), lang, colours()));
      return alarms;
    }
    complain(translated(texts::edit_command::not_proven));
    for (std::size_t i = 0; i < std::min(shown_differences, proof.differences.size()); ++i) {
      const CourseDifference& d = proof.differences[i];
      write_message(fmt::format("  {}:{}: {}\n", d.a.file.empty() ? job_->file : d.a.file, d.a.origin.line, sentence_of(d, lang)));
    }
    if (proof.stopped_b) write_message(alarm_text(*proof.stopped_b, job_->texts(), lang, colours()));
    return alarms;
  }

  const EditOptions& o_;
  Outputs outputs_;
  std::optional<Job> job_;
  std::optional<Encoding> encoding_;
};

/// Adds an option that may be stated several times. Each word is read by `read`, whose error is that of the option, and added by `add`.
template <class Read, class Add>
CLI::Option* edit_words(CLI::App& app, const std::string& name, PlainText about, PlainText value, Read read, Add add) {
  return takes(app.add_option_function<std::vector<std::string>>(
                      name,
                      [name, read, add](const std::vector<std::string>& words) {
                        for (const std::string& word : words) {
                          auto made = read(word);
                          if (!made) throw CLI::ValidationError(name, made.error());
                          add(std::move(*made));
                        }
                      },
                      plain_text(about))
                   ->delimiter(',')
                   ->allow_extra_args(false),
               plain_text(value));
}

/// Adds an option with one word, which is read by `read` and kept by `keep`.
template <class Read, class Keep>
void edit_word(CLI::App& app, const std::string& name, PlainText about, PlainText value, Read read, Keep keep) {
  takes(app.add_option_function<std::string>(
            name,
            [name, read, keep](const std::string& word) {
              auto made = read(word);
              if (!made) throw CLI::ValidationError(name, made.error());
              keep(std::move(*made));
            },
            plain_text(about)),
        plain_text(value));
}

/// Adds the options that map, repeat or reverse positions in the XY plane. Only one of them may be stated: their order would matter.
void plane_options(CLI::App& app, Edits& edits) {
  namespace t = texts::edit_command;
  const auto keep = [&edits](const PlaneMap& map) { edits.plane = map, ++edits.maps; };
  edit_word(app, "--mirror", t::mirror, t::mirror_value, read_mirror, keep);
  edit_word(app, "--copy", t::copy, t::copy_value, read_places,
            [&edits](std::vector<PlaneMap> places) { edits.places = std::move(places), edits.copies = true; });
  edit_word(app, "--lines", t::lines, t::lines_value, read_lines, [&edits](const EditLines& lines) { edits.copied = lines; });
  edit_word(app, "--reverse", t::reverse, t::lines_value, read_lines, [&edits](const EditLines& lines) { edits.reverses = lines; });
  edit_word(app, "--rotate", texts::edit_command::rotate, t::rotate_value, read_rotation, keep);
}

void removal_options(CLI::App& app, Edits& edits) {
  const std::map<std::string, bool*> removed = {{"numbers", &edits.no_numbers},
                                                {"comments", &edits.no_comments},
                                                {"spaces", &edits.no_spaces},
                                                {"empty-lines", &edits.no_empty_lines}};
  const auto set_all = [](const std::map<std::string, bool*>& flags) {
    return [flags](const std::vector<std::string>& words) {
      for (const std::string& word : words) *flags.at(word) = true;
    };
  };
  one_of(app.add_option_function<std::vector<std::string>>("--strip", set_all(removed), plain_text(texts::edit_command::strip))
             ->delimiter(',')
             ->allow_extra_args(false),
         {"numbers", "comments", "spaces", "empty-lines"});
  one_of(
      app.add_option_function<std::vector<std::string>>("--add", set_all({{"spaces", &edits.spaces}}), plain_text(texts::edit_command::add))
          ->delimiter(',')
          ->allow_extra_args(false),
      {"spaces"});
}

}  // namespace

void add_edit(CLI::App& app, Commands& c) {
  namespace t = texts::edit_command;
  CLI::App* const edit = app.add_subcommand("edit", plain_text(t::about));
  EditOptions& o = c.edit;
  Edits& edits = o.edits;
  edit->add_option(plain_text(t::program_name), o.program, plain_text(t::program))->required();
  writes_file(edit->add_option("--out", o.out, plain_text(t::out_file)));
  edit_words(*edit, "--renumber", t::renumber, t::numbers_value, read_numbering, [&](Numbering one) { edits.numbering = one; });
  removal_options(*edit, edits);
  edit_words(*edit, "--feed", t::feed, t::factor_value, read_factor, [&](Factor one) { edits.feeds.push_back(one); });
  edit_words(*edit, "--speed", t::speed, t::factor_value, read_factor, [&](Factor one) { edits.speeds.push_back(one); });
  edit_words(*edit, "--replace-tool", t::tool, t::tool_value, read_tools, [&](auto one) { edits.tools.push_back(one); });
  edit_words(*edit, "--replace-zero", t::work_offset, t::work_offset_value, read_systems,
             [&](auto one) { edits.work_systems.push_back(one); });
  edit_words(*edit, "--shift", t::shift, t::shift_value, read_shift, [&](const auto& one) { edits.shift[one.first] = one.second; });
  plane_options(*edit, edits);
  number(edit->add_option("--tolerance", o.tolerance, plain_text(t::tolerance)), plain_text(texts::values::mm), least_edit_tolerance,
         most_edit_tolerance);
  program_options(*edit, o.run);
  memory_option(*edit, o.run);
  edit->footer(plain_text(texts::help_examples::edit));
}

int edit(const EditOptions& options) { return EditCommand(options).run(); }

}  // namespace kadr::cli
