// Connects a LanguageServer or a DebugAdapter with an editor over two file descriptors. Used by cli/lsp_command; tested by tests/lsp.py and
// tests/dap.py.

#include "lsp/debug_adapter.h"
#include "lsp/language_server.h"
#include "lsp/message_inbox.h"

namespace kadr {

int serve_editor(int input, int output, Lang lang, const std::string& version, const StopToken& stop) {
  MessageWriter writer(output);
  MessageInbox inbox(input, [&](const std::string& reason) {
    constexpr int type_error = 1;
    (void)writer.put(
        dumped_message({{"jsonrpc", "2.0"}, {"method", "window/logMessage"}, {"params", {{"type", type_error}, {"message", reason}}}}));
  });
  LanguageServer server([&](const std::string& message) { (void)writer.put(message); }, lang, version);
  // A check that is interrupted begins again. An editor that asks without a pause could therefore prevent it permanently, so it is
  // interrupted at most a few times in a row, and then only by a cancellation.
  constexpr int most_interruptions = 3;
  int interruptions = 0;
  while (!server.is_over() && !stop.requested()) {
    const bool busy = server.has_work();
    const auto message = inbox.next(!busy, stop);
    if (message) {
      if (message->cancelled) server.refuse_cancelled(message->id);
      else server.take(message->text);
    } else if (busy) {
      server.work(StopToken(interruptions < most_interruptions ? inbox.interrupts() : inbox.cancels()));
      interruptions = server.has_work() ? interruptions + 1 : 0;
    } else if (inbox.is_over()) {
      break;
    }
  }
  return server.exit_status();
}

int serve_debugger(int input, int output, Lang lang, const StopToken& stop) {
  MessageWriter writer(output);
  DebugAdapter adapter([&](const std::string& message) { (void)writer.put(message); }, lang);
  MessageInbox inbox(input, [](const std::string&) {});
  while (!adapter.is_over() && !stop.requested()) {
    if (const auto message = inbox.next(!adapter.is_running(), stop)) adapter.take(message->text);
    else if (inbox.is_over()) break;
    else adapter.work(StopToken(inbox.interrupts()));
  }
  return adapter.exit_status();
}

}  // namespace kadr
