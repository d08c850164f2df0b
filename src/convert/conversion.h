#pragma once
// Converts a program of one control to a program of another, and proves that both do the same. The text is written in several ways, the one
// that keeps most of the program first; each text is run by its control, and the first that does the same is used. It must do the same from
// the given set-up, and from others that differ in the work offsets, tool lengths, radii and reference points that the given one does not
// state (convert/proving).
//
//   as it stands ─▶ word by word ─▶ contours and offsets as codes ─▶ offsets as codes ─▶ all offsets applied to the coordinates

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "convert/program_shape.h"
#include "convert/source_setup.h"

namespace kadr {

/// How the program is expressed.
enum class ConvertedAs : std::uint8_t {
  as_it_stands,
  words,     // word by word, and written out (without calls, loops and cycles) only where it must be (convert/word_by_word)
  contours,  // all written out, as in the following ways: FlatWay
  lengths,
  plain,
};

/// What is converted, and how its sessions are created.
struct ConversionSpec {
  using Opens = std::function<tl::expected<std::unique_ptr<Session>, std::string>(const Setup& setup)>;
  using OpensText =
      std::function<tl::expected<std::unique_ptr<Session>, std::string>(std::shared_ptr<ByteSource> text, const Setup& setup)>;
  Opens source;                             // opens the program under its own control, from that set-up
  Setup setup;                              // in which the program begins
  OpensText target;                         // opens a text under the other control, from that set-up
  std::shared_ptr<ByteSource> source_text;  // UTF-8, lines divided by '\n'
  const ControlDef* to = nullptr;
  bool flat = false;                        // calls, loops and canned cycles are written out even if the other control has them
  std::optional<ConvertedAs> only{};        // try this way only
  double tolerance = 0;                     // mm; 0: usual_tolerance()
  std::optional<WrittenLetters> letters{};  // letters allowed in the text; nullopt: those of the control
  StopToken stop{};
};

/// Lines that are written out while the others are rewritten.
struct WrittenOut {
  TextLines lines;
  std::optional<Alarm> cannot_say{};          // the reason: the other control cannot express them,
  std::optional<CourseDifference> differs{};  // or it would do something else, here or nearby,
  bool varies = false;                        // or they do not do the same each time. No reason: contours and frames, which are calculated
};

/// One of the ways that were tried, and why it was not used.
struct ConversionTry {
  ConvertedAs as = ConvertedAs::as_it_stands;
  std::optional<Alarm> cannot_say;  // what the other control cannot express
  Origin at;                        // the block of cannot_say
  Comparison proof;                 // the comparison, if the program could be expressed
  bool differs_unstated = false;    // `proof` is of another state: the text depends on something that the set-up does not state
  bool differs_elsewhere = false;   // `proof` is of a probe that touches at another point
  bool zero_by_operator = false;    // proven with the part's origin set on the machine itself, since one control has no code for it
  std::optional<std::uint16_t> counts_from{};  // for `plain`: the work system of all its motions
  std::shared_ptr<ByteSource> text = text_source({});
  bool is_equal() const { return !cannot_say && text->size() != 0 && proof.equal() && !proof.stopped_a && !proof.stopped_b; }
  bool is_proven() const { return is_equal() && told_states.has_value(); }
  std::optional<std::size_t> told_states{};  // number of other states in which it was proven; nullopt: not yet proven
  std::size_t transliterated = 0;            // characters that the other control's text does not have
  std::vector<WrittenOut> written_out{};     // for `words`, in the order in which they were found
};

struct Converted {
  /// The set-ups from which each of the tries was run: corresponding_setup().
  Setup setup, plain_setup;
  /// Codes that are not compared: those of smoothing and the like that the program names and that written-out blocks do not express, also
  /// exact stops if the other control has none; and, second, those that the other control does not have at all.
  std::vector<std::string> path_modes, path_modes_unknown;
  bool tools_by_hand = false;  // the other control cannot change tools: it stops for a change by hand
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup : setup; }
  std::optional<std::size_t> taken;  // index in `tries`; nullopt: the conversion is refused
  std::vector<ConversionTry> tries;
  double tolerance = 0;
};

/// Returns the distance in mm by which a path may differ because its words are rounded, each by half an increment of the coarser word
/// format. Along lines the three axes are rounded. An arc has a rounded start and a rounded centre, so its radius differs too: opposite its
/// start it is off by the error of the start once and by that of the centre twice.
///   arcs  the program may contain arcs
double usual_tolerance(const ControlDef& from, const ControlDef& to, bool arcs);

///   returns  an error sentence: a session could not be opened
tl::expected<Converted, std::string> converted(const ConversionSpec& spec);

}  // namespace kadr
