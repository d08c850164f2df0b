// The vocabulary of comments about tools. Used by lang/text/tool_figures, lang/text/tool_comment.

#include "lang/text/tool_words.h"

#include <algorithm>
#include <unordered_map>

namespace kadr {
namespace {

using enum WordHints;

struct Row {
  std::string_view words;  // separated by blanks
  WordHints means;
  ToolWord kind = ToolWord::none;
};

constexpr WordHints names_tool = tool | size_after;
// A word of another language. Its meaning is so uncertain that only a number with a unit counts as the size.
constexpr WordHints foreign = tool | size_after | no_bare_size;
constexpr WordHints either = other_before | other_after;

/// The words are English, Russian, and Russian in Latin letters; of other languages only the commonest names are listed. Each word occurs
/// once.
constexpr Row rows[] = {
    // ---- names of tools
    {"ENDMILL ENDMILLS EM E.M FEM CUTTER SLOTDRILL ФРЕЗА ФРЕЗЫ ФРЕЗОЙ ФР FREZA", names_tool, ToolWord::mill},
    {"FACEMILL SHELLMILL", names_tool | wide, ToolWord::mill},
    {"SLOTMILL", names_tool | disc, ToolWord::mill},
    {"BULL BULLNOSE", names_tool | part_of_name, ToolWord::mill},
    {"MILL", tool | work_too, ToolWord::mill},
    {"THREADMILL РЕЗЬБОФРЕЗА", tool | threads, ToolWord::mill},
    {"BALLNOSE BALLMILL", names_tool, ToolWord::ball},
    {"BALL", names_tool | part_of_name, ToolWord::ball},
    {"DRILL", tool | work_too, ToolWord::drill},
    {"SPOTDRILL", tool | work_too, ToolWord::drill},
    {"СВЕРЛО СВЁРЛА СВЕРЛА СВЕРЛОМ СВ SVERLO", names_tool, ToolWord::drill},
    {"ЦЕНТРОВКА CENTERDRILL CENTREDRILL CENTROVKA", tool | centre, ToolWord::drill},
    {"CHAMFER CHAMF COUNTERSINK CSINK C'SINK CSK VBIT ЗЕНКОВКА ZENKOVKA", tool, ToolWord::chamfer},
    {"TAP TAPRH TAPLH МЕТЧИК МЕТЧ METCHIK", tool, ToolWord::tap},
    {"REAMER REAM РАЗВЕРТКА РАЗВЁРТКА РАЗВ RAZVERTKA RAZVYORTKA", names_tool, ToolWord::reamer},
    {"ЗЕНКЕР ZENKER", names_tool},
    {"ЦЕКОВКА COUNTERBORE", tool},
    {"BIT ENGRAVER ENGRAVING", tool | no_bare_size},
    {"SAW", tool | no_bare_size | wide},
    {"FRAESER FRÄSER FRESA FRAISE", foreign},
    {"SCHAFTFRAESER SCHAFTFRÄSER MESSERKOPF", foreign, ToolWord::mill},
    {"BOHRER ANBOHRER BROCA FORET", foreign, ToolWord::drill},
    {"GEWINDEBOHRER MACHO MACHUELO", foreign, ToolWord::tap},
    {"REIBAHLE ALESATORE", foreign, ToolWord::reamer},
    // ---- words that are part of a tool's name
    {"END NOSE SPOT SPOTTING FLAT SQUARE FORM ROUTER DOVETAIL SLITTING V", part_of_name},
    {"FACE SHELL", part_of_name | wide},
    {"SLOT KEY KEYSEAT KEYWAY WOODRUFF TSLOT", part_of_name | disc},
    {"MILLING", part_of_name, ToolWord::mill},
    {"SPHER ШАРОВАЯ СФЕРИЧЕСКАЯ СФЕР СФЕРА ШАР SHAROVAYA SFERA", part_of_name, ToolWord::ball},
    {"TAPERED КОНИЧЕСКАЯ", part_of_name, ToolWord::taper},
    {"CHAMFERING ФАСОЧНАЯ", part_of_name, ToolWord::chamfer},
    {"CENTER CENTRE CENTERING CENTRING ЦЕНТРОВОЧНОЕ CENTRAR", part_of_name | centre},
    {"THREAD THREADING TM РЕЗЬБОВАЯ", part_of_name | threads},
    {"CORNER C.R", part_of_name | rounds},
    {"ROUND ROUNDING ROUNDER", part_of_name},
    {"BORING", part_of_name},
    {"BAR", part_of_name | tool | only_called},
    // ---- material and shape of tools
    {"CARBIDE CRB HSS HSSCO COBALT CO STUB STUBBY JOBBER LONG SHORT EXTENDED REGULAR SQ ALU ALUMINUM INSERT INDEXABLE SOLID STEEL",
     describes},
    {"COATED TIN ALTIN TIALN TIALCN DLC UNCOATED ROUGH ROUGHING ROUGHER FINISH FINISHING FINISHER SHARP UPCUT DOWNCUT", describes},
    {"SPIRAL STRAIGHT HAND RIGHT LEFT RH LH CUT ROLL BOTTOM BOTTOMING PLUG STI UNC UNF UNEF UNS COATING HELICAL VARIABLE TH", describes},
    {"КОНЦЕВАЯ КОНЦ ТОРЦЕВАЯ ТОРЦ ТОРЦОВАЯ ЧЕРНОВАЯ ЧИСТОВАЯ ДИСКОВАЯ ПАЗОВАЯ ШПОНОЧНАЯ РАДИУСНАЯ ТВЕРДОСПЛАВНАЯ ТВС ВК КОРОТКОЕ ДЛИННОЕ",
     describes},
    {"TORCEVAYA KONCEVAYA", describes},
    // ---- units, and words that give the meaning of a number
    {"MM ММ", unit_mm},
    {"INCH INCHES IN ДЮЙМ ДЮЙМА ДЮЙМОВ \"", unit_inch},
    {"D Д DIA DIAM DIAMETER DIAMETR DIAMETRO DIÁMETRO SIZE Ф ДИАМ ДИАМЕТР ДИАМЕТРОМ", means_diameter},
    {"R CR RAD RADIUS РАДИУС РАД", means_corner},
    {"DEG DEGR DEGREE DEGREES GRAD ГРАД ГРАДУСОВ *", degrees},
    {"NO NUM NUMBER #", number},
    {"LETTER LTR LTTR LET", letter},
    {"T Т TOOL ИНСТРУМЕНТ ИНСТР ИНСТРУМЕНТА", tool_number},
    {"X Х", times},
    // ---- words next to numbers that are not sizes
    {"FLUTE FLUTES FLT FLTS FL ПЕРА ПЕРО ПЕРЬЕВ", either | of_tool | describes},
    {"TOOTH TEETH INSERTS ЗУБА ЗУБЬЕВ ЗУБ", either | describes},
    {"LOC CUTLENGTH", either | of_tool},
    {"CUTTING", of_tool | describes},
    {"OAL REACH SHANK SHK STICKOUT PROJECTION PILOT OFF OFFSETS INSERTED PITCH EXTENSION TIP TP ХВОСТОВИК ВЫЛЕТ ГЛУБИНА DEPTH GLUBINA",
     either},
    {"LENGTH LEN ДЛИНА DLINA SPEED FEED FEEDRATE ZMIN ZMAX OVERHANG", other_after},
    {"THRU THROUGH LEAVE HEIGHT TOLERANCE TOL", other_after},
    {"REV REVISION VERSION ITEM PRODUCT OP OPERATION OPER ОП ОПЕРАЦИЯ JOB SEQ SEQUENCE", is_numbered},
    {"STEP PASS SIDE SETUP STATION POS POSITION POCKET DRAWER PAGE SHEET LINE LEVEL CAVITY PALLET VISE ПРОХОД ПЕРЕХОД УСТАНОВ",
     is_numbered},
    {"PART PN DWG SERIAL SN JIG FIXTURE PROGRAM PROG FILE DATE TIME ДЕТАЛЬ ДАТА", is_numbered},
    {"RPM SFM IPM IPR IPT FPT MPM MIN SEC % ОБ", other_before},
    {"DEEP WIDE HIGH TALL BELOW ABOVE APART PLACES PLCS PL FACES SPARES PARTS PECKS POINT FIT ГЛУБ", other_before},
    // ---- what the comment is about
    {"FOR WITH W ПОД POD С ДЛЯ", another},
    {"OF TO BY FROM AT ON IS THEN THAN MUST AFTER BEFORE NOT USE CNC VMC HMC CHECK REPLACE НА ИЗ ДО ПО ОТ", ends_phrase},
    {"AND OR & + И ИЛИ", ends_phrase | joins},
    {"HOLE HOLES BOLT BOLTS SCREW SCREWS BOSS BOSSES STOCK BLOCK PLATE BORE BORES VALVE BODY ROD SHAFT PIN FLOOR GROOVE CIRCLE",
     of_part | no_diameter},
    {"ЗАГОТОВКА ОТВЕРСТИЕ ОТВЕРСТИЯ ОТВЕРСТИЙ ОТВ ПАЗ ПРУТОК OTV OTVERSTIE ZAGOTOVKA", of_part | no_diameter},
    {"TURN TURNING OD FACING GROOVING CUTOFF PARTING THREADS BORED MATERIAL WORKPIECE", of_part},
    {"MINOR MAJOR HOLDER COLLET FINAL STARTING NECK ARBOR CHUCK", no_diameter | ends_phrase},
    {"OVERSIZE OVERSIZED UNDERSIZE UNDERSIZED OVERSIZ REGROUND REGRIND RESHARPENED", not_nominal},
    {"OFFSET COMPENSATION COMP CORRECTOR КОРРЕКТОР", offset | other_before},
    {"NPT NPTF BSP BSPP BSPT PIPE G RC TRUBNAYA ТРУБНАЯ", pipe},
};

std::unordered_map<std::string_view, ToolWordMeaning> meanings() {
  std::unordered_map<std::string_view, ToolWordMeaning> made;
  for (const Row& row : rows)
    for (std::size_t from = 0; from < row.words.size();) {
      const std::size_t to = std::min(row.words.find(' ', from), row.words.size());
      made[row.words.substr(from, to - from)] = {row.means, row.kind};
      from = to + 1;
    }
  return made;
}

}  // namespace

ToolWordMeaning meaning_of(std::string_view word) {
  static const std::unordered_map<std::string_view, ToolWordMeaning> all = meanings();
  const auto found = all.find(word);
  return found == all.end() ? ToolWordMeaning{} : found->second;
}

}  // namespace kadr
