#pragma once
// Opens a session of a program given as text and keeps its trace in memory.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "config/control/control_file.h"
#include "control/run_program.h"
#include "out/trace/trace.h"
#include "session/session.h"
#include "some_programs.h"

namespace kadr::test {

inline std::shared_ptr<const ControlDef> shared_control(const std::string& id) {
  return {&control(id), [](const ControlDef*) {}};  // never deleted: it lives as long as the tests
}

inline const MachineProfile& generic_machine() {
  static const MachineProfile machine = load_machine("generic").value();
  return machine;
}

/// A file in memory, for text that a program writes.
class Written {
 public:
  Written() : file_(::open_memstream(&text_, &size_)) {}
  ~Written() {
    std::fclose(file_);
    std::free(text_);  // NOLINT: of open_memstream
  }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  std::FILE* file() const { return file_; }
  std::string text() const {
    std::fflush(file_);
    return {text_, size_};
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* file_;
};

/// A session that traces only the program's own channel.
class ASession {
 public:
  ASession(const std::string& id, const std::string& program, const Setup& setup = {}, const std::string& file = "main.nc",
           const MachineProfile& machine = generic_machine()) {
    auto opened = Session::open({shared_control(id), machine, setup, {file, text_source(program), {}}, {20'000, 5}});
    if (!opened) return;
    session_ = std::move(*opened);
    Control& control = session_->control();
    if (session_->channels().size() == 1) control.set_waiting(Control::Waiting::pass);
    trace_ = std::make_unique<TraceWriter>(written_.file(), control.axes(), control.rotary());
    session_->outlets().step = [this](const Step& step) { trace_->write(step); };
    session_->outlets().warning = [this](const AlarmReport& report) { note_report(report); };
    session_->outlets().alarm = [this](const AlarmReport& report) {
      note_report(report);
      return false;
    };
  }
  bool opened() const { return session_ != nullptr; }
  Session& operator*() const { return *session_; }
  Session* operator->() const { return session_.get(); }
  std::string trace() const {
    trace_->flush();
    return written_.text();
  }
  const std::vector<std::string>& reported() const { return reported_; }

 private:
  void note_report(const AlarmReport& report) {
    reported_.push_back(std::string(name_of(report.alarm.id)) + " " + std::to_string(report.origin.line));
  }

  Written written_;
  std::unique_ptr<TraceWriter> trace_;
  std::vector<std::string> reported_;
  std::unique_ptr<Session> session_;
};

}  // namespace kadr::test
