// Subprograms: calls by name, PROC with parameters, returns, DEF (spec/sinumerik 1, 6, 9). Used by control/sinumerik.

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ascii.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::vector<std::string> folders_near(const std::string& main_file, std::initializer_list<const char*> names) {
  const auto folder_of = [](const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
  };
  std::string folder = folder_of(main_file);
  std::vector<std::string> all{folder};
  constexpr int levels = 3;  // the program's own folder; for MPF.DIR, the folder with SPF.DIR; for a workpiece, the one around WKS.DIR
  for (int level = 0; level < levels; ++level) {
    for (const char* const name : names) all.push_back(folder + name + "/");
    if (folder.empty() || folder == "/") break;
    folder = folder_of(folder.substr(0, folder.size() - 1));
  }
  return all;
}

/// Finds a program: first among the programs of the same file, then as a file in the folder of the main program (spec/sinumerik 1).
std::optional<FoundProgram> Sinumerik::find_program(Interpreter& m, std::string_view written) {
  const std::string name = plain_program_name(written);
  if (name.empty()) return std::nullopt;
  const std::string key = std::to_string(m.program().reader()) + ":" + name;
  if (const auto known = found_.find(key); known != found_.end()) return known->second;
  std::optional<FoundProgram> found;
  for (const std::uint16_t reader : {m.program().reader(), std::uint16_t{0}}) {
    const ProgramIndex& all = index(m, reader);
    if (all.programs().size() < 2) continue;
    for (const ProgramRow& program : all.programs())
      if (!found && program.name == name) found = FoundProgram{reader, program.begin};
  }
  for (const std::string& inside : folders_near(m.program().main_file(), {"SPF.DIR", "CUS.DIR", "CMA.DIR"}))
    for (const std::string& base : {name, lower(name), "_N_" + name + "_SPF"})
      for (const char* ending : {".SPF", ".spf", ".MPF", ".mpf", ""}) {
        if (found || (base.starts_with("_N_") && *ending != '\0')) continue;
        if (const auto reader = m.flow.open_program(inside + base + ending)) found = FoundProgram{*reader, {}};
      }
  found_.emplace(key, found);
  return found;
}

Status Sinumerik::call(Interpreter& m, const FoundProgram& found, const std::string& name, std::vector<Value> arguments,
                       std::vector<std::shared_ptr<Variable>> references, bool has_arguments, std::uint32_t times, Span where) {
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.left = times;
  frame.caller = m.origin;
  KADR_TRY(m.flow.call_at(found.reader, found.begin, frame, where));
  Level made;
  made.name = name;
  made.arguments = std::move(arguments);
  made.references = std::move(references);
  made.has_arguments = has_arguments;
  memory.levels.push_back(std::move(made));
  calculation_.forget_variables();
  return {};
}

/// Keeps the memory of the variables and arguments of a call that has ended. Variables that something else still refers to are left alone.
void Sinumerik::keep_memory(Level& ended) {
  constexpr std::size_t most_spare = 64;
  while (!ended.variables.empty() && spare_variables_.size() < most_spare) {
    auto node = ended.variables.extract(ended.variables.begin());
    if (node.mapped().use_count() == 1) spare_variables_.push_back(std::move(node));
  }
  spare_arguments_ = {std::move(ended.arguments), std::move(ended.references)};
  spare_arguments_.values.clear();
  spare_arguments_.references.clear();
}

CallArguments Sinumerik::empty_arguments() { return std::exchange(spare_arguments_, {}); }

/// Adds a variable without values to a level. It replaces a variable of the same name.
Variable& Sinumerik::new_variable(Level& own, const std::string& name, Type type) {
  if (spare_variables_.empty()) {
    auto& made = own.variables[name] = std::make_shared<Variable>();
    made->type = type;
    return *made;
  }
  auto node = std::move(spare_variables_.back());
  spare_variables_.pop_back();
  node.key() = name;
  Variable& again = *node.mapped();
  again.type = type;
  again.sizes.clear();
  again.values.clear();
  own.variables.erase(name);
  own.variables.insert(std::move(node));
  return again;
}

