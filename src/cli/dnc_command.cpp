// kadr dnc send|receive|serve: programs over a serial line, to and from controls without a network. The command is tested by tests/dnc.py
// over pseudo-terminals.

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "cli/job/files.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "compare/comparison_text.h"
#include "config/read_file.h"
#include "drive/dnc/dnc_request.h"
#include "drive/dnc/dnc_transfer.h"
#include "lang/text/text_spool.h"
#include "out/text/alarm_print.h"
#include "texts/drive_command.h"
#include "texts/help_examples.h"
#include "texts/values.h"
#include "view/source_text.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;
using drive::DncReceiver;
using drive::DncSender;

constexpr double poll_seconds = 0.002;           // a few characters of a fast line: DC3 acts at once
constexpr std::size_t most_program = 64U << 20;  // bytes

class DncCommand {
 public:
  explicit DncCommand(const DncOptions& options) : o_(options) {}

  int run() {
    const drive::DncProfile* const profile = drive::dnc_profile_named(o_.profile);
    if (profile == nullptr) return wrong_usage;  // the option accepts only known profiles
    profile_ = *profile;
    if (o_.baud != 0) profile_.line.baud = o_.baud;
    if (!drive::is_baud_rate(profile_.line.baud)) {
      complain(translated(texts::drive_command::no_baud, profile_.line.baud));
      return wrong_usage;
    }
    const auto bytes = o_.task == "send" ? bytes_of_program(o_.file) : std::string();
    if (!bytes) return alarms;
    auto port = drive::open_port(o_.port, profile_.line);
    if (!port) {
      complain(port.error());
      return alarms;
    }
    port_ = std::move(*port);
    const int status = o_.task == "send" ? send(*bytes) : o_.task == "receive" ? receive_file() : serve();
    return interrupted() ? interrupted_status() : status;
  }

 private:
  double now() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  /// Returns the bytes of a program for the line, after its control has executed it. Prints an error and returns nullopt if the control
  /// would stop with an alarm, or if the code lacks a character.
  std::optional<std::string> bytes_of_program(const std::string& file) const {
    Options of_program = o_.run;
    of_program.programs = {file};
    std::string text;
    if (!o_.unchecked) {
      const auto job = make_job(of_program, file);
      if (!job || !is_right(*job)) return std::nullopt;
      text = whole_text(*utf8_text(open_text(file, job->encoding)));
    } else {
      const auto read = read_all(file, most_program);
      if (!read) return std::nullopt;
      text = *read;
    }
    auto bytes = drive::dnc_bytes(profile_, text);
    if (bytes) return std::move(*bytes);
    complain(translated(texts::drive_command::no_code, file, bytes.error().where.begin + 1));
    return std::nullopt;
  }

  bool is_right(const Job& job) const {
    auto program = open_program(job);
    if (!program) return false;
    const auto session = make_session(job, std::move(*program), o_.run.limits);
    if (!session) return false;
    session->outlets().warning = [](const AlarmReport&) {};
    if (session->run() != Session::State::stopped) return true;
    if (session->stopped().report) write_coloured_message(alarm_text(*session->stopped().report, job.texts(), job.lang, colours()));
    complain(translated(texts::drive_command::dnc_not_sent));
    return false;
  }

  int send(const std::string& bytes) {
    DncSender sender(profile_, bytes, now());
    while (sender.state() != DncSender::State::sent && !interrupted()) {
      const auto got = port_->read(poll_seconds);
      if (!got || !port_->write(take(sender, *got))) {
        complain(translated(texts::drive_command::dnc_port_lost, sender.position(), sender.size()));
        return alarms;
      }
      if (sender.state() == DncSender::State::refused) {
        complain(translated(texts::drive_command::dnc_refused, sender.position(), sender.size()));
        return alarms;
      }
      show_bar(translated(texts::drive_command::dnc_progress, sender.position(), sender.size()));
    }
    erase_bar();
    if (interrupted()) return alarms;
    write_message(translated(texts::drive_command::dnc_sent, sender.size(), sender.holds()) + "\n");
    return ok;
  }
  std::string take(DncSender& sender, const std::string& got) const {
    if (!got.empty()) sender.receive(got, now());
    return sender.take(now());
  }

