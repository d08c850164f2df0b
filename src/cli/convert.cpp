// kadr convert: converts a program of one control to a program of another control, and proves that both do the same. The command is tested
// by tests/convert.py.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "compare/comparison_text.h"
#include "config/control/control_file.h"
#include "config/control/guess.h"
#include "config/language.h"
#include "convert/conversion_text.h"
#include "lang/text/text_spool.h"
#include "texts/convert_command.h"
#include "texts/values.h"
#include "view/source_text.h"

namespace kadr::cli {
namespace {

constexpr double least_apart = 1e-5, most_apart = 10;  // limits of the value of --tolerance, mm

// names of the methods of conversion, in the order of the enum ConvertedAs
constexpr std::array<const char*, 5> method_names = {"text", "words", "codes", "centre", "plain"};

class ConvertCommand {
 public:
  explicit ConvertCommand(const ConvertOptions& options) : o_(options), outputs_(language(options.run)) {}

  int run() {
    Options of_source = o_.run;
    of_source.programs = {o_.program};
    if (!o_.from.empty()) of_source.control = o_.from;
    job_ = make_job(of_source, o_.program);
    if (!job_) return wrong_usage;
    auto to = load_control(o_.to);
    if (!to) {
      complain(to.error());
      return wrong_usage;
    }
    to_ = std::make_shared<const ControlDef>(std::move(*to));
    letters_ = o_.encoding_out.empty() ? to_->letters : written_letters_named(o_.encoding_out).value_or(to_->letters);
    outputs_.reads(job_->file);
    outputs_.reads(job_->setup_file);
    outputs_.writes("--out", o_.out.empty() ? "-" : o_.out);
    outputs_.writes("--setup-out", o_.setup_out);
    if (!outputs_.check()) return wrong_usage;
    if (!job_->setup.channels.empty()) {
      complain(fmt::format("{}: {}: channels.{}", no_conversion_of_channels(), job_->setup_file, job_->setup.channels.begin()->first));
      return alarms;
    }
    const auto spec = spec_of();
    if (!spec) return wrong_usage;
    const auto made = converted(*spec);
    if (!made) {
      complain(made.error());
      return wrong_usage;
    }
    if (interrupted()) return interrupted_status();
    return print_result(*made);
  }

 private:
  ConversionSpec::Opens opens() const {
    return [this](const Setup& setup) -> tl::expected<std::unique_ptr<Session>, std::string> {
      auto program = open_program(*job_);
      if (!program) return tl::unexpected(translated(texts::convert_command::not_opened));
      auto opened = Session::open({job_->def, job_->profile, setup, std::move(*program), o_.run.limits});
      if (!opened)
        return tl::unexpected(opened.error().fault.key + ": " + in_thread_language(opened.error().fault.en, opened.error().fault.ru));
      return std::move(*opened);
    };
  }
  std::optional<ConversionSpec> spec_of() {
    const auto check = open_program(*job_);
    if (!check) return std::nullopt;
    ConversionSpec spec;
    spec.to = to_.get();
    spec.flat = o_.flat;
    if (!o_.method.empty()) spec.only = ConvertedAs(std::find(method_names.begin(), method_names.end(), o_.method) - method_names.begin());
    spec.letters = letters_;
    spec.stop = o_.run.limits.stop;
    spec.tolerance = o_.tolerance;
    spec.source_text = utf8_text(open_text(job_->file, job_->encoding));
    spec.source = opens();
    spec.setup = job_->setup;
    spec.target = [this](std::shared_ptr<ByteSource> text, const Setup& setup) -> tl::expected<std::unique_ptr<Session>, std::string> {
      auto session =
          Session::open({to_, job_->profile, setup, {job_->file, shared_source(std::move(text)), Encoding::utf8}, o_.run.limits});
      if (!session)
        return tl::unexpected(session.error().fault.key + ": " + in_thread_language(session.error().fault.en, session.error().fault.ru));
      (*session)->control().set_waiting(Control::Waiting::pass);
      return std::move(*session);
    };
    return spec;
  }

  int print_result(const Converted& made) {
    const auto of_target = AlarmTexts::load(to_.get());
    if (!of_target) {
      complain(of_target.error());
      return wrong_usage;
    }
    const ConversionSides sides{*job_->def, job_->texts(), *of_target};
    if (!made.taken) {
      complain(nothing_proven());
      print_reasons(made, made.tries.size(), sides);
    }
    const auto unproven = !made.taken && o_.force ? best_unproven(made) : std::nullopt;
    if (!made.taken && !unproven) return alarms;
    const ConversionTry& one = made.tries[made.taken ? *made.taken : *unproven];
    if (const std::string why = refused_by_control(beginning_of(one), o_.to, language(o_.run)); !why.empty()) {
      complain(translated(texts::convert_command::not_read_as_program));
      write_message(fmt::format("  {}\n", why));
      return alarms;
    }
    if (!outputs_.open()) return wrong_usage;
    if (const Status written = write(one, unproven.has_value()); !written) {
      complain(of_target->sentence(written.error(), language(o_.run)));
      return alarms;
    }
    if (!o_.setup_out.empty()) {
      const std::string setup = setup_text(made.setup_of(one.as));
      write_data(outputs_.stream("--setup-out"), setup);
    }
    if (!outputs_.keep()) return wrong_usage;
    if (unproven) return alarms;
    write_message(fmt::format("{}\n{}\n", summary_of(one.proof, language(o_.run)),
                              translated(texts::convert_command::written_as, method_in_words(one.as))));
    for (const std::string& note : notes_on(made, one)) write_message(fmt::format("  {}\n", note));
    explain(one, sides);
    print_reasons(made, *made.taken, sides);
    return ok;
  }

