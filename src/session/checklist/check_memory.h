#pragma once
// CheckMemory: what a check of a program stores on its way, so that the check of the changed text need not begin at its start.
//
//   text  ├────────●────────●────────●────×────    ●: a stored place;  ×: the first byte that has changed
//
// The check continues at the last place before which no byte from × on has been read. The state at that place depends only on bytes that
// have not changed, so the findings equal those of a check from the beginning.

#include <cstdint>
#include <memory>
#include <vector>

#include "session/checklist/checklist.h"
#include "session/checklist/stored_places.h"
#include "session/session.h"

namespace kadr {

class CheckMemory {
 public:
  /// Compares the text of a program with that of the last check. The program must then be read from the returned source. Its control,
  /// machine, set-up and encoding must be those of the last check; otherwise a new CheckMemory is needed.
  std::unique_ptr<ByteSource> follow(std::shared_ptr<ByteSource> text);

  // ---- for ProgramCheck, with a session that has a single channel

  /// The findings of a run before a stored place.
  struct Before {
    std::vector<AlarmReport> reports;
    std::size_t again = 0;  // number of findings that repeated one of these
  };
  /// Restores the last stored place in a session that has not started, and in its checklist.
  ///   returns  the findings before that place; nothing if there is no place, so that the run begins at the start
  Before continue_run(Session& session, Checklist& checklist);
  /// Stores the present place of the run, if it is far enough from the last one. `again`: as Before::again.
  void store_run(Session& session, const Checklist& checklist, std::size_t again);
  /// Notes a finding of the run.
  void note(const AlarmReport& report) { reports_.push_back(report); }
  /// The places of the checklist's reader.
  TextPlaces& text_places() { return text_places_; }

  /// Number of checks that continued at a stored place.
  std::size_t continued() const { return continued_; }

 private:
  struct RunPlace {
    SessionSnapshot session;
    Checklist::Memory checklist;
    std::size_t reported = 0;  // number of findings before the place
    std::size_t again = 0;     // as Before::again
  };

  std::shared_ptr<ByteSource> text_;
  const NotedSource* noted_ = nullptr;  // the source of the present session, which owns it
  StoredPlaces<RunPlace> run_places_;
  TextPlaces text_places_;
  std::vector<AlarmReport> reports_;  // findings of the run, in their order
  std::size_t continued_ = 0;
};

}  // namespace kadr