  /// Returns the received program as text; nullopt if the port is gone, the program is too long, or the user interrupts.
  std::optional<drive::DncText> receive() {
    DncReceiver receiver(profile_, now(), o_.silence);
    while (receiver.state() == DncReceiver::State::waits || receiver.state() == DncReceiver::State::receives) {
      if (interrupted()) return std::nullopt;
      (void)port_->write(receiver.take_output());
      const auto got = port_->read(poll_seconds * 10);
      if (!got) {
        complain(translated(texts::drive_command::dnc_port_lost, receiver.bytes().size(), receiver.bytes().size()));
        return std::nullopt;
      }
      receiver.receive(*got, now());
      receiver.tick(now());
    }
    (void)port_->write(receiver.take_output());
    drive::DncText text = drive::dnc_text(profile_, receiver.bytes());
    if (text.faults > 0) complain(translated(texts::drive_command::dnc_faults, text.faults, text.first_fault));
    write_message(translated(texts::drive_command::dnc_received, receiver.bytes().size()) + "\n");
    return text;
  }

  int receive_file() {
    Outputs outputs(language(o_.run));
    outputs.writes("FILE", o_.file);
    if (!outputs.check()) return wrong_usage;
    const auto text = receive();
    if (!text) return alarms;
    if (!outputs.open()) return wrong_usage;
    write_data(outputs.stream("FILE"), text->text);
    if (!outputs.keep()) return wrong_usage;
    return text->faults == 0 ? ok : alarms;
  }

  /// Receives programs into a folder, and sends those that the control requests, until the user interrupts.
  int serve() {
    while (!interrupted()) {
      const auto text = receive();
      if (!text) return interrupted() ? ok : alarms;
      const auto name = drive::requested_program(text->text);
      if (name) answer(*name);
      else if (!store(*text)) return alarms;
    }
    return ok;
  }

  void answer(const std::string& name) {
    const fs::path file = fs::path(o_.file) / name;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return complain(translated(texts::drive_command::dnc_no_program, file.string()));
    write_message(translated(texts::drive_command::dnc_requested, file.string()) + "\n");
    const auto bytes = bytes_of_program(file.string());
    if (bytes) (void)send(*bytes);
  }

  /// Stores a received program by its number. An older one with another text keeps its content under a name with its time.
  bool store(const drive::DncText& text) const {
    const fs::path file = fs::path(o_.file) / (drive::name_of_program(text.text) + ".nc");
    fs::path kept;  // the version before; empty: there is none
    std::error_code error;
    if (fs::exists(file, error)) {
      const auto before = read_all(file.string(), most_program);
      if (before && *before == text.text) {
        write_message(translated(texts::drive_command::dnc_same, file.string()) + "\n");
        return true;
      }
      kept = version_of(file);
      fs::rename(file, kept, error);
      if (error) {
        complain(file.string() + ": " + error.message());
        return false;
      }
      write_message(translated(texts::drive_command::dnc_changed, file.string(), kept.filename().string()) + "\n");
    }
    std::ofstream to(file, std::ios::binary);
    to << text.text;
    to.close();
    if (!to) complain(translated(texts::drive_command::dnc_not_written, file.string()));
    else write_message(translated(texts::drive_command::dnc_stored, file.string()) + "\n");
    if (to && !kept.empty() && !o_.unchecked) show_changes(kept, file);
    return static_cast<bool>(to);
  }

