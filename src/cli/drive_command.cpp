// kadr drive: runs a program on a machine with a controller of the Grbl family: proof, question, motion. The command is tested by
// tests/drive.py against a double of the controller behind a pseudo-terminal.

#include "texts/drive_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/drive_hand.h"
#include "cli/drive_program.h"
#include "cli/job/files.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "drive/grbl/grbl_fault.h"
#include "drive/grbl/grbl_proof.h"
#include "out/text/summary.h"
#include "texts/drive.h"
#include "texts/help_examples.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

using drive::GrblState;
using drive::LinkEvent;
using drive::LinkEventKind;
using drive::Verdict;

constexpr double homing_patience = 180, unlock_patience = 2;      // s
constexpr auto time_to_stop = std::chrono::milliseconds(15'000);  // after a signal, until the axes are at rest
constexpr std::size_t most_settings = 1U << 20;                   // greatest size of a file with settings, bytes

class DriveCommand {
 public:
  explicit DriveCommand(const DriveOptions& options) : o_(options), outputs_(language(options.run)) {}

  int run() {
    if (const int status = check_options(); status != ok) return status;
    if (o_.status) return connect() ? show_status() : alarms;
    program_ = DriveProgram::load(o_);
    if (!program_) return wrong_usage;
    outputs_.reads(program_->job().file);
    outputs_.writes("--out", o_.out);
    if (!outputs_.check() || !outputs_.open()) return wrong_usage;
    if (!o_.port.empty()) {
      if (!connect() || !prepare()) return interrupted() ? interrupted_status() : alarms;
    } else if (!read_settings()) {
      return wrong_usage;
    }
    auto job = open();
    if (!job) return o_.from == 0 ? wrong_usage : alarms;
    job->pass_probes();
    if (!examine(*job) || !outputs_.keep()) return alarms;
    if (!print_proof()) return alarms;
    if (o_.check) {
      job = open();
      if (!job) return alarms;
      job->pass_probes();
      if (!check_mode(*driver_, *job)) return interrupted() ? interrupted_status() : alarms;
    }
    if (!o_.go) {
      type_out("{}\n", translated(texts::drive_command::nothing_moved));
      return ok;
    }
    return move();
  }

 private:
  int check_options() const {
    const auto wrong = [](const std::string& text) {
      complain(text);
      return wrong_usage;
    };
    if (o_.program.empty() && !o_.status) return wrong(translated(texts::drive_command::no_program));
    if (o_.port.empty() && (o_.settings.empty() || o_.status)) return wrong(translated(texts::drive_command::port_or_settings));
    if ((o_.go || o_.check || o_.from != 0) && o_.port.empty()) return wrong(translated(texts::drive_command::go_needs_port));
    if (!drive::is_baud_rate(o_.baud)) return wrong(translated(texts::drive_command::no_baud, o_.baud));
    return ok;
  }

  bool connect() {
    drive::LineSettings line;
    line.baud = o_.baud;
    auto port = drive::open_port(o_.port, line);
    if (!port) {
      complain(port.error());
      return false;
    }
    if (o_.go) {
      auto log = drive::BlackBox::open(o_.log);
      if (!log) {
        complain(log.error());
        return false;
      }
      log_ = std::move(*log);
    }
    drive::LinkOptions options;
    options.resets = !o_.status;
    options.most_seconds_ahead = o_.ahead;
    options.line_rate = drive::characters_per_second(o_.port, line);
    driver_ = std::make_unique<drive::GrblDriver>(std::move(*port), log_.get(), options);
    return until_report();
  }

  /// Waits until the controller is connected and a report has come.
  bool until_report() {
    bool connected = false;
    while (!interrupted()) {
      for (const LinkEvent& event : driver_->step(DriveTimes::step)) {
        if (event.kind == LinkEventKind::fault) {
          complain(drive::fault_text(event, 0));
          return false;
        }
        connected = connected || event.kind == LinkEventKind::connected;
      }
      if (connected && driver_->link().view().machine) return true;
    }
    return false;
  }

  /// Homes or unlocks the controller if the user wants it, and checks that it is idle.
  bool prepare() {
    const auto& view = driver_->link().view();
    write_message(translated(texts::drive_command::connected, o_.port, view.version, name_of(view.state)) + "\n");
    if (o_.unlock && !run_command(*driver_, "$X", unlock_patience)) return false;
    if (o_.home && !run_command(*driver_, "$H", homing_patience)) return false;
    homed_ = o_.home;
    const double asked = driver_->now();
    while (!interrupted() && view.reported_at <= asked) (void)driver_->step(DriveTimes::step);
    if (view.state != GrblState::alarm) return true;
    complain(translated(texts::drive_command::locked));
    return false;
  }

  bool read_settings() {
    const auto bytes = read_all(o_.settings, most_settings);
    if (!bytes) return false;
    recorded_ = drive::grbl_settings_in(*bytes);
    return true;
  }

  const drive::GrblSettings& settings() const { return driver_ ? driver_->link().settings() : recorded_; }
  std::optional<drive::GrblPoint> position() const { return driver_ ? driver_->link().view().machine : std::nullopt; }

  /// Executes the whole program, and writes its lines if the user wants them.
  bool examine(drive::GrblJob& job) {
    while (auto line = job.next()) {
      if (o_.run.limits.stop.requested()) return false;
      if (!o_.out.empty() && line->kind != drive::LineKind::stop) write_data(outputs_.stream("--out"), line->text + "\n");
    }
    needs_ = job.needs();
    if (needs_.alarm) program_->print(*needs_.alarm);
    if (needs_.refused) complain(translated(texts::drive_command::line_not_allowed, program_->job().file, *needs_.refused));
    return !needs_.alarm && !needs_.refused;
  }

  bool is_accepted(const drive::ProofRow& row) const {
    return row.verdict != Verdict::refused || std::find(o_.accepted.begin(), o_.accepted.end(), row.id) != o_.accepted.end();
  }

  bool print_proof() const {
    const auto word_of = [](Verdict verdict) {
      return verdict == Verdict::right  ? plain_text(texts::drive_command::verdict_right)
             : verdict == Verdict::note ? plain_text(texts::drive_command::verdict_note)
                                        : plain_text(texts::drive_command::verdict_refused);
    };
    bool all = true;
    for (const drive::ProofRow& row : drive::grbl_proof(settings(), needs_, program_->setup(), homed_)) {
      type_out("{:<10} {:<9} {:<24} {}: {}; {}: {}{}{}\n", row.id, word_of(row.verdict), row.what,
               plain_text(texts::drive_command::column_controller), row.controller, plain_text(texts::drive_command::column_program),
               row.program, row.why.empty() ? "" : "; ", row.why);
      all = all && is_accepted(row);
    }
    type_out("{}\n", translated(texts::drive_command::job, needs_.lines, needs_.stops, duration_text(needs_.seconds)));
    if (!all) complain(translated(texts::drive_command::not_proven));
    return all;
  }

  /// Shows the first target, asks, and sends the program.
  int move() {
    if (needs_.first_target) {
      double distance = 0;
      for (std::size_t a = 0; a < drive::grbl_axes; ++a) distance = std::hypot(distance, (*needs_.first_target)[a] - needs_.start[a]);
      type_out("{}\n", translated(texts::drive_command::first_target, needs_.first_line, needs_.first_text, fmt::format("{:.3f}", distance),
                                  point_text(*needs_.first_target)));
    }
    type_out("{}\n", translated(texts::drive_command::ask));
    std::fflush(stdout);
    if (!hears_go(*driver_)) {
      write_message(translated(texts::drive_command::left) + "\n");
      return alarms;
    }
    allow_after_signal(time_to_stop);
    log_->note(fmt::format("{} lines {} from {}", program_->job().file, needs_.lines, std::max(o_.from, 1U)));
    const int status = run_all();
    if (!log_->is_right()) complain(translated(texts::drive_command::log_failed));
    return status;
  }

  /// Opens the program, or its rest from --from on.
  std::unique_ptr<drive::GrblJob> open() {
    if (o_.from == 0) return program_->open(settings(), position());
    Continuation how;
    how.line = o_.from;
    how.keeps_offsets = false;
    how.clear = clear_height();
    drive::GrblRestartPlan plan;
    plan.line = o_.from;
    plan.from = *position();
    plan.clear = std::max(how.clear, plan.from[2]);
    plan.spin_up = o_.spin_up;
    const auto restart = program_->restart(settings(), plan);
    if (!restart) return nullptr;
    if (needs_.lines == 0) {
      write_message(translated(texts::drive_command::goes_on, restart->text.first, restart->source) + "\n");
      for (const std::string& line : restart->head) write_message("  " + line + "\n");
    }
    return program_->open(settings(), position(), *restart);
  }
  /// The height above which the way to a line is free, machine coordinates: what the user states, else the highest point of the program.
  double clear_height() {
    if (o_.clear) return *o_.clear;
    if (!highest_) {
      highest_ = -INFINITY;
      if (const auto whole = program_->open(settings(), position())) {
        whole->pass_probes();
        if (const auto needs = drive::needs_of(*whole, o_.run.limits.stop); needs.most) highest_ = (*needs.most)[2];
      }
    }
    return *highest_;
  }

  /// Sends the program, stretch by stretch: a tool change, a probe motion, or work by hand at a stop begins a new one.
  int run_all() {
    auto job = open();
    if (!job) return alarms;
    for (int feed = o_.feed;; feed = driver_->link().view().overrides.feed) {
      Continuation how;
      const JobEnd end = run_job(*driver_, *job, needs_.lines, feed);
      if (!end.continues_at) return end.status;
      how.line = *end.continues_at;
      how.by_hand = end.by_hand;
      how.place = position();
      how.clear = clear_height();
      how.spin_up = o_.spin_up;
      if (end.by_hand) {
        if (!read_offsets(*driver_)) return stop_status();
        how.offsets_at_place = settings();
        if (!work_by_hand(*driver_)) return stop_status();
      }
      job = continued(*driver_, *program_, how);
      if (!job) return stop_status();
    }
  }
  /// Resets the controller, which then has nothing in its buffers and its spindle off. Returns the exit status.
  int stop_status() {
    driver_->link().stop();
    for (const double until = driver_->now() + DriveTimes::stop; driver_->now() < until;)
      for (const LinkEvent& event : driver_->step(DriveTimes::step))
        if (event.kind == LinkEventKind::stopped) return interrupted() ? interrupted_status() : alarms;
    return alarms;
  }

  int show_status() {
    const auto& view = driver_->link().view();
    const std::string state = view.state == GrblState::hold || view.state == GrblState::door
                                  ? fmt::format("{}:{}", name_of(view.state), view.substate)
                                  : std::string(name_of(view.state));
    const std::string free = view.free ? fmt::format("{}, {}", view.free->blocks, view.free->bytes) : std::string("-");
    type_out("{}\n", translated(texts::drive_command::status_line, state, point_text(*view.machine),
                                fmt::format("{:.0f}", driver_->age() * 1000), fmt::format("{:g}", view.feed),
                                fmt::format("{:g}", view.speed), free, view.pins.empty() ? std::string("-") : view.pins));
    return ok;
  }

  const DriveOptions& o_;
  Outputs outputs_;
  std::unique_ptr<DriveProgram> program_;
  std::unique_ptr<drive::BlackBox> log_;
  std::unique_ptr<drive::GrblDriver> driver_;
  drive::GrblSettings recorded_;
  drive::JobNeeds needs_;
  bool homed_ = false;
  std::optional<double> highest_;  // highest point of the whole program, machine coordinates, mm
};

}  // namespace

