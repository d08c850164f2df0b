// Checklist: observes a run with the watches (classes that look for one kind of problem each) and reports their findings. It is used by
// cli/check and view, and tested by tests/checklist.py.

#include "session/checklist/checklist.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <tuple>

#include "base/ascii.h"
#include "config/machine/machine_axes.h"
#include "config/setup/setup_names.h"
#include "motion/time/estimate.h"

namespace kadr {
namespace {

/// Returns the rapid rate of each axis, mm/min, as far as the set-up or the machine's file states it; 0: unknown. The rates of the generic
/// machine are not those of any machine.
Axes stated_rapids(const Session& session, std::size_t channel) {
  const Channel& of = session.channels()[channel];
  const std::vector<std::string>& axes = of.control->axes();
  const Rates rates = rates_of(session.machine(), of.setup, axes);
  const bool by_file = session.machine().id != MachineProfile{}.id;
  Axes stated{};
  for (std::size_t i = 0; i < std::min(axes.size(), max_axes); ++i) {
    const auto in_setup = [&](const std::string& name) {
      const auto row = of.setup.machine.find(name);
      return row != of.setup.machine.end() && row->second.rapid;
    };
    if (by_file || in_setup(axes[i]) || in_setup("*")) stated[i] = rates.most[i];
  }
  return stated;
}

/// Returns the location of the first word with the address `address` outside comments. Returns the whole line if it has no such word.
Span place_of(const std::string& line, char address) {
  const auto whole = Span{0, static_cast<std::uint32_t>(line.size())};
  if (address == 0) return whole;
  bool comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') comment = true;
    if (line[i] == ')') comment = false;
    if (line[i] == ';') break;
    if (comment || std::toupper(static_cast<unsigned char>(line[i])) != address) continue;
    std::size_t end = i + 1;
    while (end < line.size() && (std::string_view("+-.#[]").find(line[end]) != std::string_view::npos || is_digit(line[end]))) ++end;
    if (end > i + 1) return {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end)};
  }
  return whole;
}

}  // namespace

Checklist::Checklist(Session& session, std::size_t channel, ChecklistBasis basis)
    : session_(session),
      channel_(channel),
      basis_(std::move(basis)),
      roles_(AxisRoles::of(session.channels()[channel].control->axes(), session.channels()[channel].control->rotary())),
      steps_(std::in_place, roles_, session.stand(channel)),
      lathe_(stated_rapids(session, channel), session.channels()[channel].setup.chuck_face) {}

void Checklist::attach() {
  session_.outlets(channel_).programmed = [this](const Action& action) { take(action); };
}

void Checklist::take(const Action& action) {
  steps_->give(action, [this](const Step& step) {
    tools_.take(step, advices_);
    feeds_.take(step, advices_);
    holes_.take(step, advices_);
    levels_.take(step, advices_);
    path_.take(step, advices_);
    lathe_.take(step, advices_);
  });
}

void Checklist::resume_from(const Memory& memory) {
  steps_.emplace(roles_, memory.stands);
  advices_ = memory.advices;
  tools_ = memory.tools;
  feeds_ = memory.feeds;
  holes_ = memory.holes;
  levels_ = memory.levels;
  path_ = memory.path;
  lathe_ = memory.lathe;
}

TextWatch Checklist::read_text(std::shared_ptr<const ControlDef> def, const StopToken& stop, TextPlaces* places) const {
  const Channel& channel = session_.channels()[channel_];
  const TextReading* const before = places == nullptr ? nullptr : places->last();
  TextWatch text = before == nullptr ? TextWatch(def, most_rpm_of(session_.machine(), channel.setup)) : before->watch;
  const auto source = channel.control->source_of(0);
  if (!source) return text;
  const auto noted = std::make_shared<NotedSource>(source);
  const auto from = before == nullptr ? std::optional<TextWatch::Place>() : before->place;
  const auto store = [&](const TextWatch::Place& place) {
    if (places->wants(noted->known(), noted->size())) places->store(noted->known(), {text, place});
  };
  text.read(BlockReader(noted, def->grammar, channel.control->encoding()), stop, from,
            places == nullptr ? std::function<void(const TextWatch::Place&)>() : store);
  return text;
}

std::vector<AlarmReport> Checklist::reports(const StopToken& stop, TextPlaces* places) {
  const Control& control = *session_.channels()[channel_].control;
  auto fitted = std::make_shared<ControlDef>(session_.def());
  const ControlDef& def = *fitted;
  // the result of fit_to_machine() is ignored, since faults of the set-up have been reported before the run
  (void)fit_to_machine(*fitted, session_.channels()[channel_].setup);
  TextWatch text = read_text(fitted, stop, places);
  Advices advices = advices_;
  tools_.finish(system_names(def), advices);
  feeds_.finish(text.teeth(), advices);
  levels_.finish(advices);
  path_.finish(advices);
  text.finish(advices);
  if (const auto& cut = levels_.ends_in_cut(); cut && !text.has_end() && !def.behaviour.end_required)
    advices.add(AlarmId::end_missing, *cut, 0);
  // True if other channels exist. They may use rows of the tool and offset tables that this channel does not use.
  const bool shared = session_.channels().size() > 1;
  check_tables({basis_.tools, basis_.own_tools && !shared, basis_.own_setup && !shared}, text.named(), session_.channels()[channel_].setup,
               control.use(), advices);
  return reports_of(advices);
}

std::vector<AlarmReport> Checklist::reports_of(const Advices& advices) const {
  const Channel& channel = session_.channels()[channel_];
  const std::vector<AlarmId>& disabled = session_.setup().disabled;
  std::map<std::uint16_t, std::set<std::uint32_t>> lines;
  for (const Advice& a : advices.all()) lines[a.origin.file].insert(a.origin.line);
  std::map<std::uint16_t, std::map<std::uint32_t, std::string>> texts;
  for (const auto& [file, numbers] : lines) texts[file] = channel.control->texts_of(numbers, file);
  std::set<std::tuple<std::uint16_t, std::uint32_t, AlarmId>> seen;
  std::vector<AlarmReport> reports;
  for (const Advice& a : advices.all()) {
    if (std::find(disabled.begin(), disabled.end(), a.alarm.id) != disabled.end()) continue;
    if (!seen.insert({a.origin.file, a.origin.line, a.alarm.id}).second) continue;
    AlarmReport report;
    report.alarm = a.alarm;
    report.file = channel.control->file_name(a.origin.file);
    report.origin = a.origin;
    const auto& of_file = texts[a.origin.file];
    if (const auto line = of_file.find(a.origin.line); line != of_file.end()) report.line_text = line->second;
    if (report.alarm.where == Span{}) report.alarm.where = place_of(report.line_text, a.address);
    reports.push_back(std::move(report));
  }
  std::stable_sort(reports.begin(), reports.end(), [](const AlarmReport& a, const AlarmReport& b) {
    return std::tie(a.origin.file, a.origin.line) < std::tie(b.origin.file, b.origin.line);
  });
  return reports;
}

}  // namespace kadr
