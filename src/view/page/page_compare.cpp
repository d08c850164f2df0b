// Answers the request `compare`: compares two versions of a program. Used by view/page/page_session; tested by tests/serve.py.

#include <algorithm>

#include "compare/comparison_text.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_differences = 1000;
// Default and limits of the tolerance in a request, mm.
constexpr double default_tolerance = 0.001, least_tolerance = 1e-5, greatest_tolerance = 10;

PageJson spot_json(const CourseSpot& from, const CourseSpot& to) {
  return {{"line", from.origin.line},
          {"file", from.origin.file},
          {"number", from.origin.number},
          {"at", from.at},
          {"to_line", to.origin.line},
          {"to_number", to.origin.number},
          {"to_at", to.at}};
}

PageJson comparison_json(const Comparison& c, double tolerance, Lang lang) {
  PageJson differences = PageJson::array();
  double most = c.greatest;
  for (const CourseDifference& d : c.differences) {
    most = std::max(most, d.distance);
    differences.push_back({{"kind", name_of(d.kind)},
                           {"text", sentence_of(d, lang)},
                           {"distance", d.distance},
                           {"a", spot_json(d.a, d.a_to)},
                           {"b", spot_json(d.b, d.b_to)}});
  }
  PageJson first = differences.empty() ? PageJson() : differences.front();
  return {{"same", c.equal()},
          {"text", summary_of(c, lang)},
          {"tolerance", tolerance},
          {"deviation", most},
          {"moves", {c.moves_a, c.moves_b}},
          {"first", std::move(first)},
          {"differences", std::move(differences)},
          {"more", c.more},
          {"lost", c.lost}};
}

}  // namespace

/// Compares the open program with another file, or with another text of the same program, on the same machine with the same set-up. The
/// page receives the path of the other program after the answer.
PageSession::Inside::Answer PageSession::Inside::compare(const PageJson& question) {
  OpeningRequest request = opened_request;
  request.control = value_in<std::string>(question, "control", request.control.empty() ? run->opened().def->id : request.control);
  request.text.reset();
  if (question.contains("text") && question["text"].is_string()) request.text = question["text"].get<std::string>();
  if (question.contains("file")) {
    const auto path = server.folder.path_of(value_in<std::string>(question, "file", ""));
    if (!path) return tl::unexpected(Refusal{path.error()});
    request.path = *path;
  } else if (!request.text) {
    return tl::unexpected(Refusal{translated(texts::page::nothing_to_compare)});
  }
  auto other = open_for_page(request);
  if (!other) return tl::unexpected(Refusal{other.error()});
  CompareRules rules;
  rules.tolerance = value_in<double>(question, "tolerance", default_tolerance);
  if (!(rules.tolerance >= least_tolerance && rules.tolerance <= greatest_tolerance)) rules.tolerance = default_tolerance;
  rules.max_reported = max_differences;
  rules.stop = token();
  std::unique_ptr<Session> sides[2];
  for (const int side : {0, 1}) {
    const OpenedProgram& opened = side == 0 ? run->opened() : *other;
    auto program = opened.program();
    if (!program) return tl::unexpected(Refusal{program.error()});
    auto session = Session::open(opened.spec(std::move(*program), token()));
    if (!session) return tl::unexpected(Refusal{in_thread_language(session.error().fault.en, session.error().fault.ru)});
    sides[side] = std::move(*session);
  }
  if (sides[0]->channels().size() > 1 || sides[1]->channels().size() > 1)
    return tl::unexpected(Refusal{translated(texts::page::channels_not_compared)});
  const Comparison made = compare_sessions(std::move(sides[0]), std::move(sides[1]), rules);
  if (made.cancelled) return tl::unexpected(Refusal{translated(texts::page::interrupted)});
  auto other_run = ProgramRun::make(*other, token());
  if (!other_run) return tl::unexpected(Refusal{other_run.error()});
  afterwards = [this, its = std::shared_ptr<ProgramRun>(std::move(*other_run))] {
    its->on_piece = [this](const ViewPiece& piece, std::uint32_t channel) { send(piece, 1, channel); };
    its->execute();
    send({{"event", "compared"}, {"seconds", its->seconds()}, {"blocks", its->blocks()}});
  };
  return comparison_json(made, rules.tolerance, lang);
}

}  // namespace kadr
