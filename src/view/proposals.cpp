// Proposes tools from tools files, the set-up and comments. Used by view/page/page_part; tested by tests/view/proposals_test.cpp.

#include "view/proposals.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

#include "out/program/tools_template.h"
#include "session/cutting/offset_insert.h"
#include "session/insert_proposals.h"
#include "session/tool_proposals.h"
#include "texts/view.h"
#include "view/instant.h"

namespace kadr {
namespace {

// Assumed bodies of tools of which only the cutting part is known, mm: a collet chuck, and how far tools stick out of it at least.
constexpr double least_stick_out = 40, holder_face = 32, holder_body = 40, holder_height = 45;
constexpr double holder_by_tool = 1.2;                   // least diameter of the holder, in diameters of the tool
constexpr double drill_angle = 118, chamfer_angle = 90;  // usual tip angles of drills and chamfer tools, degrees

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

const Use* first_use(const ProgramRun& run, UseKind kind, const std::function<bool(const Use&)>& fits) {
  for (const Use& use : run.control().use().all())
    if (use.kind == kind && fits(use)) return &use;
  return nullptr;
}

/// Sets the diameter from the radius that the set-up states for the tool's offset. Returns false if the set-up states no radius.
bool take_setup(const ProgramRun& run, ProposedTool& to) {
  const Use* const use = first_use(run, UseKind::radius, [&](const Use& u) { return u.tool == to.tool.number && u.number != 0; });
  if (use == nullptr) return false;
  const auto offset = run.opened().setup.offsets.find(int(use->number));
  if (offset == run.opened().setup.offsets.end() || !(offset->second.radius > 0)) return false;
  to.tool.diameter = 2 * offset->second.radius;
  to.from = translated(texts::view::radius_of_offset, use->number);
  return true;
}

/// True for tools that have no kind of their own in a tools file: they are taken as cylinders.
bool is_cylinder(ToolWord kind) { return kind == ToolWord::tap || kind == ToolWord::reamer; }

/// Sets the kind and the dimensions of the tool from a comment. Dimensions that the comment does not state get usual values for this kind
/// of tool. Returns false if the comment does not name the kind.
bool take_comment(const ToolProposal& proposal, ProposedTool& to) {
  ToolGeometry& t = to.tool;
  const std::string_view kind = kind_word(proposal.tool_data);
  const std::string place = translated(texts::view::tool_in_line, proposal.line, proposal.text);
  to.from = to.from.empty() ? place : to.from + "; " + place;
  if (t.diameter == 0) t.diameter = proposal.tool_data.diameter.value_or(0);
  for (int k = 0; k <= int(ToolKind::turning); ++k)
    if (name_of(ToolKind(k)) == kind) t.kind = ToolKind(k);
  t.corner = t.kind == ToolKind::bull ? proposal.tool_data.corner.value_or(0) : 0;
  if (t.kind == ToolKind::drill) t.angle = proposal.tool_data.angle.value_or(drill_angle);
  if (t.kind == ToolKind::chamfer) t.angle = proposal.tool_data.angle.value_or(chamfer_angle);
  if (t.kind == ToolKind::taper) t.angle = proposal.tool_data.angle.value_or(0) / 2;
  if (kind.empty() && is_cylinder(proposal.tool_data.kind)) {
    t.kind = ToolKind::flat;
    to.from += "; " + translated(texts::view::taken_as_cylinder);
    return true;
  }
  return !kind.empty();
}

/// Assumes flutes and stick-out that no comment states, with a holder, and says so.
void assume_body(ProposedTool& to) {
  ToolGeometry& t = to.tool;
  if (!assume_heights(t)) return;
  t.length = std::max(t.length, least_stick_out);
  const double face = std::max(holder_face, holder_by_tool * t.diameter), body = std::max(holder_body, holder_by_tool * t.diameter);
  t.holder = {{face, 0}, {body, holder_height}};
  if (tool_fault_message(t).empty()) to.from += "; " + translated(texts::view::usual_heights, t.flutes, t.length, face);
}

bool is_lathe(const ProgramRun& run) { return run.opened().def->behaviour.lathe != Lathe::none; }

/// Takes the insert from the row of the offset table that the program uses with the tool. Returns false if the row does not tell its form.
bool take_insert(const ProgramRun& run, ProposedTool& to) {
  const Use* const use = first_use(run, UseKind::length, [&](const Use& u) { return u.tool == to.tool.number && u.number != 0; });
  const std::uint32_t number = use != nullptr ? use->number : to.tool.number;
  const auto row = run.opened().setup.offsets.find(int(number));
  if (row == run.opened().setup.offsets.end()) return false;
  const auto insert = insert_of_offset(row->second, to.tool.number);
  if (!insert || !tool_fault_message(*insert).empty()) return false;
  to.tool = *insert;
  to.from = (to.from.empty() ? "" : to.from + "; ") + translated(texts::view::insert_of_offset, number);
  to.known = to.by_offset = true;
  return true;
}

/// Returns a turning tool that the user must complete: of its insert only the usual tip of an outside tool is stated.
ToolGeometry unknown_insert(std::uint32_t number) {
  ToolGeometry tool;
  tool.number = number;
  tool.kind = ToolKind::turning;
  tool.insert.tip_x = tool.insert.tip_z = -1;
  return tool;
}

/// Takes the insert that a comment describes. `only_sized`: only if the comment tells a designation or a width, which tells more than the
/// offset table does.
bool take_insert_comment(const ProgramRun& run, const InsertProposals& inserts, std::uint32_t called_at, bool only_sized,
                         ProposedTool& to) {
  const auto found = inserts.of(to.tool.number, called_at);
  if (!found || (only_sized && !found->insert.has_code && !found->insert.width)) return false;
  const Use* const use = first_use(run, UseKind::length, [&](const Use& u) { return u.tool == to.tool.number && u.number != 0; });
  const auto& offsets = run.opened().setup.offsets;
  const auto row = offsets.find(int(use != nullptr ? use->number : to.tool.number));
  const auto insert = insert_of_comment(found->insert, to.tool.number, row == offsets.end() ? nullptr : &row->second);
  if (!insert || !tool_fault_message(*insert).empty()) return false;
  to.tool = *insert;
  to.from = translated(texts::view::tool_in_line, found->line, found->text) + "; " + translated(texts::view::rest_of_insert);
  to.known = true;
  return true;
}

/// The comments of a program, read for its tools.
struct ToolTexts {
  ToolProposals tools;
  InsertProposals inserts;
};

ProposedTool by_words(const ProgramRun& run, const ToolTexts& comments, std::uint32_t number) {
  ProposedTool made;
  made.tool.number = number;
  (void)take_setup(run, made);
  const Use* const called = first_use(run, UseKind::tool, [&](const Use& u) { return u.number == number; });
  const std::uint32_t called_at = called == nullptr || called->origin.file != 0 ? 0 : called->origin.line;
  const auto comment = comments.tools.of(number, called_at);
  const bool has_kind = comment && take_comment(*comment, made);
  const bool rotates = has_kind && (made.tool.kind == ToolKind::drill || is_cylinder(comment->tool_data.kind));
  if (is_lathe(run) && !rotates) {
    if (take_insert_comment(run, comments.inserts, called_at, true, made)) return made;
    if (take_insert(run, made)) return made;
    if (take_insert_comment(run, comments.inserts, called_at, false, made)) return made;
  }
  if (const auto open = comment ? std::nullopt : comments.tools.unsure(number, called_at))
    made.from += (made.from.empty() ? "" : "; ") + translated(texts::view::tool_not_sure, open->line, open->text);
  if (is_lathe(run) && !rotates) made.tool = unknown_insert(number);
  else if (has_kind) assume_body(made);
  else (void)assume_heights(made.tool);
  made.known = has_kind && (rotates || !is_lathe(run)) && tool_fault_message(made.tool).empty();
  return made;
}

/// Returns true if the file and the offset table together describe the tools of a lathe's program. A file of milling tools with the same
/// numbers does not.
bool describes_lathe(const ProgramRun& run, const ToolLibrary& tools, const std::vector<std::uint32_t>& numbers) {
  bool any = false;
  for (const std::uint32_t number : numbers) {
    const ToolGeometry* const known = tools.find(number);
    ProposedTool by_table;
    by_table.tool.number = number;
    if (known == nullptr ? !take_insert(run, by_table) : known->kind != ToolKind::turning && known->kind != ToolKind::drill) return false;
    any = any || known != nullptr;
  }
  return any;
}

}  // namespace

std::vector<std::uint32_t> tools_cutting(const ProgramRun& run) {
  std::vector<std::uint32_t> numbers;
  for (const Statistics::ToolUse& use : run.statistics().tools())
    if (use.cutting_s > 0) numbers.push_back(use.tool);
  if (numbers.empty() && run.statistics().cutting_mm() > 0) numbers.push_back(std::uint32_t(std::max(run.opened().setup.tool, 0)));
  return numbers;
}

const KnownTools* tools_file_for(const std::vector<KnownTools>& files, const ProgramRun& run) {
  const std::vector<std::uint32_t> numbers = tools_cutting(run);
  const auto describes = [&](const KnownTools& file) {
    if (is_lathe(run)) return describes_lathe(run, file.tools, numbers);
    return std::all_of(numbers.begin(), numbers.end(),
                       [&](std::uint32_t n) { return file.tools.find(n) != nullptr || (n == 0 && file.tools.tools.size() == 1); });
  };
  std::vector<const KnownTools*> all;
  for (const KnownTools& file : files)
    if (describes(file)) all.push_back(&file);
  for (const std::string& name : {stem(run.opened().path), std::string("tools")})
    for (const KnownTools* file : all)
      if (stem(file->file) == name) return file;
  return all.size() == 1 ? all.front() : nullptr;
}

std::vector<ProposedTool> proposed_tools(const ProgramRun& run, const KnownTools* file) {
  const ProgramLines lines = lines_of(run.control());
  const bool inch = comments_in_inches(run.control(), run.statistics().extents().units());
  const ToolTexts comments{ToolProposals(lines, inch, is_lathe(run)), InsertProposals(is_lathe(run) ? lines : ProgramLines(), inch)};
  std::vector<ProposedTool> tools;
  for (const std::uint32_t number : tools_cutting(run)) {
    const ToolGeometry* const known = file == nullptr ? nullptr : file->tools.find(number);
    const bool only = known == nullptr && file != nullptr && number == 0 && file->tools.tools.size() == 1;
    if (known == nullptr && !only) {
      tools.push_back(by_words(run, comments, number));
      continue;
    }
    tools.push_back({only ? file->tools.tools.front() : *known, file->file, true});
    tools.back().tool.number = number;
  }
  return tools;
}

std::function<double(std::uint32_t)> radii_of(const std::vector<ProposedTool>& tools) {
  std::map<std::uint32_t, double> radii;
  for (const ProposedTool& one : tools) {
    double widest = one.tool.diameter;
    for (const ProfilePoint& point : one.tool.profile) widest = std::max(widest, point.diameter);
    radii[one.tool.number] = widest / 2;
  }
  return [radii = std::move(radii)](std::uint32_t tool) {
    const auto found = radii.find(tool);
    return found != radii.end() ? found->second : 0;
  };
}

namespace {

/// True if the blank, turned in any way, is as large as the cut.
bool holds(const BoxComment& blank, const Box& cut) {
  std::array<double, 3> size = blank.size, wanted = {cut.most.x - cut.least.x, cut.most.y - cut.least.y, cut.most.z - cut.least.z};
  std::sort(size.begin(), size.end()), std::sort(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < size.size(); ++i)
    if (size[i] < wanted[i]) return false;
  return true;
}

}  // namespace

BlankHints blank_hints(const ProgramRun& run) {
  const bool inch = comments_in_inches(run.control(), run.statistics().extents().units());
  const ProgramLines lines = lines_of(run.control());
  auto box = stated_box(lines, inch);
  // A program that cuts in both units does not tell that of its comments: millimetres, unless only inches are large enough for what it cuts
  const RunExtents& extents = run.statistics().extents();
  if (box && extents.unit() == LengthUnit::mixed && !holds(box->size, extents.cutting_box()))
    if (auto in_inches = stated_box(lines, true); in_inches && holds(in_inches->size, extents.cutting_box())) box = std::move(in_inches);
  return {{stated_blank(lines, inch), run.opened().setup.chuck_face}, std::move(box)};
}

bool is_turning(const ProgramRun& run) {
  const AxisRoles roles = AxisRoles::of(run.control().axes(), run.control().rotary());
  if (is_lathe(run) || roles.xyz[1] < 0) return true;
  // The plane in force before the end of the program is tested, because the end of the program resets the plane.
  const auto last = Instants(run).at(run.seconds(), {});
  return last && std::any_of(last->after.begin(), last->after.end(), [](const InForce& one) { return one.code == "G18"; });
}

bool turns_part(const ProgramRun& run, const StockGuess& guess) {
  return is_lathe(run) || (is_turning(run) && guess.is_flat(run.path().zero()));
}

}  // namespace kadr
