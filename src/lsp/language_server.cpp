// LanguageServer: life cycle, documents, and the table of the methods. Used by cli/lsp_command; tested by tests/lsp.py.

#include "lsp/language_server.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "config/json_text.h"
#include "config/texts.h"
#include "lsp/features.h"
#include "lsp/workspace_folders.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr std::size_t max_folders = 4 * max_workspace_folders;  // folders whose programs are remembered

}  // namespace

LanguageServer::LanguageServer(Send send, Lang lang, std::string version) : send_(std::move(send)), version_(std::move(version)) {
  choice_.lang = lang;
}

LanguageServer::~LanguageServer() = default;

const std::map<std::string_view, LanguageServer::Method>& LanguageServer::requests() {
  using S = LanguageServer;
  static const std::map<std::string_view, Method> all = {
      {"initialize", &S::initialize},
      {"shutdown", &S::shutdown},
      {"textDocument/hover", &S::hover},
      {"textDocument/completion", &S::completion},
      {"textDocument/signatureHelp", &S::signature_help},
      {"textDocument/definition", &S::definition},
      {"textDocument/references", &S::references},
      {"textDocument/documentHighlight", &S::highlights},
      {"textDocument/prepareRename", &S::prepare_rename},
      {"textDocument/rename", &S::rename},
      {"textDocument/documentSymbol", &S::document_symbols},
      {"workspace/symbol", &S::workspace_symbols},
      {"textDocument/foldingRange", &S::folding},
      {"textDocument/semanticTokens/full", &S::tokens},
      {"textDocument/semanticTokens/range", &S::tokens_of_range},
      {"textDocument/inlayHint", &S::hints},
      {"textDocument/codeAction", &S::actions},
      {"textDocument/codeLens", &S::lenses},
      {"textDocument/formatting", &S::formatting},
  };
  return all;
}

const std::map<std::string_view, LanguageServer::Method>& LanguageServer::notifications() {
  using S = LanguageServer;
  static const std::map<std::string_view, Method> all = {
      {"initialized", &S::nothing},
      {"exit", &S::exit},
      {"$/cancelRequest", &S::cancel},
      {"textDocument/didOpen", &S::did_open},
      {"textDocument/didChange", &S::did_change},
      {"textDocument/didSave", &S::did_save},
      {"textDocument/didClose", &S::did_close},
      {"workspace/didChangeConfiguration", &S::did_change_configuration},
      {"workspace/didChangeWatchedFiles", &S::did_change_watched_files},
      {"workspace/didChangeWorkspaceFolders", &S::did_change_folders},
  };
  return all;
}

void LanguageServer::answer(const LspJson& id, const char* name, LspJson value) {
  send_(dumped_message({{"jsonrpc", "2.0"}, {"id", id}, {name, std::move(value)}}));
}

void LanguageServer::notify(const char* method, LspJson params) {
  send_(dumped_message({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}));
}

void LanguageServer::refuse(const LspJson& id, LspFault::Code code, std::string text) {
  answer(id, "error", {{"code", int(code)}, {"message", std::move(text)}});
}

void LanguageServer::refuse_cancelled(const LspJson& id) {
  refuse(id, LspFault::request_cancelled, translated_in(choice_.lang, texts::lsp::cancelled));
}

void LanguageServer::take(std::string_view text) {
  set_thread_language(choice_.lang);
  const LspJson message = json_of(text);
  if (message.is_discarded())
    return answer(nullptr, "error", {{"code", LspFault::parse_error}, {"message", translated(texts::lsp::no_json)}});
  const auto id = message.is_object() ? message.find("id") : message.end();
  const bool has_id = message.is_object() && id != message.end() && (id->is_number() || id->is_string());
  const LspJson answer_to = has_id ? *id : LspJson(nullptr);
  if (!message.is_object() || !message.contains("method") || !message["method"].is_string()) {
    // An answer of the editor to a request of the server has no method.
    if (has_id && (message.contains("result") || message.contains("error"))) return take_answer(message);
    return answer(answer_to, "error", {{"code", LspFault::invalid_request}, {"message", translated(texts::lsp::no_message)}});
  }
  if (message.contains("id") && !has_id)
    return answer(nullptr, "error", {{"code", LspFault::invalid_request}, {"message", translated(texts::lsp::wrong_member, "id")}});
  const std::string method = message["method"];
  const auto params = message.find("params");
  const LspJson given = params == message.end() ? LspJson(nullptr) : *params;
  if (has_id) return take_request(answer_to, method, given);
  const auto found = notifications().find(method);
  if (found == notifications().end() || (!initialized_ && method != "exit") || (shut_down_ && method != "exit")) return;
  try {
    (this->*found->second)(given);
  } catch (const LspFault& fault) {  // a notification has no answer; the log of the editor shows what is wrong with it
    constexpr int warning = 2;
    notify("window/logMessage", {{"type", warning}, {"message", method + ": " + fault.text}});
  }
}