void add_drive(CLI::App& app, Commands& c) {
  CLI::App* const drive = app.add_subcommand("drive", translated(texts::drive_command::about));
  DriveOptions& o = c.drive;
  drive->add_option(plain_text(texts::values::program), o.program, translated(texts::drive_command::program));
  takes(drive->add_option("--port", o.port, translated(texts::drive_command::port)), plain_text(texts::drive_command::port_value));
  takes_file(drive->add_option("--settings", o.settings, translated(texts::drive_command::settings)));
  whole_number(drive->add_option("--baud", o.baud, translated(texts::drive_command::baud)), 300, 921600)->capture_default_str();
  drive->add_flag("--go", o.go, translated(texts::drive_command::go));
  drive->add_flag("--status", o.status, translated(texts::drive_command::status));
  drive->add_flag("--home", o.home, translated(texts::drive_command::home));
  drive->add_flag("--unlock", o.unlock, translated(texts::drive_command::unlock));
  takes(drive->add_option("--accept", o.accepted, translated(texts::drive_command::accept))->allow_extra_args(false),
        plain_text(texts::drive_command::row));
  drive->add_flag("--check", o.check, translated(texts::drive_command::check));
  whole_number(drive->add_option("--from", o.from, translated(texts::drive_command::from)), 1, 2'000'000'000);
  number(drive->add_option("--clear", o.clear, translated(texts::drive_command::clear)), "MM", -10000, 10000);
  number(drive->add_option("--spin-up", o.spin_up, translated(texts::drive_command::spin_up)), plain_text(texts::values::seconds), 0, 120)
      ->capture_default_str();
  whole_number(drive->add_option("--feed", o.feed, translated(texts::drive_command::feed)), 10, 200)->capture_default_str();
  number(drive->add_option("--ahead", o.ahead, translated(texts::drive_command::ahead)), plain_text(texts::values::seconds), 0, 60)
      ->capture_default_str();
  writes_file(drive->add_option("--log", o.log, translated(texts::drive_command::log)))->capture_default_str();
  writes_file(drive->add_option("--out", o.out, translated(texts::drive_command::out)));
  program_options(*drive, o.run);
  drive->footer(plain_text(texts::help_examples::drive));
}

int drive_machine(const DriveOptions& options) { return DriveCommand(options).run(); }

}  // namespace kadr::cli
