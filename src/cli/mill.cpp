// kadr mill: reads a drawing, and writes a milling program and its picture. session/milling converts the drawing to the program.

#include <fmt/core.h>

#include "cli/job/files.h"
#include "cli/job/outputs.h"
#include "cli/job/progress.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/control/control_file.h"
#include "out/picture/plot/plot_page.h"
#include "out/text/alarm_print.h"
#include "out/text/page_file.h"
#include "session/milling/mill_summary.h"
#include "texts/mill_command.h"

namespace kadr::cli {
namespace {

class MillCommand {
 public:
  MillCommand(const MillOptions& options, Lang lang, const ControlDef& def, const AlarmTexts& texts)
      : options_(options), lang_(lang), def_(def), texts_(texts), outputs_(lang) {}

  Exit run() {
    outputs_.reads(options_.contour);
    if (options_.control.ends_with(".toml")) outputs_.reads(options_.control);
    outputs_.writes("--output", options_.output.empty() ? "-" : options_.output);
    outputs_.writes("--plot", options_.plot);
    if (!outputs_.check()) return wrong_usage;
    const auto text = read_small(options_.contour, limits::drawing_bytes);
    if (!text) return wrong_usage;
    if (const auto job = mill_job(options_); !job) {
      write_message(job.error());
      return wrong_usage;
    }
    const auto made = milled(options_, *text, def_, watch());
    if (!made) {
      write_message(made.error(), *text);
      return alarms;
    }
    progress_.reset();
    if (!outputs_.open()) return wrong_usage;
    const std::string& program = made->program.text;
    write_data(outputs_.stream("--output"), program);  // a write error is not checked here, since Outputs::keep() reports it
    if (!options_.plot.empty() && !draw(*made)) return wrong_usage;
    if (!outputs_.keep()) return wrong_usage;
    if (const std::string warning = warning_of_holes(*made, lang_); !warning.empty()) complain(warning);
    if (!options_.quiet) print(*made);
    return ok;
  }

 private:
  area::Watch watch() {
    progress_.emplace(options_.quiet);
    const auto show = [this](area::Stage stage, double part) {
      constexpr PlainText names[] = {texts::mill_command::passes, texts::mill_command::path, texts::mill_command::verification};
      if (progress_ && progress_->is_due()) progress_->show(part, plain_text(names[static_cast<std::size_t>(stage)], lang_));
    };
    return {stop_token(), show};
  }

  /// Prints an alarm that concerns the whole job and no line of the drawing.
  void write_message(const Alarm& alarm) {
    progress_.reset();
    if (alarm.id == AlarmId::interrupted) return complain(translated_in(lang_, texts::mill_command::interrupted));
    complain(fmt::format("{}: {}: {}", options_.contour, name_of(alarm.id), texts_.sentence(alarm, lang_)));
    if (const std::string hint = texts_.hint(alarm, lang_); !hint.empty()) kadr::cli::write_message("  " + hint + "\n");
  }

  void write_message(const DrawingFault& fault, std::string_view text) {
    progress_.reset();
    if (fault.line == 0) return write_message(fault.alarm);
    kadr::cli::write_message(alarm_text(report_of(fault, text, options_.contour), texts_, lang_, colours()));
  }

  bool draw(const Milled& made) const {
    const auto drawn = draw_milling(*outputs_.file("--plot"), mill_picture(made, def_, name_of_file(options_.contour), lang_));
    if (!drawn) complain(drawn.error());
    return drawn.has_value();
  }

  void print(const Milled& made) const {
    std::FILE* const to = options_.output.empty() || options_.output == "-" ? stderr : stdout;
    for (const MillLine& line : mill_summary(made, lang_)) type_into(to, fmt::format("{:<17}{}\n", line.name, line.value));
  }

  const MillOptions& options_;
  Lang lang_;
  const ControlDef& def_;
  const AlarmTexts& texts_;
  Outputs outputs_;
  std::optional<Progress> progress_;
};

}  // namespace

int mill(const MillOptions& options) {
  Options shared;
  shared.lang = options.lang;
  auto def = load_control(options.control);
  if (!def) {
    complain(def.error());
    return wrong_usage;
  }
  const auto texts = AlarmTexts::load(&*def);
  if (!texts) {
    complain(texts.error());
    return wrong_usage;
  }
  if (const std::string fault = options.plot.empty() ? "" : page_fault(options.plot); !fault.empty()) {
    complain("--plot " + fault);
    return wrong_usage;
  }
  const int status = MillCommand(options, language(shared), *def, *texts).run();
  return interrupted() ? interrupted_status() : status;
}

}  // namespace kadr::cli
