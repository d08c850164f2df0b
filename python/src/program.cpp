// A program with its control, machine and set-up. Used by run.cpp and views.cpp; tested by tests/python_binding.py.

#include "program.h"

#include <algorithm>
#include <cerrno>
#include <map>
#include <mutex>
#include <utility>

namespace kadr::python {
namespace {

/// Returns the value, or throws its error sentence as Failed.
template <class T>
T got(tl::expected<T, std::string> value) {
  if (!value) throw Failed{std::move(value.error())};
  return std::move(*value);
}

/// Returns the beginning of the text as UTF-8; the control is guessed from it.
std::string beginning_of(OpenedText text) {
  LineReader reader(std::move(text.source));
  const std::string_view sample = reader.sample();
  const auto encoding = text.encoding ? text.encoding : detect_encoding(sample);
  if (!encoding) return std::string(sample);
  std::string utf8;
  (void)append_utf8(sample, *encoding, utf8);  // decodes until the first invalid byte
  return utf8;
}

/// A control with its alarm texts.
struct ControlWithTexts {
  std::shared_ptr<const ControlDef> control;
  std::shared_ptr<const AlarmTexts> texts;
};

ControlWithTexts read_control(const std::string& name) {
  auto control = std::make_shared<const ControlDef>(got(load_control(name)));
  auto texts = std::make_shared<const AlarmTexts>(got(AlarmTexts::load(control.get())));
  return {std::move(control), std::move(texts)};
}

/// Returns the control with this id or file. A built-in control is read once: reading takes longer than checking a short program.
ControlWithTexts control_named(const std::string& name) {
  if (name.ends_with(".toml")) return read_control(name);
  static std::mutex mutex;
  static std::map<std::string, ControlWithTexts> known;
  const std::scoped_lock lock(mutex);
  if (const auto found = known.find(name); found != known.end()) return found->second;
  return known[name] = read_control(name);
}

/// The text of a program, and the programs that it contains.
struct Tape {
  std::shared_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
  TapeContents contents;
};

Tape tape_of(OpenedText text, const Grammar& grammar) {
  Tape tape{std::move(text.source), text.encoding, {}};
  if (!grammar.percent_number) return tape;
  const auto encoding = tape.encoding ? tape.encoding : detect_encoding(LineReader(tape.source).sample());
  if (count_program_signs(*tape.source, encoding) > 1) tape.contents = contents_of(tape.source, grammar, encoding);
  return tape;
}

}  // namespace

ProgramSpec::ProgramSpec(const ProgramRequest& request)
    : file_(request.file), named_(request.control), text_(request.text), lang_(request.lang) {
  std::string id = request.control;
  if (id.empty()) {
    const Guess guess = guess_control(beginning_of(as_text(source())));
    if (guess.control.empty())
      throw Failed{file_ + ": " + (lang_ == Lang::ru ? "УЧПУ неизвестно: " + guess.reason_ru : "unknown control: " + guess.reason_en)};
    id = guess.control;
  }
  const ControlWithTexts named = control_named(id);
  control_ = named.control;
  texts_ = named.texts;
  machine_ = got(load_machine(request.machine));
  setup_ = setup_of(request);
  (void)source();  // opens the file now, so that a missing file is reported at once
}

Setup ProgramSpec::setup_of(const ProgramRequest& request) {
  SetupSource from{"setup", request.setup_json};
  if (!request.setup_file.empty()) from = got(setup_source(request.setup_file));
  if (from.json.empty()) return {};
  PlacedSetup placed = got(read_setup({from}, control_.get(), lang_));
  stated_ = std::move(placed.stated);
  Setup setup = std::move(placed.setup);
  if (const std::string error = Plc(setup.events).error(); !error.empty()) throw Failed{from.place + ": " + error};
  return setup;
}

std::unique_ptr<ByteSource> ProgramSpec::source() const {
  if (text_) return text_source(*text_);
  errno = 0;
  auto source = open_file(file_);
  if (!source) throw FileFailed{errno, file_};
  return source;
}

std::string ProgramSpec::refusal() const {
  if (named_.empty() || named_.ends_with(".toml")) return {};
  return refused_by_control(beginning_of(as_text(source())), named_, lang_);
}

std::size_t ProgramSpec::count_programs() const {
  return std::max<std::size_t>(tape_of(as_text(source()), control_->grammar).contents.programs.size(), 1);
}

std::unique_ptr<Session> ProgramSpec::open(const std::atomic<bool>& stop, RunLimits limits) const {
  return open(as_text(source()), stop, std::move(limits));
}

std::unique_ptr<Session> ProgramSpec::open(const std::atomic<bool>& stop, RunLimits limits, std::size_t program) const {
  Tape tape = tape_of(as_text(source()), control_->grammar);
  if (program >= tape.contents.programs.size()) return open({whole_file(tape.source), tape.encoding}, stop, std::move(limits));
  const auto encoding = tape.encoding ? tape.encoding : detect_encoding(LineReader(tape.source).sample());
  return open({only_program(tape.source, tape.contents, program, encoding), tape.encoding}, stop, std::move(limits));
}

std::unique_ptr<Session> ProgramSpec::open(OpenedText text, const std::atomic<bool>& stop, RunLimits limits) const {
  limits.stop = StopToken(stop);
  auto session = Session::open({control_, machine_, setup_, {file_, std::move(text.source), text.encoding}, limits});
  if (!session) throw Failed{"setup: " + (lang_ == Lang::ru ? session.error().fault.ru : session.error().fault.en)};
  return std::move(*session);
}

TimeEstimate clock_of(Session& session, std::size_t channel) {
  const Channel& of = session.channels()[channel];
  TimeEstimate clock(AxisRoles::of(of.control->axes(), of.control->rotary()), rates_of(session.machine(), of.setup, of.control->axes()));
  clock.spindle(of.setup.spindle().rpm);
  return clock;
}

}  // namespace kadr::python
