// Converts or edits an opened program. Used by view/page and lsp/proven_commands; tested by tests/serve_convert.py, tests/serve_edit.py and
// tests/lsp.py.

#include "view/proven_text.h"

#include <algorithm>

#include "compare/comparison_text.h"
#include "convert/conversion_text.h"
#include "out/text/alarm_print.h"
#include "texts/edit_command.h"

namespace kadr {
namespace {

constexpr std::size_t max_reasons = 20;

using ProofSide = tl::expected<std::unique_ptr<Session>, std::string>;

ProofSide session_of(SessionSpec spec) {
  auto session = Session::open(std::move(spec));
  if (session) return std::move(*session);
  const SetupFault& fault = session.error().fault;
  return tl::unexpected(fault.key + ": " + in_thread_language(fault.en, fault.ru));
}

/// Opens a session of a program, from a given set-up.
ProofSide proof_side_of(const OpenedProgram& opened, tl::expected<Program, std::string> program, const Setup& setup,
                        const StopToken& stop) {
  if (!program) return tl::unexpected(program.error());
  SessionSpec spec = opened.spec(std::move(*program), stop);
  spec.setup = setup;
  return session_of(std::move(spec));
}

}  // namespace

tl::expected<Converted, std::string> converted_program(const OpenedProgram& from, const std::shared_ptr<const ControlDef>& to,
                                                       std::string text, bool flat, const StopToken& stop) {
  ConversionSpec spec;
  spec.to = to.get();
  spec.flat = flat;
  spec.stop = stop;
  spec.source_text = text_source(std::move(text));
  spec.source = [&](const Setup& setup) -> ProofSide {
    ProofSide side = proof_side_of(from, from.program(), setup, stop);
    if (side && (*side)->channels().size() > 1) return tl::unexpected(no_conversion_of_channels());
    return side;
  };
  spec.setup = from.setup;
  spec.target = [&](std::shared_ptr<ByteSource> made, const Setup& setup) -> ProofSide {
    SessionSpec target = from.spec({from.path, shared_source(std::move(made)), Encoding::utf8}, stop);
    target.control = to;
    target.setup = setup;
    ProofSide side = session_of(std::move(target));
    if (side) (*side)->control().set_waiting(Control::Waiting::pass);
    return side;
  };
  return converted(spec);
}

tl::expected<Edited, EditFault> edited_program(const OpenedProgram& opened, const std::string& text, Edits edits, const StopToken& stop) {
  EditSpec spec;
  spec.old_program = [&](const Setup& setup) { return proof_side_of(opened, opened.program_of(text), setup, stop); };
  spec.new_program = [&](std::shared_ptr<ByteSource> made, const Setup& setup) {
    return proof_side_of(opened, opened.program_of({shared_source(std::move(made)), Encoding::utf8}), setup, stop);
  };
  spec.source_text = text_source(text);
  spec.setup = opened.setup;
  spec.edits = std::move(edits);
  spec.stop = stop;
  return edited(spec, {text_source(text), Encoding::utf8, opened.def.get()});
}

std::vector<EditReason> edit_reasons(const Comparison& proof, const OpenedProgram& opened, Lang lang) {
  std::vector<EditReason> list;
  const auto add_alarm = [&](const AlarmReport& report) {
    list.push_back({finding_of(report, *opened.texts, lang).text, report.origin.file == 0 ? report.origin.line : 0});
  };
  if (proof.stopped_a) {
    list.push_back({translated_in(lang, texts::edit_command::program_stops), 0});
    add_alarm(*proof.stopped_a);
    return list;
  }
  list.push_back({translated_in(lang, texts::edit_command::not_proven), 0});
  for (std::size_t i = 0; i < std::min(max_reasons, proof.differences.size()); ++i) {
    const CourseDifference& d = proof.differences[i];
    list.push_back({sentence_of(d, lang), d.a.file.empty() ? d.a.origin.line : 0});
  }
  if (proof.stopped_b) add_alarm(*proof.stopped_b);
  return list;
}

}  // namespace kadr
