#pragma once
// PageSession: one page's session: its questions in, answers, events and frames out (docs/panel-protocol.md). It knows no sockets.

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "config/alarm_texts.h"

namespace kadr {

class PanelHub;
class MemoryBound;
class PanelJournal;
class ServedFolder;

/// Where what is said goes. Called by the thread that answers.
class PageLine {
 public:
  virtual ~PageLine() = default;
  /// Waits while too much has not been taken off. False: nobody is there any more.
  virtual bool text(std::string message) = 0;
  virtual bool frame(std::string bytes) = 0;
};

/// The file that was opened last, by any page.
class LastOpened {
 public:
  std::string get() const {
    const std::lock_guard hold(lock_);
    return file_;
  }
  void set(const std::string& file) {
    const std::lock_guard hold(lock_);
    file_ = file;
  }

 private:
  mutable std::mutex lock_;
  std::string file_;  // empty: none
};

/// What all pages of a server have in common.
struct PageServer {
  const ServedFolder& folder;
  std::string token;    // that who may change something knows
  bool all_need_token;  // who does not know it may not even look
  Lang lang = Lang::en;
  std::string version;                  // of Kadr
  LastOpened* last = nullptr;           // nullptr: nobody asks
  PanelHub* hub = nullptr;              // nullptr: there are no machines
  PanelJournal* journal = nullptr;      // of theirs; there where the hub is
  const MemoryBound* memory = nullptr;  // of all sessions together; nullptr: there is none
};

class PageSession {
 public:
  static constexpr std::size_t most_message = std::size_t{16} << 20;  // bytes
  static constexpr int most_mistakes = 100;

  PageSession(const PageServer& server, PageLine& line);
  ~PageSession();
  PageSession(const PageSession&) = delete;
  PageSession& operator=(const PageSession&) = delete;

  /// Before take(), in step with stop(): work goes on until that, or is to end at once (`stopped` before it came to its turn).
  void begin(bool stopped);
  /// Answers a message, and carries out what it asks for.
  ///   returns  false: too many were no questions, or nobody is there any more
  bool take(std::string_view message);
  /// What is being worked on ends at once. From any thread.
  void stop();
  /// The message asks for nothing but that. It is to be given to take() all the same.
  static bool asks_to_stop(std::string_view message);
  /// … for an emergency stop: emergency() is to be called at once, from any thread.
  static bool asks_for_emergency(std::string_view message);
  void emergency();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace kadr
