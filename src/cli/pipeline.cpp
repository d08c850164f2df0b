#include "cli/pipeline.h"

#include <fmt/core.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "config/control_file.h"
#include "config/guess.h"
#include "machine/virtual_machine.h"

namespace kadr::cli {
namespace {

volatile std::sig_atomic_t interrupt_seen = 0;
void note_interrupt(int) { interrupt_seen = 1; }

/// The control named, or the one the text looks like: said on stderr.
std::optional<std::string> control_of(const Options& options, const std::string& file) {
  if (!options.control.empty()) return options.control;
  auto source = open_file(file);
  if (!source) {
    complain(fmt::format("{}: {}", file, std::strerror(errno)));
    return std::nullopt;
  }
  LineReader reader(std::move(source));
  std::string text;
  const std::string_view sample = reader.sample();
  const auto encoding = options.encoding.empty() ? detect_encoding(sample) : encoding_named(options.encoding);
  if (encoding) (void)append_utf8(sample, *encoding, text);  // up to the first damaged byte
  const Guess guess = guess_control(encoding ? std::string_view(text) : sample);
  const bool ru = language(options) == Lang::ru;
  complain(ru ? fmt::format("{}: похоже на {} ({}); иначе: --control", file, guess.control, guess.reason_ru)
              : fmt::format("{}: looks like {} ({}); otherwise: --control", file, guess.control, guess.reason_en));
  return guess.control;
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}
bool interrupted() { return interrupt_seen != 0; }

std::optional<Job> make_job(const Options& options, const std::string& file) {
  Job job;
  job.file = file;
  const auto id = control_of(options, file);
  if (!id) return std::nullopt;
  auto def = load_control(*id);
  if (!def) return complain(def.error()), std::nullopt;
  job.def = std::make_unique<ControlDef>(std::move(*def));
  auto texts = AlarmTexts::load(job.def.get());
  if (!texts) return complain(texts.error()), std::nullopt;
  job.texts = std::make_unique<AlarmTexts>(std::move(*texts));
  auto profile = load_machine(options.machine.empty() ? "generic" : options.machine);
  if (!profile) return complain(profile.error()), std::nullopt;
  job.profile = std::move(*profile);
  if (!options.setup.empty()) {
    auto setup = load_setup(options.setup);
    if (!setup) return complain(setup.error()), std::nullopt;
    job.setup = std::move(*setup);
  }
  job.setup.skip.insert(job.setup.skip.end(), options.skip.begin(), options.skip.end());
  job.setup.optional_stop = job.setup.optional_stop || options.optional_stop;
  if (!options.encoding.empty()) {
    job.encoding = encoding_named(options.encoding);
    if (!job.encoding) return complain(fmt::format("no encoding '{}': utf-8, cp1251, koi8-r, cp866, iso7", options.encoding)), std::nullopt;
  }
  return job;
}

std::optional<Program> open_program(const Job& job) {
  Program program{job.file, open_file(job.file), job.encoding};
  if (!program.source) {
    complain(fmt::format("{}: {}", job.file, std::strerror(errno)));
    return std::nullopt;
  }
  return program;
}

Stopped carry_out(Control& control, const Job& job, const Outlets& outlets) {
  control.on_warning = outlets.warning;
  const Ending start = control.ending();
  VirtualMachine machine(control.axes(), control.rotary(), job.profile, job.setup, {start.position, start.machine_position});
  if (job.def->behaviour.machine_axes) machine.obey_parameters(job.setup);
  if (machine.has_limits()) control.hand_over_each_block();
  const auto answer = [&](const ProbeAnswer& touched) { control.answer(touched); };
  ActionBatch batch;
  for (;;) {
    const Control::State state = control.run(batch);  // lang, control: blocks → actions
    const auto follows = state == Control::State::running ? VirtualMachine::Follows::more : VirtualMachine::Follows::nothing;
    const VirtualMachine::Outcome taken = machine.take(batch, follows, answer);  // path, machine: limits, zones, probes
    for (std::size_t i = 0; i < taken.done; ++i) outlets.action(batch[i]);       // out: trace, summary, plot
    if (taken.alarm) {
      const AlarmReport report = control.report_for(*taken.alarm, taken.origin);
      if (taken.refused) control.refused();
      if (!outlets.alarm(report)) return {report, machine.position()};
      if (taken.refused) continue;
    }
    if (state == Control::State::stopped || control.is_stopped()) {
      const AlarmReport report = control.report();
      if (!outlets.alarm(report)) return {report, std::nullopt};
      control.go_on();
    }
    if (state == Control::State::ended) return {};
    if (interrupted()) {
      const AlarmReport report = control.report_for(alarm(AlarmId::interrupted, {}), batch.empty() ? Origin() : batch.back().origin);
      (void)outlets.alarm(report);
      return {report, std::nullopt};
    }
    if (outlets.batch) outlets.batch(control);
  }
}

}  // namespace kadr::cli