  /// Opens a session of a stored program, and its job. Prints an error and returns nullptr if it cannot be executed.
  std::unique_ptr<Session> session_of(const fs::path& file, std::optional<Job>& job) const {
    Options of_program = o_.run;
    of_program.programs = {file.string()};
    job = make_job(of_program, file.string());
    auto program = job ? open_program(*job) : std::nullopt;
    return program ? make_session(*job, std::move(*program), o_.run.limits) : nullptr;
  }

  /// Executes both versions of a program and prints what the operator has changed at the control: not the texts, but what the machine does.
  void show_changes(const fs::path& before, const fs::path& now) const {
    constexpr std::size_t most_shown = 5;
    std::optional<Job> job_a, job_b;
    auto a = session_of(before, job_a), b = a ? session_of(now, job_b) : nullptr;
    if (!b || a->channels().size() != 1 || b->channels().size() != 1) return;
    CompareRules rules;
    rules.same_control = true;
    rules.max_reported = most_shown;
    rules.stop = o_.run.limits.stop;
    const Comparison made = compare_sessions(std::move(a), std::move(b), rules);
    const Lang lang = language(o_.run);
    for (const CourseDifference& d : made.differences)
      write_message(fmt::format("  {} | {}: {}\n", d.a.origin.line, d.b.origin.line, sentence_of(d, lang)));
    write_message("  " + summary_of(made, lang) + "\n");
  }

  /// Returns a name that no file has yet: O1.20261130-081502.nc, and with a number if several come in a second.
  static fs::path version_of(const fs::path& file) {
    const auto time = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    const std::string stem = fmt::format("{}.{:%Y%m%d-%H%M%S}", file.stem().string(), fmt::localtime(time));
    fs::path kept = file.parent_path() / (stem + ".nc");
    std::error_code error;
    for (int n = 2; fs::exists(kept, error); ++n) kept = file.parent_path() / fmt::format("{}-{}.nc", stem, n);
    return kept;
  }

  const DncOptions& o_;
  drive::DncProfile profile_{};
  std::unique_ptr<drive::BytePort> port_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

void add_dnc(CLI::App& app, Commands& c) {
  CLI::App* const dnc = app.add_subcommand("dnc", translated(texts::drive_command::dnc_about));
  dnc->require_subcommand(1);
  DncOptions& o = c.dnc;
  std::vector<std::string> profiles;
  for (const drive::DncProfile& profile : drive::dnc_profiles()) profiles.emplace_back(profile.id);
  const auto add = [&](const char* name, const std::string& about, const std::string& what, const std::string& meaning) {
    CLI::App* const task = dnc->add_subcommand(name, about);
    task->add_option(what, o.file, meaning)->required();
    takes(task->add_option("--port", o.port, translated(texts::drive_command::port)), plain_text(texts::drive_command::port_value))
        ->required();
    one_of(task->add_option("--profile", o.profile, translated(texts::drive_command::dnc_profile)), profiles)->required();
    whole_number(task->add_option("--baud", o.baud, translated(texts::drive_command::dnc_baud)), 300, 921600);
    number(task->add_option("--silence", o.silence, translated(texts::drive_command::dnc_silence)), plain_text(texts::values::seconds), 0.1,
           600)
        ->capture_default_str();
    return task;
  };
  const auto checks = [&](CLI::App& task) {
    task.add_flag("--unchecked", o.unchecked, translated(texts::drive_command::dnc_unchecked));
    program_options(task, o.run);
  };
  checks(*add("send", translated(texts::drive_command::dnc_send), plain_text(texts::values::program),
              translated(texts::drive_command::dnc_program)));
  language_option(*add("receive", translated(texts::drive_command::dnc_receive), plain_text(texts::values::file),
                       translated(texts::drive_command::dnc_file)),
                  o.run.lang);
  checks(*add("serve", translated(texts::drive_command::dnc_serve), plain_text(texts::values::folder),
              translated(texts::drive_command::dnc_folder)));
  dnc->footer(plain_text(texts::help_examples::dnc));
}

int exchange_programs(const DncOptions& options) { return DncCommand(options).run(); }

}  // namespace kadr::cli
