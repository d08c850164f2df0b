#pragma once
// PanelProgram: opens the sessions of a panel machine. It stores the text of the program, and the tables of the program with all edits.

#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "panel/session_opener.h"
#include "view/opening.h"
#include "view/page/page_json.h"

namespace kadr {

class PanelProgram {
 public:
  /// `request` is the request that opened the program; it contains the tables as edited so far.
  PanelProgram(OpenedProgram opened, OpeningRequest request);

  const OpenedProgram& opened() const { return opened_; }
  const std::string& setup_file() const { return request_.setup; }

  /// Sets the text of the program for all later runs and searches: the contents that the program file had when the program started. All
  /// functions below may be called from any thread.
  ///   bytes   contents of the file; nullptr: the file is too long or unreadable, and is read again each time
  ///   digest  identifies the contents of the file at that time; empty if the file is unreadable
  void take_text(std::shared_ptr<const std::string> bytes, std::string digest);
  std::string digest() const;
  /// Returns the text of the program as UTF-8, with line feeds between lines.
  ///   returns  nullopt if the text is not stored in memory
  std::optional<std::string> text() const;
  /// Completes each version of the tables by what the set-up does not state: the values that a real machine's controller has.
  void complete_with(std::function<Setup(Setup)> complete) { complete_ = std::move(complete); }
  /// Opens a session of the program. The page passes this function to PanelMachine as its SessionOpener.
  tl::expected<std::unique_ptr<Session>, std::string> open(const std::optional<Axes>& start, const StopToken& stop);

  struct Tables {
    PageJson edited;          // the edits in the form of a set-up, which override the set-up file
    Setup setup;              // the set-up file with the edits applied
    std::uint64_t after = 0;  // number of changes of the tables, including the change that led to this version
  };
  /// Returns the tables with a change applied, checked in the same way as any set-up. The change is a JSON merge patch (RFC 7386), in which
  /// null removes an edit.
  ///   returns  the tables, or an error sentence
  tl::expected<Tables, std::string> changed(const PageJson& patch) const;
  /// Checks that the program can be opened with these tables. The tables in use do not change.
  ///   returns  the reason why the control refuses the tables; empty if the control accepts them
  std::string refusal(const Tables& tables) const;
  /// Replaces the tables in use by tables that changed() has returned. Returns false, and replaces nothing, if the tables in use have
  /// changed in the meantime.
  bool take(Tables tables);
  /// Adds to the edits the changes that a line of the operator has made in the tables of the control.
  ///   returns  the change, or an error sentence if a set-up cannot contain this change
  tl::expected<PageJson, std::string> take_by_hand(const Setup& before, const Setup& after);
  PageJson edited() const;
  /// Returns the contents of the set-up file; empty if the program has no set-up file.
  ///   returns  the contents, or an error sentence
  tl::expected<PageJson, std::string> of_file() const;
  /// Returns the names of the tables that a set-up for this control may contain.
  std::vector<std::string> sections() const;

 private:
  bool knows_axes() const;
  tl::expected<Program, std::string> program() const;

  const OpenedProgram opened_;
  OpeningRequest request_;
  std::shared_ptr<const std::string> bytes_;
  std::string digest_;
  std::function<Setup(Setup)> complete_;
  std::vector<std::string> axes_;  // axis names of the control; known after the first session is opened
  mutable std::mutex lock_;
  PageJson edited_;
  Setup setup_;
  std::uint64_t changes_ = 0;
};

}  // namespace kadr