/// Executes PROC: makes the formal parameters, and assigns the arguments of the call (spec/sinumerik 9.2).
Status Sinumerik::procedure(Interpreter& m, const NamedBlock& block) {
  Level& own = level();
  if (own.executing || own.took_arguments) return fail(alarm(AlarmId::definition_late, m.block->statement.text, "PROC"));
  own.took_arguments = true;
  calculation_.forget_variables();
  if (own.arguments.size() > block.definitions.size())
    return fail(
        alarm(AlarmId::arguments_too_many, m.block->statement.text, std::string_view(block.name), double(block.definitions.size())));
  for (std::size_t i = 0; i < block.definitions.size(); ++i) {
    const NamedDefinition& row = block.definitions[i];
    const Type type = type_named(block.types[i]);
    const bool given = i < own.arguments.size() && !own.arguments[i].omitted;
    if (row.by_reference) {
      const auto reference = given && i < own.references.size() ? own.references[i] : nullptr;
      if (reference == nullptr || reference->type != type || reference->sizes.empty() != row.sizes.empty())
        return fail(alarm(AlarmId::argument_reference, row.where, std::string_view(row.name)));
      own.variables[row.name] = reference;
      continue;
    }
    if (!row.sizes.empty()) {
      const auto whole = given && i < own.references.size() ? own.references[i] : nullptr;
      if (whole == nullptr || whole->type != type) return fail(alarm(AlarmId::argument_type, row.where, std::string_view(row.name)));
      new_variable(own, row.name, type) = *whole;
      continue;
    }
    Value value = initial_value(type);
    if (given || !row.initial.empty()) {
      const auto source = given ? Result<Value>(own.arguments[i]) : evaluate(m, block, row.initial[0]);
      if (!source) return fail(source.error());
      const auto fits = converted(*source, type, row.where);
      if (!fits) return fail(alarm(AlarmId::argument_type, row.where, std::string_view(row.name)));
      value = *fits;
    }
    new_variable(own, row.name, type).values.push_back(std::move(value));
  }
  for (const std::string& attribute : block.attributes)
    if (attribute == "SAVE") {
      own.saved = m.modal;
      own.saved_frame = memory.programmable;
    }
  return {};
}

/// M17, RET, or the end of the program: returns to the caller; the main program ends.
Status Sinumerik::leave(Interpreter& m, Span where) {
  while (!memory.repeated.empty() && memory.repeated.back().depth == m.program().depth() && m.program().depth() > 0) {
    m.flow.frames().pop_back();
    memory.repeated.pop_back();
  }
  if (m.program().depth() == 0 || memory.levels.size() == 1) {
    m.flow.end();
    return {};
  }
  Level ended = std::move(level());
  calculation_.forget_variables();
  const auto left = m.flow.end_subprogram(where);
  if (!left) {
    level() = std::move(ended);
    return fail(left.error());
  }
  if (*left == nullptr) {  // another pass: its local variables are new
    Level again;
    again.name = std::move(ended.name);
    again.arguments = std::move(ended.arguments);
    again.references = std::move(ended.references);
    again.has_arguments = ended.has_arguments;
    level() = std::move(again);
    return {};
  }
  memory.levels.pop_back();
  keep_memory(ended);
  if (!ended.saved) return {};
  const Modal now = m.modal;
  m.modal = *ended.saved;
  m.modal.spindle = now.spindle, m.modal.rpm = now.rpm, m.modal.feed = now.feed, m.modal.feed_known = now.feed_known;
  m.modal.tool = now.tool, m.modal.tool_selected = now.tool_selected, m.modal.offset_number = now.offset_number;
  m.modal.mist = now.mist, m.modal.flood = now.flood;
  m.change_frames();
  return set_programmable(m, ended.saved_frame, where);
}

Status Sinumerik::jump_in_caller(Interpreter& m, const std::string& label, Span where) {
  const Position from = m.program().position();
  const ProgramIndex& all = index(m);
  const LabelRow* target = all.label(label, from, true);
  if (target == nullptr) target = all.label(label, from, false);
  if (target == nullptr) return fail(alarm(AlarmId::label_missing, where, std::string_view(label)));
  m.flow.jump(target->at);
  return {};
}

