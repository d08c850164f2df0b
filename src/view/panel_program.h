#pragma once
// PanelProgram: creates the sessions of a panel machine: holds the program and its tables with all edits.

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "panel/panel_opens.h"
#include "view/opening.h"
#include "view/page_json.h"

namespace kadr {

class PanelProgram {
 public:
  /// `wish`: the request that opened it, including its tables.
  PanelProgram(OpenedProgram opened, OpeningWish wish);

  const OpenedProgram& opened() const { return opened_; }
  const std::string& setup_file() const { return wish_.setup; }

  // All functions below may be called from any thread.
  /// Sets the program as it was on the disk when the machine started: this text is run and searched until the program starts again.
  ///   bytes   nullptr: the file is read each time, since it is long or unreadable
  ///   digest  of the file at that time; empty if it is unreadable
  void take_text(std::shared_ptr<const std::string> bytes, std::string digest);
  std::string digest() const;
  /// The text as UTF-8, with '\n' between lines.
  ///   returns  nullopt if the text is not held
  std::optional<std::string> text() const;
  /// Implements PanelOpens.
  tl::expected<std::unique_ptr<Session>, std::string> open(const std::optional<Axes>& start, const StopToken& stop);

  struct Tables {
    PageJson edited;          // in the form of a set-up, overrides the file
    Setup setup;              // file and edits combined
    std::uint64_t after = 0;  // number of changes before this one
  };
  /// The result of a change (JSON merge patch, RFC 7386: null reverts an edit), checked like any set-up.
  ///   returns  an error sentence
  tl::expected<Tables, std::string> changed(const PageJson& patch) const;
  /// Opens the program with the tables as a test.
  ///   returns  why the control refuses them; empty if it accepts them
  std::string refusal(const Tables& tables) const;
  /// Returns false if the tables have been changed meanwhile.
  bool take(Tables tables);
  /// Applies a change of tables that a line of the operator has made in the control.
  ///   returns  the change, or an error sentence if it does not fit a set-up
  tl::expected<PageJson, std::string> take_by_hand(const Setup& before, const Setup& after);
  PageJson edited() const;
  /// Contents of the set-up file; empty if there is none.
  ///   returns  an error sentence
  tl::expected<PageJson, std::string> of_file() const;
  /// Names of the tables that a set-up of this control may have.
  std::vector<std::string> sections() const;

 private:
  bool knows_axes() const;
  tl::expected<Program, std::string> program() const;

  const OpenedProgram opened_;
  OpeningWish wish_;
  std::shared_ptr<const std::string> bytes_;
  std::string digest_;
  std::vector<std::string> axes_;  // of its control; known after the first session
  mutable std::mutex lock_;
  PageJson edited_;
  Setup setup_;
  std::uint64_t changes_ = 0;
};

}  // namespace kadr
