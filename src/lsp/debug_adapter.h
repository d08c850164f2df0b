#pragma once
// DebugAdapter: runs a program for the debugger of an editor (Debug Adapter Protocol 1.51): breakpoints, steps forward and back, calls,
// values in force, lines of the operator. It receives and emits messages as JSON texts; serve_debugger() connects it with an editor.

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/stop_token.h"
#include "control/local_variables.h"
#include "lsp/lsp_json.h"
#include "lsp/run_history.h"
#include "session/stepping.h"
#include "view/opening.h"

namespace kadr {

class DebugAdapter {
 public:
  /// A function of the client that receives the messages of the adapter.
  using Send = std::function<void(std::string message)>;

  DebugAdapter(Send send, Lang lang) : send_(std::move(send)), lang_(lang) {}

  /// Executes one message. Each request gets one response. A program that runs is held first, except for requests about breakpoints.
  void take(std::string_view message);

  /// True while the program runs, forward or back: work() continues it.
  bool is_running() const { return running_ || search_; }
  /// Runs the program until it is held, until it ends, or until the stop token ends the work, at the next block; the next call continues
  /// it.
  void work(const StopToken& stop);

  bool is_over() const { return over_; }
  int exit_status() const { return over_ ? 0 : 1; }

 private:
  using Request = LspJson (DebugAdapter::*)(const LspJson& arguments);
  static const std::map<std::string_view, Request>& requests();

  /// A breakpoint that writes a message and does not hold the program, or that watches a value.
  struct Special {
    std::string message;  // text with {expressions}; empty: the breakpoint holds the program
    std::string watched;  // name of the variable whose change holds the program
  };

  void send(LspJson message);
  void event(const char* name, LspJson body);
  void output(const std::string& text, const char* category = "console");
  void open(const LspJson& arguments);
  void stop_at(Session::State state);
  void report_stop(const char* reason);
  bool passes_on(std::size_t point);
  void clear(const std::string& group);
  void renew_watches();
  void go(Stepping::How how, const char* reason);
  void enter(const std::string& line);
  bool asks_for(const Origin& block) const;
  void before_block(const Origin& block);
  void go_to_block(std::uint32_t number, const char* reason);
  void search_back();
  std::size_t depth_of_frame(const LspJson& arguments) const;
  std::vector<LocalVariables> locals() const;
  LspJson variables_json(const std::vector<std::pair<std::string, double>>& values) const;
  Result<double> value_in_frame(const std::string& expression, std::size_t depth) const;
  LspJson frame_json(int id, const std::string& name, const std::string& file, std::uint32_t line) const;
  std::string text_of(double value) const;
  std::string filled(const std::string& message) const;
  Stepping& stepping();
  Stepping& begun();
  std::uint32_t line_in(const LspJson& object) const;

  LspJson initialize(const LspJson& arguments);
  LspJson launch(const LspJson& arguments);
  LspJson configuration_done(const LspJson& arguments);
  LspJson set_breakpoints(const LspJson& arguments);
  LspJson set_call_breakpoints(const LspJson& arguments);
  LspJson watch_info(const LspJson& arguments);
  LspJson set_watches(const LspJson& arguments);
  LspJson nothing(const LspJson& arguments);
  LspJson threads(const LspJson& arguments);
  LspJson stack(const LspJson& arguments);
  LspJson scopes(const LspJson& arguments);
  LspJson variables(const LspJson& arguments);
  LspJson set_variable(const LspJson& arguments);
  LspJson evaluate(const LspJson& arguments);
  LspJson proceed(const LspJson& arguments);
  LspJson step_over(const LspJson& arguments);
  LspJson step_in(const LspJson& arguments);
  LspJson step_out(const LspJson& arguments);
  LspJson step_back(const LspJson& arguments);
  LspJson reverse(const LspJson& arguments);
  LspJson pause(const LspJson& arguments);
  LspJson restart(const LspJson& arguments);
  LspJson terminate(const LspJson& arguments);
  LspJson leave(const LspJson& arguments);

  const Send send_;
  Lang lang_;
  int sequence_ = 0;
  std::uint32_t first_line_ = 1;  // number of the first line of a file, as the editor counts
  std::optional<OpenedProgram> opened_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Stepping> stepping_;
  std::unique_ptr<RunHistory> history_;
  std::map<std::string, std::vector<std::size_t>> points_;  // by file, "call" or "watch": numbers of the stop points
  std::map<std::size_t, Special> special_;                  // by number of the stop point
  std::function<void()> afterwards_;                        // what follows the response to the present request
  bool stops_on_entry_ = true, configured_ = false, running_ = false, over_ = false;
  const char* reason_ = "step";              // why the program will be held, if no breakpoint holds it before
  Stepping::How how_ = Stepping::How::free;  // the step that is executed, and the number of calls that were open at its beginning
  std::size_t depth_ = 0;
  std::atomic<bool> gives_up_ = false;        // ends an entered line that takes too long
  StopToken stop_;                            // while work() runs: ends it at the next block
  bool interrupted_ = false;                  // true: the program runs, and is held between two blocks only while a message is executed
  std::optional<RunHistory::Search> search_;  // set: the program runs back to a breakpoint
  bool quiet_ = false;                        // true: blocks are executed again, so that their warnings have been shown already
};

/// Serves the debugger of an editor over two file descriptors until it disconnects or closes the input.
///   returns  the exit status of the process
int serve_debugger(int input, int output, Lang lang, const StopToken& stop);

}  // namespace kadr