void LanguageServer::take_request(const LspJson& id, const std::string& method, const LspJson& params) {
  if (shut_down_) return refuse(id, LspFault::invalid_request, translated(texts::lsp::shut_down));
  if (!initialized_ && method != "initialize") return refuse(id, LspFault::not_initialized, translated(texts::lsp::not_initialized));
  if (initialized_ && method == "initialize") return refuse(id, LspFault::invalid_request, translated(texts::lsp::initialized_twice));
  try {
    if (method == "workspace/executeCommand") return execute_command(id, params);
    const auto found = requests().find(method);
    if (found == requests().end()) throw LspFault{LspFault::method_not_found, translated(texts::lsp::no_such_method, method)};
    answer(id, "result", (this->*found->second)(params));
  } catch (const LspFault& fault) {
    refuse(id, fault.code, fault.text);
  }
}

OpenDocument& LanguageServer::document_of(const LspJson& params) {
  const std::string uri = text_in(member(params, "textDocument"), "uri");
  const auto found = documents_.find(uri);
  if (found == documents_.end()) throw LspFault{LspFault::invalid_params, translated(texts::lsp::not_open, uri)};
  return *found->second;
}

// ---- life cycle

void LanguageServer::choose(const LspJson& settings) {
  const LspJson& own = settings.is_object() && settings.contains("kadr") ? settings["kadr"] : settings;
  if (!own.is_object()) return;
  const auto read = [&](const char* name, std::string& to) {
    if (const auto value = own.find(name); value != own.end() && value->is_string()) to = value->get<std::string>();
  };
  DocumentChoice choice = choice_;
  std::string lang;
  read("control", choice.control), read("machine", choice.machine), read("setup", choice.setup), read("language", lang);
  if (!lang.empty()) choice.lang = language_named(lang).value_or(choice.lang);
  if (choice == choice_) return;
  choice_ = choice;
  for (auto& [uri, document] : documents_) document->reopen(choice_);
}

LspJson LanguageServer::initialize(const LspJson& params) {
  if (!params.is_object()) throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "params")};
  if (const auto locale = params.find("locale"); locale != params.end() && locale->is_string())
    choice_.lang = language_named(locale->get<std::string>()).value_or(choice_.lang);
  if (const auto options = params.find("initializationOptions"); options != params.end()) choose(*options);
  const LspJson::json_pointer encodings("/capabilities/general/positionEncodings");
  if (params.contains(encodings) && params[encodings].is_array())
    for (const auto& [name, unit] : {std::pair{"utf-8", ColumnUnit::utf8}, std::pair{"utf-32", ColumnUnit::utf32}})
      if (std::find(params[encodings].begin(), params[encodings].end(), name) != params[encodings].end()) {
        unit_ = unit;
        break;
      }
  if (const auto abilities = params.find("capabilities"); abilities != params.end()) editor_ = abilities_in(*abilities);
  workspace_ = workspace_folders_in(params);
  initialized_ = true;
  const char* const encoding = unit_ == ColumnUnit::utf8 ? "utf-8" : unit_ == ColumnUnit::utf32 ? "utf-32" : "utf-16";
  return {{"capabilities", capabilities_json(encoding)}, {"serverInfo", {{"name", "kadr"}, {"version", version_}}}};
}

LspJson LanguageServer::shutdown(const LspJson&) {
  shut_down_ = true;
  for (const Waiting& one : std::exchange(commands_, {})) refuse_cancelled(one.id);
  return nullptr;
}

LspJson LanguageServer::nothing(const LspJson&) { return nullptr; }

LspJson LanguageServer::exit(const LspJson&) {
  over_ = true;
  return nullptr;
}