Result<std::shared_ptr<Variable>> Sinumerik::made_variable(BlockContext& m, const NamedBlock& block, const NamedDefinition& row) {
  const Type type = type_named(block.types[0]);
  constexpr double most_elements = 1'000'000;
  auto made = std::make_shared<Variable>();
  made->type = type;
  double count = 1;
  for (const NamedExpression& size : row.sizes) {
    const auto value = number(m, block, size, row.where);
    if (!value) return fail(value.error());
    const double whole = std::round(*value);
    count *= whole;
    if (!(whole >= 1) || count > most_elements) return fail(alarm(AlarmId::index_range, row.where, std::string_view(row.name), whole));
    made->sizes.push_back(static_cast<std::uint32_t>(whole));
  }
  if (made->sizes.size() > 3) return fail(alarm(AlarmId::index_range, row.where, std::string_view(row.name), double(made->sizes.size())));
  made->values.assign(static_cast<std::size_t>(count), initial_value(type));
  double filled = static_cast<double>(made->values.size());  // DEF REAL A[3]=5 and REP(5) set every element, REP(5,2) two of them
  if (row.repeated) {
    const auto some = number(m, block, row.repeated, row.where);
    if (!some) return fail(some.error());
    filled = std::round(*some);
    if (!(filled >= 0) || filled > double(made->values.size()))
      return fail(alarm(AlarmId::initial_values_too_many, row.where, std::string_view(row.name), filled));
  }
  if (row.initial.size() > made->values.size())
    return fail(alarm(AlarmId::initial_values_too_many, row.where, std::string_view(row.name), double(row.initial.size())));
  for (std::size_t i = 0; i < row.initial.size(); ++i) {
    const auto value = evaluate(m, block, row.initial[i]);
    if (!value) return fail(value.error());
    if (value->omitted) continue;
    const auto fits = converted(*value, type, row.where);
    if (!fits) return fail(fits.error());
    made->values[i] = *fits;
    if (row.initial.size() == 1) std::fill_n(made->values.begin(), static_cast<std::size_t>(filled), *fits);
  }
  return made;
}

/// DEF: makes local variables (spec/sinumerik 6.1).
Status Sinumerik::define(Interpreter& m, const NamedBlock& block) {
  Level& own = level();
  if (block.global) return fail(alarm(AlarmId::not_available, m.block->statement.text, "DEF NCK, DEF CHAN"));
  if (own.acted) return fail(alarm(AlarmId::definition_late, m.block->statement.text, "DEF"));
  calculation_.forget_variables();
  for (const NamedDefinition& row : block.definitions) {
    // A loop or a jump back may execute DEF again; the control forbids a second DEF of the name in the text.
    if (own.variables.contains(row.name) && !own.executing)
      return fail(alarm(AlarmId::name_defined_twice, row.where, std::string_view(row.name)));
    auto made = made_variable(m, block, row);
    if (!made) return fail(made.error());
    own.variables[row.name] = std::move(*made);
  }
  return {};
}

/// Executes a bare name: a call of a program or a cycle (spec/sinumerik 9.1).
Status Sinumerik::call_item(Interpreter& m, const NamedBlock& block, const NamedItem& item, std::uint32_t times, bool modal) {
  std::string name = item.name;
  const bool by_text = name == "CALL" || name == "PCALL" || name == "EXTCALL";
  if (by_text) {
    if (!item.value && item.text.empty()) return fail(alarm(AlarmId::expression_syntax, item.where, std::string_view(item.name)));
    name = item.text;  // PCALL
    if (item.value) {
      const auto value = evaluate(m, block, item.value);
      if (!value) return fail(value.error());
      if (value->type != Type::text) return fail(alarm(AlarmId::operand_type, item.where, std::string_view(item.name)));
      name = value->text;
    }
  }
  auto [arguments, references] = empty_arguments();
  for (const NamedExpression& each : item.arguments) {
    const bool single = each.end == each.begin + 1;
    const NamedStep& step = block.code[each.begin];
    const auto own = single && step.kind == NamedStep::Kind::name && step.operands == 0 ? variable(step.name) : nullptr;
    references.push_back(own);
    if (own != nullptr && !own->sizes.empty()) {  // a whole array
      arguments.push_back(own->values.front());
      continue;
    }
    auto value = evaluate(m, block, each);
    if (!value) return fail(value.error());
    arguments.push_back(std::move(*value));
  }
  const auto found = find_program(m, name);
  if (!found && is_cycle(name)) {
    if (modal) {
      level().modal_call = ModalCall{name, std::move(arguments)};
      return {};
    }
    return run_cycle(m, name, arguments, item.where);
  }
  if (!found) {
    const bool numbered = name.size() > 1 && name[0] == 'L' && is_digit(name[1]);
    if (by_text || numbered || modal) return fail(alarm(AlarmId::program_missing, item.where, std::string_view(name)));
    return fail(alarm(AlarmId::name_unknown, item.where, std::string_view(name)));
  }
  if (modal) {
    level().modal_call = ModalCall{name, std::move(arguments)};
    return {};
  }
  return call(m, *found, name, std::move(arguments), std::move(references), item.has_arguments && !item.arguments.empty(), times,
              item.where);
}

}  // namespace kadr::sinumerik
