#pragma once
// A program of one control as a program of another, proven equal: the text is made in several ways, the one that keeps most first, each is
// run by its control, and the first that does the same is taken: from the set-up that is given, and from others that differ in the zeros,
// lengths, radii and reference points that it does not state (convert/proving).
//
//   as it stands ─▶ word by word ─▶ contours and offsets as codes ─▶ offsets as codes ─▶ all of it calculated in

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "convert/program_shape.h"
#include "convert/source_setup.h"

namespace kadr {

/// How the program is said.
enum class ConvertedAs : std::uint8_t {
  as_it_stands,
  words,     // word by word, written out only where it must be (convert/word_by_word)
  contours,  // written out, and so are the next: FlatWay
  lengths,
  plain,
};

/// What is converted: how sessions of it are made.
struct ConversionSpec {
  using Opens = std::function<tl::expected<std::unique_ptr<Session>, std::string>(const Setup& setup)>;
  using OpensText =
      std::function<tl::expected<std::unique_ptr<Session>, std::string>(std::shared_ptr<ByteSource> text, const Setup& setup)>;
  Opens source;                             // of the program under its own control, from that set-up
  Setup setup;                              // from which the program begins
  OpensText target;                         // of a text under the other control, from that set-up
  std::shared_ptr<ByteSource> source_text;  // UTF-8, lines divided by '\n'
  const ControlDef* to = nullptr;
  bool flat = false;                        // calls, loops and cycles are written out even where the other control has them
  std::optional<ConvertedAs> only{};        // this way and no other
  double tolerance = 0;                     // mm; 0: usual_tolerance()
  std::optional<WrittenLetters> letters{};  // of the text; else those of the control
  StopToken stop{};
};

/// Lines that are written out where the others are rewritten.
struct WrittenOut {
  TextLines lines;
  std::optional<Alarm> cannot_say{};          // the other control has nothing for it …
  std::optional<CourseDifference> differs{};  // … or would do something else, here or nearby …
  bool varies = false;                        // … or it is not the same each time; none: contours and frames that are calculated in
};

/// One of the ways, and why it was not taken.
struct ConversionTry {
  ConvertedAs as = ConvertedAs::as_it_stands;
  std::optional<Alarm> cannot_say;  // the other control has nothing for …
  Origin at;                        // … this block
  Comparison proof;                 // where it could be said
  bool differs_unstated = false;    // `proof` is of another state than the one given: something is folded in that the set-up does not state
  bool differs_elsewhere = false;   // `proof` is of a probe that touches at another place
  bool zero_by_operator = false;  // proven where the zero of the part is set on the machine itself: one of the controls has no code for it
  std::optional<std::uint16_t> counts_from{};  // of `plain`: the work system of all its motions
  std::shared_ptr<ByteSource> text = text_source({});
  bool is_equal() const { return !cannot_say && text->size() != 0 && proof.equal() && !proof.stopped_a && !proof.stopped_b; }
  bool is_proven() const { return is_equal() && told_states.has_value(); }
  std::optional<std::size_t> told_states{};  // others in which it was proven; nullopt: not yet
  std::size_t transliterated = 0;            // characters that the other control's text has not
  std::vector<WrittenOut> written_out{};     // of `words`, in the order in which it was found
};

struct Converted {
  /// From which each of the tries was run: corresponding_setup().
  Setup setup, plain_setup;
  /// Codes of smoothing and the like that the program names and that written out blocks do not say, and of exact stops where the other
  /// control has none; those that it has not at all. They are not compared.
  std::vector<std::string> path_modes, path_modes_unknown;
  bool tools_by_hand = false;  // the other control cannot change tools: it stops there
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup : setup; }
  std::optional<std::size_t> taken;  // of `tries`; nothing: refused
  std::vector<ConversionTry> tries;
  double tolerance = 0;
};

/// mm that a way may be off by because its words are rounded, each by half an increment of the coarser word format: along lines those of
/// the three axes. An arc begins at one rounded place and turns around another, by which its radius is off, too: opposite its beginning it
/// is off by the one once and by the other twice.
///   arcs  the program may lead along some
double usual_tolerance(const ControlDef& from, const ControlDef& to, bool arcs);

///   returns  an error sentence: a session could not be opened
tl::expected<Converted, std::string> converted(const ConversionSpec& spec);

}  // namespace kadr
