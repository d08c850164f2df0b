#pragma once
// Converts a program of a source control to a program of a target control, and proves that both do the same. The program is expressed in
// several ways, the one that keeps most of the text first. The target control runs each text; the first text that does the same as the
// source program is used. It must do the same from the given set-up, and from other set-ups with other values for the work offsets, tool
// lengths, radii and reference points that the given set-up does not state (convert/proving).
//
//   unchanged ─▶ word by word ─▶ contours and offsets as codes ─▶ offsets as codes ─▶ all offsets applied to the coordinates

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "convert/program_shape.h"
#include "convert/source_setup.h"

namespace kadr {

/// How the converted program is expressed. "Expanded" means: written as single motions, without calls, loops and canned cycles.
enum class ConvertedAs : std::uint8_t {
  as_it_stands,
  words,     // rewritten word by word; lines are expanded only where necessary (convert/word_by_word)
  contours,  // with this value and the following ones the whole program is expanded, see FlatForm
  lengths,
  plain,
};

/// The program to convert, and the functions that create sessions of both controls.
struct ConversionSpec {
  using Opens = std::function<tl::expected<std::unique_ptr<Session>, std::string>(const Setup& setup)>;
  using OpensText =
      std::function<tl::expected<std::unique_ptr<Session>, std::string>(std::shared_ptr<ByteSource> text, const Setup& setup)>;
  Opens source;                             // opens the program under its own control, with this set-up
  Setup setup;                              // the set-up with which the program begins
  OpensText target;                         // opens a text under the target control, with this set-up
  std::shared_ptr<ByteSource> source_text;  // the program, UTF-8, lines separated by '\n'
  const ControlDef* to = nullptr;
  bool flat = false;                        // calls, loops and canned cycles are expanded even if the target control supports them
  std::optional<ConvertedAs> only{};        // try only this way
  double tolerance = 0;                     // allowed distance of the paths, mm; 0: usual_tolerance()
  std::optional<WrittenLetters> letters{};  // letters allowed in the text; nullopt: those of the target control
  StopToken stop{};
};

/// Lines that are expanded into single motions, while the other lines are rewritten word by word.
struct WrittenOut {
  TextLines lines;
  std::optional<Alarm> cannot_express{};      // reason, if the target control cannot express the lines
  std::optional<CourseDifference> differs{};  // reason, if the target control would do something else in the lines or nearby
  bool varies = false;                        // reason: executions of the lines differ; without any reason the lines are contours or frames
};

/// One of the ways that were tried, and the reason if it was not used.
struct ConversionTry {
  ConvertedAs as = ConvertedAs::as_it_stands;
  std::optional<Alarm> cannot_express;  // what the target control cannot express
  Origin at;                            // the block that cannot_express refers to
  Comparison proof;                     // the comparison of both programs, if the target control can express the program
  // `proof` is from a set-up with added table values: the text depends on values that the set-up does not state
  bool differs_unstated = false;
  bool differs_elsewhere = false;  // `proof` is from a run in which the probe touches at another point
  bool zero_by_operator = false;   // proven with the origin set by hand at the machine, since one of the controls has no code for it
  std::optional<std::uint16_t> counts_from{};  // for `plain`: the work system that all motions of the program use
  std::shared_ptr<ByteSource> text = text_source({});
  bool is_equal() const { return !cannot_express && text->size() != 0 && proof.equal() && !proof.stopped_a && !proof.stopped_b; }
  bool is_proven() const { return is_equal() && told_states.has_value(); }
  std::optional<std::size_t> told_states{};  // number of other states (set-ups) from which the text was proven; nullopt: not proven yet
  std::size_t transliterated = 0;            // number of characters replaced because the target control lacks their letters
  std::vector<WrittenOut> written_out{};     // for `words`, in the order in which the lines were found
};

struct Converted {
  /// The set-ups with which the target control ran the texts (corresponding_setup()); plain_setup is for ConvertedAs::plain.
  Setup setup, plain_setup;
  /// Codes that are not compared. path_modes: smoothing codes and the like that the program contains and that expanded blocks cannot
  /// express, also exact stops if the target control has none. path_modes_unknown: codes that the target control does not have at all.
  std::vector<std::string> path_modes, path_modes_unknown;
  bool tools_by_hand = false;  // the target control has no tool change code; it stops, and the operator changes the tool
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup : setup; }
  std::optional<std::size_t> taken;  // index in `tries`; nullopt: the conversion is refused
  std::vector<ConversionTry> tries;
  double tolerance = 0;
};

/// Returns the distance, mm, by which a path may differ because words are rounded, each by half an increment of the coarser word format.
/// On lines each of the three axes is rounded. On an arc the start and the centre are rounded, so its radius differs too: opposite the
/// start the error is that of the start plus twice that of the centre.
///   arcs  the program may contain arcs
double usual_tolerance(const ControlDef& from, const ControlDef& to, bool arcs);

///   returns  an error sentence if a session could not be opened
tl::expected<Converted, std::string> converted(const ConversionSpec& spec);

}  // namespace kadr
