// Executes the codes and the bare names of a block: G4, M17, STOPRE, MSG(…), MCALL, calls. Used by control/sinumerik.

#include <cmath>
#include <utility>

#include "base/ascii.h"
#include "control/sinumerik/block_run.h"

namespace kadr::sinumerik {
namespace {

/// Names that change nothing in the path of the tool: they are accepted (spec/sinumerik 4.1, 16).
constexpr std::string_view accepted[] = {
    "STOPRE",    "STARTFIFO",   "STOPFIFO",  "FIFOCTRL", "BNAT",   "ENAT",    "BRISK",   "SOFT",    "DRIVE",     "CUT2D",    "CDOF",
    "CDON",      "CDOF2",       "FFWOF",     "FFWON",    "ORIWKS", "ORIAXES", "COMPOF",  "COMPON",  "COMPCURV",  "COMPCAD",  "COMPSURF",
    "OSOF",      "SPOF",        "PDELAYON",  "PDELAYOF", "FNORM",  "FLIN",    "FCUB",    "CPRECOF", "CPRECON",   "CUTCONOF", "LFOF",
    "TCOABS",    "SPATH",       "UPATH",     "LFTXT",    "CP",     "PAROTOF", "TOROTOF", "RTLION",  "FENDNORM",  "DYNNORM",  "DYNPOS",
    "DYNROUGH",  "DYNSEMIFIN",  "DYNFINISH", "DYNPREC",  "SBLOF",  "SBLON",   "DISPLOF", "DISPLON", "ACTBLOCNO", "NEWCONF",  "WAITP",
    "WAITS",     "ORIC",        "ORID",      "RMI",      "RMB",    "RME",     "RMN",     "ORISOF",  "WALCS0",    "CUTCONOF", "SETPIECE",
    "WORKPIECE", "GROUP_BEGIN", "GROUP_END", "MMC",      "CANCEL", "CLRINT",  "ENABLE",  "DISABLE"};

/// Names of the control that Kadr does not execute.
constexpr std::string_view refused[] = {
    "ASPLINE",  "BSPLINE", "CSPLINE",  "POLY",     "INVCW",   "INVCCW", "REPOSL",   "REPOSQ",   "REPOSH",   "REPOSA",   "REPOSLA",
    "REPOSQA",  "REPOSHA", "ROTS",     "AROTS",    "CROTS",   "KONTT",  "KONTC",    "BTAN",     "BAUTO",    "ETAN",     "EAUTO",
    "CUT2DF",   "CUT3DC",  "CUT3DF",   "CUT3DFS",  "CUT3DFF", "ORIMKS", "FTOCON",   "OSC",      "OSS",      "OSSE",     "OSD",
    "OST",      "SON",     "PON",      "LFON",     "PTP",     "PTPG0",  "ORIEULER", "ORIRPY",   "ORIRPY2",  "ORIVECT",  "ORIVIRT1",
    "PAROT",    "TOWSTD",  "TOFRAME",  "TOROT",    "ORIROTA", "RTLIOF", "WHEN",     "WHENEVER", "FROM",     "EVERY",    "DO",
    "ID",       "IDS",     "INIT",     "START",    "WAITM",   "WAITE",  "SETM",     "ISOCALL",  "TRANSMIT", "TRACYL",   "TRAANG",
    "TRAILON",  "TRAILOF", "LEADON",   "LEADOF",   "EGON",    "EGDEF",  "COUPON",   "COUPDEF",  "PRESETON", "ADDFRAME", "MEAW",
    "WRITE",    "READ",    "DELETE",   "ISFILE",   "RETB",    "GETT",   "POSP",     "FZ",       "FD",       "FDA",      "DISC",
    "LEAD",     "TILT",    "MEAFRAME", "DISRP",    "DITS",    "DITE",   "SUPD",     "CALCDAT",  "REP",      "SET",      "TLIFT",
    "PUNCHACC", "CPON",    "CPDEF",    "AXTOCHAN", "GET",     "GETD",   "RELEASE",  "OVRRAP",   "OVRA",     "FL",       "FGREF"};

}  // namespace

bool is_refused_name(std::string_view name) { return among(refused, name); }

Status BlockRun::code_word(const NamedItem& item, char letter, double code) {
  if (!(code >= 0) || code != std::round(code) || code > 9999)
    return fail(alarm(AlarmId::code_unknown, item.where, block_.text_of(item.where)));
  switch (static_cast<int>(code)) {
    case 4: in_dwell_ = true; return {};
    case 53: own_.words.machine = true; return {};
    case 153: own_.words.machine = own_.words.basic_off = true; return {};
    case 110:
    case 111:
    case 112: pole_ = static_cast<int>(code); return {};
    case 331:
    case 332: tapping_ = true; return {};
    case 33: own_.memory.motion = NamedMotion::thread; return {};
    case 41:
    case 42:
      if (m_.modal.tool == 0 && !block_.has('T')) return fail(alarm(AlarmId::compensation_without_tool, item.where));
      if (own_.memory.holds_tip) return fail(alarm(AlarmId::not_together, item.where, "TRAORI", "G41"));
      own_.set_normal_offset(m_);
      break;
    case 63: chuck_ = true; return {};
    case 147:
    case 247:
    case 347:
    case 148:
    case 248:
    case 348: approach_ = static_cast<int>(code); return {};
    case 140: return {};
    case 340:
    case 341: own_.memory.approach_in_plane = code == 341; return {};
    case 70: feed_unit_ = 1; break;
    case 71: feed_unit_ = 0; break;
    case 700:
    case 710: feed_unit_ = 0; break;
    case 74: reference_ = true; return {};
    case 75: fixed_point_ = true; return {};
    case 58:
    case 59: shift_ = static_cast<int>(code); return {};
    case 25:
    case 26: limits_ = static_cast<int>(code); return {};
    default: break;
  }
  if (code <= 3) own_.memory.motion = NamedMotion::none;
  return add_code(letter, code, item);
}

Status BlockRun::m_word(const NamedItem& item, double code) {
  if (item.extension > 1) return spindle_word(item, code);
  if (!(code >= 0) || code != std::round(code)) return fail(alarm(AlarmId::code_unknown, item.where, block_.text_of(item.where)));
  if (code == 17) {
    own_.words.returns = true;
    return {};
  }
  if (code == 19) {
    orient_ = 0.0;  // INFERRED: $SA_M19_SPOS is 0
    return {};
  }
  return add_code('M', code, item);
}

Result<bool> BlockRun::name(const NamedItem& item, std::size_t& i) {
  const std::string& name = item.name;
  if (name == "MSG") return all_right(message(item));
  if (name == "SETAL") return all_right(own_alarm(item));
  if (name == "MCALL") return modal_call(i);
  if (diameters(name)) return true;
  if (name == "FGROUP") return all_right(feed_group(item));
  if (name == "SETMS") return all_right(master_spindle(item));
  if (name == "RET") {
    if (item.arguments.size() > 1) return fail(alarm(AlarmId::not_available, item.where, "RET( )"));
    if (!item.arguments.empty()) {
      const auto label = own_.evaluate(m_, read_, item.arguments[0]);
      if (!label) return fail(label.error());
      if (!label->omitted) own_.words.return_label = in_capitals(joined_text(*label));
    }
    own_.words.returns = true;
    return true;
  }
  if (name == "SUPA") {
    own_.words.machine = own_.words.basic_off = true;
    return true;
  }
  if (name == "TRAORI" || name == "TRAFOOF") return all_right(own_.transform_orientation(m_, name == "TRAORI", item.where));
  if (name == "WALIMON" || name == "WALIMOF") {
    own_.memory.area_watched = name == "WALIMON";
    return true;
  }
  if (name == "NORM" || name == "KONT") {
    own_.memory.goes_around = name == "KONT";
    return true;
  }
  if (name == "CFC" || name == "CFTCP" || name == "CFIN") {
    own_.memory.arc_feed = name == "CFC" ? ArcFeed::contour : name == "CFTCP" ? ArcFeed::centre : ArcFeed::inside;
    return true;
  }
  if (name == "CIP" || name == "CT") {
    own_.memory.motion = name == "CIP" ? NamedMotion::through_point : NamedMotion::tangent;
    return true;
  }
  if (name == "PROC" || name == "DEF" || name == "EXTERN") return fail(alarm(AlarmId::definition_late, item.where, std::string_view(name)));
  if (Sinumerik::is_frame_statement(name)) return fail(alarm(AlarmId::statement_not_alone, item.where));
  const bool structural = name == "ELSE" || name == "ENDIF" || name == "LOOP" || name == "ENDLOOP" || name == "ENDWHILE" ||
                          name == "ENDFOR" || name == "REPEAT" || name == "REPEATB";
  if (structural) return fail(alarm(AlarmId::statement_not_alone, item.where));
  if (own_.variable(name) == nullptr && !own_.find_program(m_, name)) {
    if (among(accepted, name)) {
      for (const NamedExpression& each : item.arguments)
        if (name != "WORKPIECE" && name != "FGROUP" && name != "MMC" && name != "WAITP")
          if (const auto value = own_.evaluate(m_, read_, each); !value) return fail(value.error());
      return true;
    }
    if (is_refused_name(name)) return fail(alarm(AlarmId::not_available, item.where, std::string_view(name)));
    const bool frame_word = name == "X" || name == "Y" || name == "Z";
    if (frame_word) return fail(alarm(AlarmId::number_missing, item.where, name[0]));
  }
  call_ = item;
  return true;
}

Status BlockRun::message(const NamedItem& item) {
  std::string text;
  if (!item.arguments.empty()) {
    const auto value = own_.evaluate(m_, read_, item.arguments[0]);
    if (!value) return fail(value.error());
    if (!value->omitted) text = joined_text(*value);
  }
  m_.emit(Message{text});
  return {};
}

Status BlockRun::own_alarm(const NamedItem& item) {
  if (item.arguments.empty()) return fail(alarm(AlarmId::expression_syntax, item.where, "SETAL"));
  const auto value = own_.number(m_, read_, item.arguments[0], item.where);
  if (!value) return fail(value.error());
  std::string text;
  if (item.arguments.size() > 1) {
    const auto read = own_.evaluate(m_, read_, item.arguments[1]);
    if (!read) return fail(read.error());
    text = joined_text(*read);
  }
  const double number = std::round(*value);
  if ((number >= 62000 && number < 63000) || number >= 67000) {
    m_.emit(Message{text, static_cast<std::int32_t>(std::min(number, 999999.0))});
    return {};
  }
  return fail(alarm(AlarmId::program_alarm, item.where, std::string_view(std::to_string(static_cast<long>(number))), number,
                    std::string_view(text)));
}

Result<bool> BlockRun::modal_call(std::size_t& i) {
  const NamedItem& item = read_.items[i];
  if (i + 1 == read_.items.size()) {
    own_.level().modal_call.reset();
    return true;
  }
  if (read_.items.size() != i + 2) return fail(alarm(AlarmId::statement_not_alone, item.where));
  NamedItem named = read_.items[++i];
  if (named.kind == NamedItem::Kind::word && named.name == "L" && !named.has_equals) named.name = "L" + named.text;
  else if (named.kind != NamedItem::Kind::name) return fail(alarm(AlarmId::expression_syntax, named.where, block_.text_of(named.where)));
  return all_right(own_.call_item(m_, read_, named, 1, true));
}

}  // namespace kadr::sinumerik
