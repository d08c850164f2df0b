#pragma once
// Converts a program of a source control to a program of a target control, and proves that both do the same. There are several methods to
// express the program; the one that keeps most of the text is tried first. The target control runs each text, and the first text that does
// the same as the source program is used. The text must do the same from the given set-up, and from set-ups with other values for the work
// offsets, tool lengths, radii and reference points that the given set-up does not state (convert/proving).
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

/// The method by which the converted program is expressed. "Expanded" means: written as single motions, without calls, loops and canned
/// cycles.
enum class ConvertedAs : std::uint8_t {
  as_it_stands,
  words,     // rewritten word by word; lines are expanded only where the proof requires it (convert/word_by_word)
  contours,  // this method and all that follow expand the whole program, see FlatForm
  lengths,
  plain,
};

/// The program to convert, and the functions that create sessions of both controls.
struct ConversionSpec {
  using Opens = std::function<tl::expected<std::unique_ptr<Session>, std::string>(const Setup& setup)>;
  using OpensText =
      std::function<tl::expected<std::unique_ptr<Session>, std::string>(std::shared_ptr<ByteSource> text, const Setup& setup)>;
  Opens source;                             // opens the program under the source control, with a given set-up
  Setup setup;                              // set-up of the source control with which the program begins
  OpensText target;                         // opens a text under the target control, with a given set-up
  std::shared_ptr<ByteSource> source_text;  // text of the program, UTF-8, lines separated by '\n'
  const ControlDef* to = nullptr;
  bool flat = false;                        // expand calls, loops and canned cycles even if the target control supports them
  std::optional<ConvertedAs> only{};        // the only method to try; nullopt: all methods
  double tolerance = 0;                     // permitted distance between the paths, mm; 0: usual_tolerance()
  std::optional<WrittenLetters> letters{};  // letters that the converted text may contain; nullopt: those of the target control
  StopToken stop{};
};

/// Lines that are expanded into single motions, while the rest is rewritten word by word, and the reason for the expansion. If no reason is
/// set, the lines are contours or frames.
struct WrittenOut {
  TextLines lines;
  // set if the lines are expanded because the target control cannot express them: the alarm that says so
  std::optional<Alarm> cannot_express{};
  // set if the lines are expanded because the target control would do something else in these lines or nearby: the difference
  std::optional<CourseDifference> differs{};
  bool varies = false;  // true: the lines are expanded because two executions of them differ
};

/// One of the methods that were tried, and the reason why its text was not used.
struct ConversionTry {
  ConvertedAs as = ConvertedAs::as_it_stands;
  std::optional<Alarm> cannot_express;  // alarm about what the target control cannot express
  Origin at;                            // location of the block that cannot_express is about
  // result of comparing the source program with the converted text, if the target control can express the program
  Comparison proof;
  // true: the comparison `proof` is from a set-up with added table values, so the text depends on values that the given set-up does not
  // state
  bool differs_unstated = false;
  bool differs_elsewhere = false;  // true: the comparison `proof` is from a run in which the probe touches at another point
  // True: the text is proven if the operator sets the origin by hand at the machine, since one of the controls has no code for it.
  bool zero_by_operator = false;
  // for the method `plain` (all offsets applied): the number of the work system that all motions of the program use
  std::optional<std::uint16_t> counts_from{};
  std::shared_ptr<ByteSource> text = text_source({});
  bool is_equal() const { return !cannot_express && text->size() != 0 && proof.equal() && !proof.stopped_a && !proof.stopped_b; }
  bool is_proven() const { return is_equal() && proven_states.has_value(); }
  // Number of other states (set-ups) from which the text was proven; nullopt: the text is not proven yet
  std::optional<std::size_t> proven_states{};
  std::size_t transliterated = 0;  // number of characters that were replaced because the target control lacks their letters
  // for the method `words` (word by word): the expanded lines, in the order in which they were found
  std::vector<WrittenOut> written_out{};
};

struct Converted {
  /// The set-ups with which the target control ran the converted texts (corresponding_setup()): plain_setup for the method
  /// ConvertedAs::plain, setup for all other methods.
  Setup setup, plain_setup;
  /// Codes that are not compared. path_modes: codes of the program, for smoothing and the like, that expanded blocks cannot express; also
  /// exact stops if the target control has none. path_modes_unknown: codes that the target control does not have at all.
  std::vector<std::string> path_modes, path_modes_unknown;
  // True: one of the controls is that of a lathe, and the proof takes the wear of tools that the set-up does not state as 0 (wears_alike())
  bool wear_is_zero = false;
  bool tools_by_hand = false;  // the target control has no tool change code: the program stops, and the operator changes the tool
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup : setup; }
  std::optional<std::size_t> taken;  // index, in `tries`, of the text that is used; nullopt: the conversion is refused
  std::vector<ConversionTry> tries;
  double tolerance = 0;
};

/// Returns the distance, mm, by which a path may differ because words are rounded, each by half an increment of the coarser word format. On
/// lines, the coordinates of three axes are rounded. On an arc, start and centre are rounded, so the radius changes too: opposite the
/// start, the error is that of the start plus twice that of the centre.
///   arcs  the program may contain arcs
double usual_tolerance(const ControlDef& from, const ControlDef& to, bool arcs);

///   returns  an error sentence if a session could not be opened
tl::expected<Converted, std::string> converted(const ConversionSpec& spec);

}  // namespace kadr
