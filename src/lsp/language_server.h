#pragma once
// LanguageServer: answers the messages of an editor (Language Server Protocol 3.17). It receives and emits messages as JSON texts, so that
// tests need no pipes; serve_editor() connects it with an editor.

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/stop_token.h"
#include "lsp/editor_abilities.h"
#include "lsp/lsp_json.h"
#include "lsp/open_document.h"
#include "lsp/program_folder.h"

namespace kadr {

struct CommandOutcome;
struct FolderView;

class LanguageServer {
 public:
  /// A function of the client that receives the messages of the server.
  using Send = std::function<void(std::string message)>;

  /// `lang`: the language of the texts, unless the editor names one.
  LanguageServer(Send send, Lang lang, std::string version);
  ~LanguageServer();

  /// Executes one message. Each request gets exactly one answer: a result or an error.
  void take(std::string_view message);
  /// Answers a request that the editor has cancelled before it was executed.
  void refuse_cancelled(const LspJson& id);

  /// True if a command waits, or if some document has changed since its last check, or since its last run.
  bool has_work() const;
  /// Executes a command that waits; else checks one such document and publishes the findings, or runs it for the results of its lines.
  ///   stop  ends the work early; the next call begins it again
  void work(const StopToken& stop);

  /// True after the notification `exit`.
  bool is_over() const { return over_; }
  /// Returns 0 if the editor has requested the shutdown before the exit, else 1.
  int exit_status() const { return shut_down_ ? 0 : 1; }

 private:
  using Method = LspJson (LanguageServer::*)(const LspJson& params);
  static const std::map<std::string_view, Method>& requests();
  static const std::map<std::string_view, Method>& notifications();

  void take_request(const LspJson& id, const std::string& method, const LspJson& params);
  void answer(const LspJson& id, const char* member, LspJson value);
  void refuse(const LspJson& id, LspFault::Code code, std::string text);
  void take_answer(const LspJson& message);
  void notify(const char* method, LspJson params);
  void ask(const char* method, LspJson params, std::function<void(const LspJson& answer)> then);
  void show(int type, const std::string& text);
  OpenDocument& document_of(const LspJson& params);
  void publish(const OpenDocument& document);
  void tell_control(const OpenDocument& document);
  void add_programs(const std::filesystem::path& folder, const OpenDocument& document, FolderView& to);
  FolderView folder_of(const OpenDocument& document, bool wide);
  void choose(const LspJson& settings);

  LspJson initialize(const LspJson& params);
  LspJson shutdown(const LspJson& params);
  LspJson nothing(const LspJson& params);
  LspJson exit(const LspJson& params);
  LspJson did_open(const LspJson& params);
  LspJson did_change(const LspJson& params);
  LspJson did_save(const LspJson& params);
  LspJson did_close(const LspJson& params);
  LspJson did_change_configuration(const LspJson& params);
  LspJson did_change_watched_files(const LspJson& params);
  LspJson did_change_folders(const LspJson& params);
  LspJson hover(const LspJson& params);
  LspJson completion(const LspJson& params);
  LspJson signature_help(const LspJson& params);
  LspJson definition(const LspJson& params);
  LspJson references(const LspJson& params);
  LspJson highlights(const LspJson& params);
  LspJson prepare_rename(const LspJson& params);
  LspJson rename(const LspJson& params);
  LspJson document_symbols(const LspJson& params);
  LspJson workspace_symbols(const LspJson& params);
  LspJson folding(const LspJson& params);
  LspJson tokens(const LspJson& params);
  LspJson tokens_of_range(const LspJson& params);
  LspJson hints(const LspJson& params);
  LspJson actions(const LspJson& params);
  void execute_command(const LspJson& id, const LspJson& params);
  void work_on_command(const StopToken& stop);
  void apply(const CommandOutcome& outcome);
  LspJson cancel(const LspJson& params);
  LspJson lenses(const LspJson& params);
  LspJson formatting(const LspJson& params);

  /// A command that waits for its execution. Its request is answered afterwards.
  struct Waiting {
    LspJson id;
    std::string command, uri, argument;
  };

  const Send send_;
  const std::string version_;
  EditorAbilities editor_;
  std::deque<Waiting> commands_;
  std::map<std::string, std::function<void(const LspJson& answer)>> asked_;  // requests to the editor, by id
  std::uint64_t last_asked_ = 0;
  DocumentChoice choice_;
  ColumnUnit unit_ = ColumnUnit::utf16;
  std::map<std::string, std::unique_ptr<OpenDocument>> documents_;        // by URI
  std::map<std::string, std::string> told_;                               // by URI: the control that the editor knows
  std::map<std::pair<std::string, std::string>, ProgramFolder> folders_;  // by path, and id of the control
  std::vector<std::filesystem::path> workspace_;                          // the folders that the editor shows
  bool initialized_ = false, shut_down_ = false, over_ = false;
};

/// Serves an editor over two file descriptors until it ends the session or closes the input. Checks run while no message waits.
///   returns  the exit status of the process
int serve_editor(int input, int output, Lang lang, const std::string& version, const StopToken& stop);

}  // namespace kadr
