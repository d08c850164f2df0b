#pragma once
// PanelProgram: what the sessions of a machine at its panel are made of: the program, and its tables as they have been edited.

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
  /// `wish`: as it was opened, its tables too.
  PanelProgram(OpenedProgram opened, OpeningWish wish);

  const OpenedProgram& opened() const { return opened_; }
  const std::string& setup_file() const { return wish_.setup; }

  // From any thread.
  /// The program as it lay on the disk when the machine began: what it runs, and what places are found in, until it begins anew.
  ///   bytes   nothing: it is read from the disk each time, for it is long or cannot be read
  ///   digest  of the file then; empty: it cannot be read
  void take_text(std::shared_ptr<const std::string> bytes, std::string digest);
  std::string digest() const;
  /// As UTF-8, lines divided by '\n'.
  ///   returns  nothing: it is not held
  std::optional<std::string> text() const;
  /// PanelOpens.
  tl::expected<std::unique_ptr<Session>, std::string> open(const std::optional<Axes>& start, const StopToken& stop);

  struct Tables {
    PageJson edited;          // in the form of a set-up, laid over the file
    Setup setup;              // both together
    std::uint64_t after = 0;  // so many changes
  };
  /// What would come of a change (JSON merge patch, RFC 7386: null takes an edit back), checked as set-ups are.
  ///   returns  an error sentence
  tl::expected<Tables, std::string> changed(const PageJson& patch) const;
  /// Opens the program with them, for nothing but this.
  ///   returns  why the control refuses them; empty: it does not
  std::string refusal(const Tables& tables) const;
  /// False: they have been changed meanwhile.
  bool take(Tables tables);
  /// A line of the operator has changed tables of the control.
  ///   returns  the change, or an error sentence: they are no set-up's
  tl::expected<PageJson, std::string> take_by_hand(const Setup& before, const Setup& after);
  PageJson edited() const;
  /// Of the set-up file; empty: there is none.
  ///   returns  an error sentence
  tl::expected<PageJson, std::string> of_file() const;
  /// Tables that a set-up of this control may have.
  std::vector<std::string> sections() const;

 private:
  bool knows_axes() const;
  tl::expected<Program, std::string> program() const;

  const OpenedProgram opened_;
  OpeningWish wish_;
  std::shared_ptr<const std::string> bytes_;
  std::string digest_;
  std::vector<std::string> axes_;  // of its control, from the first session on
  mutable std::mutex lock_;
  PageJson edited_;
  Setup setup_;
  std::uint64_t changes_ = 0;
};

}  // namespace kadr
