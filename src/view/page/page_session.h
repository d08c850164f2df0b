#pragma once
// PageSession: the session of one page. It receives requests, and emits answers, events and binary frames (docs/panel-protocol.md). The
// session does not use sockets itself.

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
struct RealPorts;
class ServedFolder;

/// Connection of a session to its page. The client (server/connection) implements these functions; the session calls them in the thread
/// that answers requests.
class PageLine {
 public:
  virtual ~PageLine() = default;
  /// A function of the client that sends a message to the page. It waits while too much output is unsent, and returns false if the page is
  /// closed.
  virtual bool text(std::string message) = 0;
  virtual bool frame(std::string bytes) = 0;
};

/// The name of the program file that a page of the server has opened last.
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
  std::string file_;  // name of the file; empty if no page has opened a file
};

/// The viewer of which reports are made (view/report/page_report), and the licence texts of its components. The text is empty if the
/// program was built without the viewer.
struct ReportViewer {
  std::string_view html, licences;
};

/// The data that all pages of a server share.
struct PageServer {
  const ServedFolder& folder;
  std::string token;    // secret that a page must send before it may change files or use machines
  bool all_need_token;  // true if a page without the token may not view anything either
  Lang lang = Lang::en;
  std::string version;                  // version of Kadr
  LastOpened* last = nullptr;           // where the last opened file is recorded; nullptr if it is not recorded
  PanelHub* hub = nullptr;              // the operator panels of the server; nullptr if the server has no operator panels
  PanelJournal* journal = nullptr;      // saved data of the panel machines; must be set if `hub` is set
  const MemoryBound* memory = nullptr;  // memory limit for all sessions together; nullptr: no limit
  ReportViewer viewer{};
  const RealPorts* real = nullptr;  // the ports with real machines; nullptr: only virtual machines
};

class PageSession {
 public:
  static constexpr std::size_t max_message = std::size_t{16} << 20;  // greatest length of a message, bytes
  static constexpr int max_mistakes = 100;

  PageSession(const PageServer& server, PageLine& line);
  ~PageSession();
  PageSession(const PageSession&) = delete;
  PageSession& operator=(const PageSession&) = delete;

  /// Prepares the session for the next message; must be called before take(), in the same order as stop() is called for the messages. If
  /// `stopped` is true, a stop was already requested for this message, and the work for the message ends at once.
  void begin(bool stopped);
  /// Answers a message, and executes what the message requests.
  ///   returns  false if too many messages were invalid, or the page is closed
  bool take(std::string_view message);
  /// Ends the current work at once. May be called from any thread.
  void stop();
  /// Returns true if the message only requests that the current work stops. The caller must then call stop() at once, and later pass the
  /// message to take().
  static bool asks_to_stop(std::string_view message);
  /// Returns true if the message requests an emergency stop. The caller must then call emergency() at once, from any thread.
  static bool asks_for_emergency(std::string_view message);
  void emergency();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace kadr
