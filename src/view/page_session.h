#pragma once
// PageSession: the session of one page: requests in; answers, events and frames out (docs/panel-protocol.md). It uses no sockets itself.

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

/// Receives the output of a session. Called by the thread that answers.
class PageLine {
 public:
  virtual ~PageLine() = default;
  /// Waits while too much output is unsent. Returns false if the page has gone.
  virtual bool text(std::string message) = 0;
  virtual bool frame(std::string bytes) = 0;
};

/// The file that any page has opened last.
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

/// What all pages of a server share.
struct PageServer {
  const ServedFolder& folder;
  std::string token;    // required to change anything
  bool all_need_token;  // without the token not even viewing is allowed
  Lang lang = Lang::en;
  std::string version;                  // of Kadr
  LastOpened* last = nullptr;           // nullptr: not needed
  PanelHub* hub = nullptr;              // nullptr: no machines
  PanelJournal* journal = nullptr;      // of the machines; set if hub is
  const MemoryBound* memory = nullptr;  // for all sessions together; nullptr: no limit
};

class PageSession {
 public:
  static constexpr std::size_t most_message = std::size_t{16} << 20;  // bytes
  static constexpr int most_mistakes = 100;

  PageSession(const PageServer& server, PageLine& line);
  ~PageSession();
  PageSession(const PageSession&) = delete;
  PageSession& operator=(const PageSession&) = delete;

  /// To be called before take(), in order with stop(). Work continues until stop(), or ends at once if `stopped` came before its turn.
  void begin(bool stopped);
  /// Answers a message, and performs what it requests.
  ///   returns  false if too many messages were no requests, or the page has gone
  bool take(std::string_view message);
  /// Ends the current work at once. May be called from any thread.
  void stop();
  /// True if the message requests only stop(). It must still be passed to take().
  static bool asks_to_stop(std::string_view message);
  /// True if it requests an emergency stop: emergency() must be called at once, from any thread.
  static bool asks_for_emergency(std::string_view message);
  void emergency();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace kadr
