#pragma once
// OpenDocument: a program that is open in an editor, with what Kadr knows of it: the control, the names in the text, the findings of the
// last check, and the position of the tool after each line.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lsp/document_names.h"
#include "lsp/text_document.h"
#include "out/text/alarm_print.h"
#include "out/text/quick_fix.h"
#include "session/checklist/check_memory.h"
#include "view/opening.h"

namespace kadr {

/// The control, machine and set-up that the user of the editor has chosen. An empty name: .kadr.toml or a guess decides.
struct DocumentChoice {
  std::string control, machine, setup;
  Lang lang = Lang::en;
  friend bool operator==(const DocumentChoice&, const DocumentChoice&) = default;
};

/// A finding of the check, at a place of the document itself.
struct DocumentFinding {
  Finding finding;
  TextRange range;
  std::optional<QuickFix> fix;
  std::optional<TextRange> fixed;  // the characters that the fix replaces
};

/// What the last execution of a line has done.
struct LineResult {
  bool moves = false;
  Axes to{};               // end of the last motion of the line, work coordinates, mm or degrees
  double seconds = 0;      // time of all executions of the line together, s
  double feed = 0;         // mm/min; 0: the line does not feed
  std::uint32_t runs = 0;  // number of motions of the line
};

class OpenDocument {
 public:
  OpenDocument(std::string uri, std::string path, std::string text, int version, ColumnUnit unit, DocumentChoice choice);

  const std::string uri, path;
  int version = 0;

  const TextDocument& text() const { return text_; }
  const DocumentNames* names() const { return names_ ? &*names_ : nullptr; }
  /// Returns the program with its control; nullptr if Kadr supports no control for it. The reason is in no_control().
  const OpenedProgram* opened() const { return opened_ ? &*opened_ : nullptr; }
  const std::string& no_control() const { return no_control_; }
  const std::vector<DocumentFinding>& findings() const { return findings_; }
  /// Returns what a line, counted from 0, has done when the program ran last; nullptr if it has not been executed, or if the text has
  /// changed since then.
  const LineResult* result(std::size_t line) const;
  /// True if the findings are those of the present text.
  bool is_checked() const { return checked_; }
  /// True if the results of the lines are those of the present text too.
  bool is_done() const { return checked_ && has_results_; }
  Lang lang() const { return choice_.lang; }

  /// Replaces a range of the text, or, without a range, the whole text.
  void change(const std::optional<TextRange>& range, const std::string& text);
  /// Opens the program again: after the document was saved, or if the user has chosen another one.
  void reopen(const DocumentChoice& choice);

  /// Checks the program.
  ///   returns  false if the stop token ended the check; then the findings are those of before
  bool check(const StopToken& stop);
  /// Runs the program for the results of its lines, after it was checked. A stop ends the run, and the results are those of before.
  void find_results(const StopToken& stop);

 private:
  bool find_faults(const StopToken& stop);
  void add(const AlarmReport& report, std::vector<DocumentFinding>& to) const;

  TextDocument text_;
  DocumentChoice choice_;
  std::optional<OpenedProgram> opened_;
  std::optional<DocumentNames> names_;
  std::string no_control_;
  std::vector<DocumentFinding> findings_;
  std::vector<LineResult> results_;  // by line, from 0
  CheckMemory check_memory_;         // the last check, of an earlier text
  bool checked_ = false, has_results_ = false;
};

}  // namespace kadr
