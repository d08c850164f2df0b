// The program of kadr drive as a text for Grbl. Used by drive_command.

#include "cli/drive_program.h"

#include "cli/job/terminal.h"
#include "config/control/control_file.h"
#include "config/control/guess.h"
#include "config/language.h"
#include "convert/conversion.h"
#include "lang/text/text_spool.h"
#include "out/text/alarm_print.h"
#include "texts/drive_command.h"
#include "view/source_text.h"

namespace kadr::cli {
namespace {

constexpr const char* driven_control = "grbl";

}  // namespace

std::unique_ptr<DriveProgram> DriveProgram::load(const DriveOptions& options) {
  Options of_program = options.run;
  of_program.programs = {options.program};
  auto job = make_job(of_program, options.program);
  if (!job) return nullptr;
  if (!job->setup.channels.empty()) {
    complain(translated(texts::drive_command::several_channels));
    return nullptr;
  }
  std::unique_ptr<DriveProgram> program(new DriveProgram(std::move(*job), options.run.limits));
  if (program->job_.def->id == driven_control) {
    if (!open_program(program->job_)) return nullptr;
    program->grbl_ = program->job_.def;
    program->setup_ = program->job_.setup;
    program->text_ = utf8_text(open_text(program->job_.file, program->job_.encoding));
    return program->stop_for_tools() ? std::move(program) : nullptr;
  }
  auto grbl = load_control(driven_control);
  if (!grbl) {
    complain(grbl.error());
    return nullptr;
  }
  program->grbl_ = std::make_shared<const ControlDef>(std::move(*grbl));
  return program->convert() ? std::move(program) : nullptr;
}

/// Expresses the program as lines of Grbl, proven to do the same.
bool DriveProgram::convert() {
  if (!open_program(job_)) return false;
  ConversionSpec spec;
  spec.to = grbl_.get();
  spec.stop = limits_.stop;
  spec.source_text = utf8_text(open_text(job_.file, job_.encoding));
  spec.setup = job_.setup;
  spec.source = [this](const Setup& setup) -> tl::expected<std::unique_ptr<Session>, std::string> {
    auto opened = open_program(job_);
    if (!opened) return tl::unexpected(translated(texts::drive_command::not_converted));
    auto source = Session::open({job_.def, job_.profile, setup, std::move(*opened), limits_});
    if (!source) return tl::unexpected(in_thread_language(source.error().fault.en, source.error().fault.ru));
    return std::move(*source);
  };
  spec.target = [this](std::shared_ptr<ByteSource> text, const Setup& setup) -> tl::expected<std::unique_ptr<Session>, std::string> {
    auto target = session(std::move(text), setup);
    if (!target) return tl::unexpected(translated(texts::drive_command::not_converted));
    target->control().set_waiting(Control::Waiting::pass);
    return target;
  };
  const auto made = converted(spec);
  if (!made || !made->taken) {
    complain(made ? translated(texts::drive_command::not_converted) : made.error());
    return false;
  }
  const ConversionTry& one = made->tries[*made->taken];
  text_ = one.text;
  setup_ = made->setup_of(one.as);
  return true;
}

std::unique_ptr<Session> DriveProgram::session(std::shared_ptr<ByteSource> text, const Setup& setup) const {
  auto opened = Session::open({grbl_, job_.profile, setup, {job_.file, shared_source(std::move(text)), Encoding::utf8}, limits_});
  if (opened) return std::move(*opened);
  complain(opened.error().fault.key + ": " + in_thread_language(opened.error().fault.en, opened.error().fault.ru));
  return nullptr;
}

/// Makes each M6, which Grbl does not have, a stop for the operator.
bool DriveProgram::stop_for_tools() {
  std::vector<std::uint32_t> lines;
  auto text = drive::with_tool_stops(text_, lines);
  if (!text) {
    complain(translated(texts::drive_command::tool_and_motion, job_.file, lines.back()));
    return false;
  }
  text_ = std::move(text);
  tools_ = {lines.begin(), lines.end()};
  return true;
}

std::unique_ptr<drive::GrblJob> DriveProgram::open(const Setup& setup, const drive::GrblText& text) const {
  auto opened = session(text.text, setup);
  return opened ? std::make_unique<drive::GrblJob>(std::move(opened), text, tools_) : nullptr;
}

std::unique_ptr<drive::GrblJob> DriveProgram::open(const drive::GrblSettings& settings,
                                                   const std::optional<drive::GrblPoint>& position) const {
  return open(drive::setup_of_controller(setup_, settings, position, *grbl_), {text_});
}

std::unique_ptr<drive::GrblJob> DriveProgram::open(const drive::GrblSettings& settings, const std::optional<drive::GrblPoint>& position,
                                                   const drive::GrblRestart& restart) const {
  return open(drive::setup_of_controller(setup_, settings, position, *grbl_), restart.text);
}

std::optional<drive::GrblRestart> DriveProgram::restart(const drive::GrblSettings& settings, const drive::GrblRestartPlan& plan) const {
  const Setup setup = drive::setup_of_controller(setup_, settings, std::nullopt, *grbl_);
  auto made = drive::grbl_restart(
      text_, [&](std::shared_ptr<ByteSource> text) { return session(std::move(text), setup); }, settings, plan);
  if (made) return std::move(*made);
  complain(job_.file + ": " + made.error());
  return std::nullopt;
}

void DriveProgram::print(const AlarmReport& alarm) const { write_coloured_message(alarm_text(alarm, job_.texts(), job_.lang, colours())); }

}  // namespace kadr::cli