// ---- documents

LspJson LanguageServer::did_open(const LspJson& params) {
  const LspJson& item = member(params, "textDocument");
  const std::string uri = text_in(item, "uri");
  const LspJson& version = member(item, "version");
  documents_[uri] = std::make_unique<OpenDocument>(uri, path_of_uri(uri).value_or(uri), text_in(item, "text"),
                                                   version.is_number_integer() ? version.get<int>() : 0, unit_, choice_);
  return nullptr;
}

LspJson LanguageServer::did_change(const LspJson& params) {
  OpenDocument& document = document_of(params);
  const LspJson& changes = member(params, "contentChanges");
  if (!changes.is_array()) throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "contentChanges")};
  for (const LspJson& change : changes) {
    std::optional<TextRange> range;
    if (change.is_object() && change.contains("range")) range = range_in(change["range"]);
    document.change(range, text_in(change, "text"));
  }
  const LspJson& item = member(params, "textDocument");
  if (const auto version = item.find("version"); version != item.end() && version->is_number_integer())
    document.version = version->get<int>();
  return nullptr;
}

LspJson LanguageServer::did_save(const LspJson& params) {
  document_of(params).reopen(choice_);
  return nullptr;
}

LspJson LanguageServer::did_close(const LspJson& params) {
  const OpenDocument& document = document_of(params);
  const std::string uri = document.uri;
  documents_.erase(uri);
  told_.erase(uri);
  notify("textDocument/publishDiagnostics", {{"uri", uri}, {"diagnostics", LspJson::array()}});
  return nullptr;
}

LspJson LanguageServer::did_change_configuration(const LspJson& params) {
  choose(member(params, "settings"));
  return nullptr;
}

/// A set-up, tools or control file, or a subprogram, has changed: every document may be affected.
LspJson LanguageServer::did_change_watched_files(const LspJson&) {
  for (auto& [uri, document] : documents_) document->reopen(choice_);
  return nullptr;
}

LspJson LanguageServer::did_change_folders(const LspJson& params) {
  const LspJson& event = member(params, "event");
  const std::vector<std::filesystem::path> added = folders_in(member(event, "added")), removed = folders_in(member(event, "removed"));
  std::erase_if(workspace_, [&](const auto& one) { return std::find(removed.begin(), removed.end(), one) != removed.end(); });
  for (const auto& one : added)
    if (workspace_.size() < max_workspace_folders) workspace_.push_back(one);
  return nullptr;
}

bool LanguageServer::has_work() const {
  if (shut_down_) return false;
  return !commands_.empty() || std::any_of(documents_.begin(), documents_.end(), [](const auto& one) { return !one.second->is_done(); });
}

void LanguageServer::work(const StopToken& stop) {
  set_thread_language(choice_.lang);
  if (!commands_.empty()) return work_on_command(stop);
  for (auto& [uri, document] : documents_) {
    if (document->is_checked()) continue;
    if (document->check(stop)) publish(*document);
    return;
  }
  for (auto& [uri, document] : documents_)
    if (!document->is_done()) return document->find_results(stop);
}

/// Adds the programs of a folder: the open documents of the same control, and the files that are not open.
void LanguageServer::add_programs(const std::filesystem::path& folder, const OpenDocument& document, FolderView& to) {
  const auto& def = document.opened()->def;
  std::vector<std::string> paths;
  for (const auto& [uri, other] : documents_) {
    const bool is_own = other.get() == &document;
    if (other->names() == nullptr || other->opened()->def->id != def->id) continue;
    if (std::filesystem::path(other->path).parent_path() != folder) continue;
    if (is_own) to.own = to.programs.size();
    to.open.push_back({uri, other->path, program_places(other->text(), *other->names())});
    to.programs.push_back(&to.open.back());
    paths.push_back(other->path);
  }
  if (!path_of_uri(document.uri)) return;
  ProgramFolder& files = folders_.try_emplace({folder.string(), def->id}, def, unit_).first->second;
  files.read(folder, paths);
  for (const ProgramFileNames& file : files.files()) to.programs.push_back(&file);
}