  /// Returns the first part (at most 256 KiB) of the converted program, from which the control of this program can be guessed.
  static std::string beginning_of(const ConversionTry& one) {
    constexpr std::size_t looked_at = std::size_t{256} << 10;  // greatest length of the first part, bytes
    std::string text;
    (void)each_piece(*one.text, [&](std::string_view piece) {
      text += piece.substr(0, looked_at - text.size());
      return text.size() < looked_at;
    });
    return text;
  }

  /// Writes the converted program in its encoding.
  ///   alarms  bad_encoding, if the encoding lacks a character
  Status write(const ConversionTry& one, bool unproven) {
    std::FILE* const file = outputs_.stream("--out");
    const auto put = [&](std::string_view text) -> Status {
      auto bytes = is_written_so(text, letters_) ? Result<std::string>(text) : bytes_of(text, letters_);
      if (!bytes) return fail(bytes.error());
      write_data(file, *bytes);
      return {};
    };
    const auto in_letters = [&](std::string_view text) { return unproven ? transliterated(text, letters_).text : std::string(text); };
    const std::string mark = unproven ? in_letters(unproven_mark()) : std::string();
    // on a punched tape, a leader and a trailer must enclose the whole text
    if (is_tape(letters_.encoding)) return put(mark + in_letters(whole_text(*one.text)));
    Status status = put(mark);
    (void)each_piece(*one.text, [&](std::string_view piece) {
      if (status) status = put(in_letters(piece));
      return status.has_value();
    });
    return status;
  }

  void explain(const ConversionTry& one, const ConversionSides& sides) const {
    if (!o_.explain) return;
    for (const WrittenOut& out : one.written_out) {
      const std::string lines =
          out.lines.first == out.lines.last ? fmt::format("{}", out.lines.first) : fmt::format("{}-{}", out.lines.first, out.lines.last);
      write_message(fmt::format("  {}\n", translated(texts::convert_command::written_out, job_->file, lines, why_written_out(out, sides))));
    }
  }
  /// Prints why the first `count` methods of conversion were not used. Methods with the same reason are printed in one line.
  void print_reasons(const Converted& made, std::size_t count, const ConversionSides& sides) const {
    std::vector<ConversionRefusal> whys;
    for (std::size_t i = 0; i < count; ++i) {
      explain(made.tries[i], sides);
      whys.push_back(refusal_of(made.tries[i], sides));
    }
    const auto is_same = [](const ConversionRefusal& a, const ConversionRefusal& b) {
      return a.text == b.text && a.file == b.file && a.at.file == b.at.file && a.at.line == b.at.line && a.written_text == b.written_text;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (std::any_of(whys.begin(), whys.begin() + std::ptrdiff_t(i), [&](const auto& before) { return is_same(before, whys[i]); }))
        continue;
      std::string reasons = translated(texts::convert_command::not_this_way, method_in_words(made.tries[i].as));
      for (std::size_t k = i + 1; k < count; ++k)
        if (is_same(whys[i], whys[k]))
          reasons += ", " + translated(texts::convert_command::not_this_way, method_in_words(made.tries[k].as));
      write_message(fmt::format("  {}: {}{}\n", reasons, place_of(whys[i]), whys[i].text));
    }
  }

  /// Returns the location where a conversion failed. For example, "flange.nc:12 | 14: " is line 12 of the original program and line 14 of
  /// the converted program.
  std::string place_of(const ConversionRefusal& why) const {
    if (why.at.line == 0 && why.written_line == 0) return {};
    if (why.at.line == 0) return translated(texts::convert_command::line_of_written, why.written_line, why.written_text) + ": ";
    const std::string file = why.at.file == 0 ? job_->file : why.file.empty() ? translated(texts::convert_command::called_file) : why.file;
    return why.written_line == 0 ? fmt::format("{}:{}: ", file, why.at.line)
                                 : fmt::format("{}:{} | {}: ", file, why.at.line, why.written_line);
  }

  const ConvertOptions& o_;
  Outputs outputs_;
  std::optional<Job> job_;
  std::shared_ptr<const ControlDef> to_;
  WrittenLetters letters_;  // characters and encoding of the converted program
};

}  // namespace

void add_convert(CLI::App& app, Commands& c) {
  CLI::App* const convert = app.add_subcommand("convert", translated(texts::convert_command::about));
  ConvertOptions& o = c.convert;
  convert->add_option(translated(texts::convert_command::program_name), o.program, translated(texts::convert_command::program))->required();
  control_id(convert->add_option("--from", o.from, translated(texts::convert_command::from_control)));
  control_id(convert->add_option("--to", o.to, translated(texts::convert_command::to_control)))->required();
  writes_file(convert->add_option("--out", o.out, translated(texts::convert_command::out_file)));
  writes_file(convert->add_option("--setup-out", o.setup_out, translated(texts::convert_command::setup_out)));
  written_letters(convert->add_option("--encoding-out", o.encoding_out, translated(texts::convert_command::encoding_out)));
  convert->add_flag("--flat", o.flat, translated(texts::convert_command::flat));
  convert->add_flag("--explain", o.explain, translated(texts::convert_command::explain));
  convert->add_flag("--force", o.force, translated(texts::convert_command::by_force));
  one_of(convert->add_option("--way", o.method, translated(texts::convert_command::only_way)), {method_names.begin(), method_names.end()});
  number(convert->add_option("--tolerance", o.tolerance, translated(texts::convert_command::tolerance)), plain_text(texts::values::mm),
         least_apart, most_apart);
  program_options(*convert, o.run);
  memory_option(*convert, o.run);
  convert->footer(plain_text(texts::help_examples::convert));
}

int convert(const ConvertOptions& options) { return ConvertCommand(options).run(); }

}  // namespace kadr::cli
