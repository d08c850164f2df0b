// A program with its control, machine and set-up. Used by run.cpp and views.cpp; tested by tests/python_binding.py.

#include "program.h"

#include <cerrno>
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

}  // namespace

ProgramSpec::ProgramSpec(const ProgramRequest& request) : file_(request.file), text_(request.text), lang_(request.lang) {
  std::string id = request.control;
  if (id.empty()) {
    const Guess guess = guess_control(beginning_of(as_text(source())));
    if (guess.control.empty())
      throw Failed{file_ + ": " + (lang_ == Lang::ru ? "УЧПУ неизвестно: " + guess.reason_ru : "unknown control: " + guess.reason_en)};
    id = guess.control;
  }
  control_ = std::make_shared<const ControlDef>(got(load_control(id)));
  machine_ = got(load_machine(request.machine));
  setup_ = setup_of(request);
  texts_ = got(AlarmTexts::load(control_.get()));
  (void)source();  // opens the file now, so that a missing file is reported at once
}

Setup ProgramSpec::setup_of(const ProgramRequest& request) const {
  SetupSource from{"setup", request.setup_json};
  if (!request.setup_file.empty()) from = got(setup_source(request.setup_file));
  if (from.json.empty()) return {};
  Setup setup = got(read_setup({from}, control_.get(), lang_)).setup;
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

std::unique_ptr<Session> ProgramSpec::open(const std::atomic<bool>& stop, RunLimits limits) const {
  OpenedText text = as_text(source());
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
