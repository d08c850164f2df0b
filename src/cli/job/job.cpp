// Job: loads the program that the command line names, and everything that is needed to run the program. It is used by the rest of cli.

#include "cli/job/job.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

#include "cli/job/guessed_control.h"
#include "cli/job/setup_options.h"
#include "config/control/control_file.h"
#include "config/read_file.h"
#include "lang/text/utf16.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

/// Reads the set-up file and then applies the command-line options, which override the file. If an error occurs, it is printed and the
/// function returns false.
bool take_setup(Job& job, const Options& options) {
  std::vector<SetupSource> sources;
  if (!options.setup.empty()) {
    auto file = setup_source(options.setup);
    if (!file) {
      complain(file.error());
      return false;
    }
    sources.push_back(std::move(*file));
  }
  auto stated = setup_of_options(options, *job.def, job.lang);
  if (!stated) {
    complain(stated.error());
    return false;
  }
  sources.insert(sources.end(), stated->begin(), stated->end());
  for (const std::string& name : options.disabled) job.setup.disabled.push_back(alarm_named(name));
  if (sources.empty()) return true;
  auto read = read_setup(sources, job.def.get(), job.lang);
  if (!read) {
    complain(read.error());
    return false;
  }
  read->setup.disabled.insert(read->setup.disabled.end(), job.setup.disabled.begin(), job.setup.disabled.end());
  job.setup = std::move(read->setup);
  job.stated = std::move(read->stated);
  if (!options.setup.empty()) job.setup_lines = std::move(read->lines);
  return true;
}

/// Returns the control with this name. Each control file is read only once, even for a command with many programs. Prints errors.
///   returns  nullptr if the control cannot be read
std::shared_ptr<const ControlDef> control_named(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const ControlDef>> known;
  if (const auto found = known.find(name); found != known.end()) return found->second;
  auto def = load_control(name);
  if (!def) {
    complain(def.error());
    return nullptr;
  }
  return known[name] = std::make_shared<const ControlDef>(std::move(*def));
}

/// Returns the alarm texts of a control. They are read only once for each control.
std::shared_ptr<const AlarmTexts> texts_of(const std::shared_ptr<const ControlDef>& def) {
  static std::map<std::shared_ptr<const ControlDef>, std::shared_ptr<const AlarmTexts>> known;
  std::shared_ptr<const AlarmTexts>& of = known[def];
  if (of) return of;
  auto texts = AlarmTexts::load(def.get());
  if (!texts) complain(texts.error());
  return of = std::make_shared<const AlarmTexts>(texts ? std::move(*texts) : AlarmTexts());
}

}  // namespace

const AlarmTexts& Job::texts() const {
  if (!texts_) texts_ = texts_of(def);
  return *texts_;
}

std::string Job::place_of(const std::string& key) const {
  const std::uint32_t line = line_of(setup_lines, key);
  return line == 0 ? setup_file : fmt::format("{}:{}", setup_file, line);
}

std::string no_encoding(const std::string& name, Lang lang) {
  return translated_in(lang, texts::job::no_encoding, name, "utf-8, cp1251, koi8-r, cp866, utf-16, utf-16le, utf-16be, iso7, eia");
}

std::optional<Job> make_job(const Options& options, const std::string& file) {
  const auto control = control_of(options, file);
  if (!control || control->empty()) return std::nullopt;
  return make_job(options, file, *control);
}

std::optional<Job> make_job(const Options& options, const std::string& file, const std::string& control) {
  Job job;
  job.file = file;
  job.setup_file = options.setup;
  job.lang = language(options);
  job.program = options.program;
  job.def = control_named(control);
  if (!job.def) return std::nullopt;
  auto profile = load_machine(options.machine.empty() ? "generic" : options.machine);
  if (!profile) {
    complain(profile.error());
    return std::nullopt;
  }
  job.profile = std::move(*profile);
  if (!take_setup(job, options)) return std::nullopt;
  if (const std::string error = Plc(job.setup.events, job.def->reports_program_ends()).error(); !error.empty()) {
    complain(options.setup + ": " + error);
    return std::nullopt;
  }
  job.setup.skip.insert(job.setup.skip.end(), options.skip.begin(), options.skip.end());
  job.setup.optional_stop = job.setup.optional_stop || options.optional_stop;
  if (!read_encoding(options.encoding, job.encoding)) {
    complain(no_encoding(options.encoding, job.lang));
    return std::nullopt;
  }
  return job;
}

std::unique_ptr<Session> make_session(const Job& job, Program program, const RunLimits& limits) {
  auto session = Session::open({job.def, job.profile, job.setup, std::move(program), limits});
  if (session) return std::move(*session);
  const auto& [fault, number] = session.error();
  const std::string sentence = job.lang == Lang::ru ? fault.ru : fault.en;
  const std::string place = job.place_of(fault.key);
  complain(number != 0 ? translated_in(job.lang, texts::job::fault_of_channel, place, number, sentence)
                       : fmt::format("{}: {}", place, sentence));
  return nullptr;
}

}  // namespace kadr::cli