/// Returns the programs of the folder of a document that has a control. `wide`: also those of the other folders of the workspace.
FolderView LanguageServer::folder_of(const OpenDocument& document, bool wide) {
  constexpr std::size_t most_programs = 5000;
  if (folders_.size() > max_folders) folders_.clear();
  FolderView view;
  const std::filesystem::path own = std::filesystem::path(document.path).parent_path();
  add_programs(own, document, view);
  if (!wide) return view;
  for (const std::filesystem::path& folder : with_subfolders(workspace_))
    if (folder != own && view.programs.size() < most_programs) add_programs(folder, document, view);
  return view;
}

void LanguageServer::publish(const OpenDocument& document) {
  notify("textDocument/publishDiagnostics",
         {{"uri", document.uri}, {"version", document.version}, {"diagnostics", diagnostics_json(document)}});
  tell_control(document);
}

/// Tells an editor that wants to know it which control the program is for, when this has changed.
void LanguageServer::tell_control(const OpenDocument& document) {
  if (!editor_.wants_controls) return;
  const OpenedProgram* const opened = document.opened();
  const std::string control = opened == nullptr ? std::string() : opened->def->id;
  const auto [told, is_new] = told_.try_emplace(document.uri, control);
  if (!is_new && told->second == control) return;
  told->second = control;
  notify("kadr/control", {{"uri", document.uri}, {"control", control}, {"guessed", opened != nullptr && opened->guess.has_value()}});
}

// ---- features

LspJson LanguageServer::hover(const LspJson& params) {
  return hover_json(document_of(params), position_in(member(params, "position")), editor_.markdown);
}
LspJson LanguageServer::completion(const LspJson& params) {
  return completion_json(document_of(params), position_in(member(params, "position")));
}
LspJson LanguageServer::signature_help(const LspJson& params) {
  return signature_json(document_of(params), position_in(member(params, "position")));
}
LspJson LanguageServer::definition(const LspJson& params) {
  const OpenDocument& document = document_of(params);
  return definition_json(document, position_in(member(params, "position")), [&](bool wide) { return folder_of(document, wide); });
}
LspJson LanguageServer::references(const LspJson& params) {
  const OpenDocument& document = document_of(params);
  const LspJson::json_pointer declaration("/context/includeDeclaration");
  const bool with_definition = !params.contains(declaration) || params[declaration] != false;
  return references_json(document, position_in(member(params, "position")), with_definition,
                         [&](bool wide) { return folder_of(document, wide); });
}
LspJson LanguageServer::highlights(const LspJson& params) {
  return highlights_json(document_of(params), position_in(member(params, "position")));
}
LspJson LanguageServer::prepare_rename(const LspJson& params) {
  return renamed_place_json(document_of(params), position_in(member(params, "position")));
}
LspJson LanguageServer::rename(const LspJson& params) {
  return rename_json(document_of(params), position_in(member(params, "position")), text_in(params, "newName"));
}
LspJson LanguageServer::document_symbols(const LspJson& params) { return symbols_json(document_of(params), editor_.nested_symbols); }
LspJson LanguageServer::workspace_symbols(const LspJson& params) {
  LspJson all = LspJson::array();
  const std::string query = text_in(params, "query");
  for (const auto& [uri, document] : documents_) add_workspace_symbols(*document, query, all);
  std::set<std::string> done;
  for (const bool wide : {false, true})  // the control of a folder's own document reads its files first
    for (const auto& [uri, document] : documents_) {
      if (document->opened() == nullptr || (wide && workspace_.empty())) continue;
      for (const FolderView view = folder_of(*document, wide); const ProgramFileNames* const file : view.programs)
        if (!documents_.contains(file->uri) && done.insert(file->uri).second) add_file_symbols(*file, query, all);
    }
  return all;
}
LspJson LanguageServer::folding(const LspJson& params) { return folding_json(document_of(params)); }
LspJson LanguageServer::tokens(const LspJson& params) { return tokens_json(document_of(params)); }
LspJson LanguageServer::tokens_of_range(const LspJson& params) {
  return tokens_json(document_of(params), range_in(member(params, "range")));
}
LspJson LanguageServer::hints(const LspJson& params) { return hints_json(document_of(params), range_in(member(params, "range"))); }
LspJson LanguageServer::lenses(const LspJson& params) { return lenses_json(document_of(params)); }
LspJson LanguageServer::formatting(const LspJson& params) { return formatting_json(document_of(params)); }

}  // namespace kadr
