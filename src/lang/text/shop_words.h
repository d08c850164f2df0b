#pragma once
// The words, English and Russian, by which comments name blanks, their sizes, and turning tools. Only lang/text uses this file.

#include <string_view>

namespace kadr {

// ---- the blank of a turned part (lang/text/stock_comment)
inline constexpr std::string_view stock_bar_words = "BAR BARSTOCK ROUND TUBE TUBING PIPE ПРУТОК КРУГ ТРУБА";
inline constexpr std::string_view stock_blank_words = "STOCK BLANK BILLET MATERIAL MATL RAW ROHTEIL ЗАГОТОВКА ЗАГОТОВКИ ЗАГ";
inline constexpr std::string_view stock_diameter_words = "D DIA DIAM DIAMETER OD Ф ДИАМЕТР";
inline constexpr std::string_view stock_bore_words = "ID BORE ОТВЕРСТИЕ";
inline constexpr std::string_view stock_length_words = "L LG LEN LENGTH LONG ДЛИНА ДЛИНОЙ";

// ---- the blank of a milled part (lang/text/box_comment)
inline constexpr std::string_view box_words =
    "STOCK BLANK BILLET MATERIAL MATL RAW ROHTEIL ROHMASS WERKSTUECK WERKSTÜCK WORKPIECE WORKPICE WORK PLATE BLOCK SHEET SLAB FLAT PIECE "
    "BRUTO "
    "ЗАГОТОВКА ЗАГОТОВКИ ЗАГОТ ЗАГ ПЛИТА ПЛИТЫ ПЛАСТИНА ЛИСТ БРУС БРУСОК БЛОК ПОЛОСА МАТЕРИАЛ";
// Sizes with these words in their clause are those of a part of the workpiece, of a fixture or of a tool.
inline constexpr std::string_view not_of_box =
    "POCKET SLOT HOLE HOLES BOSS CLAMP CLAMPS VISE VICE JAW JAWS FIXTURE PARALLELS INSERT TOOL CUTTER DRILL TAP ENDMILL MILL LEAVE "
    "FINISHED "
    "КАРМАН ПАЗ ОТВЕРСТИЕ ПРИХВАТ ПРИХВАТЫ ТИСКИ ГУБКИ ФРЕЗА СВЕРЛО РЕЗЕЦ МЕТЧИК ДЕТАЛЬ";
inline constexpr std::string_view box_between_words = "X Х BY НА";
inline constexpr std::string_view box_x_words = "X L LG LEN LENGTH LONG Х Д ДЛИНА ДЛИНОЙ";
inline constexpr std::string_view box_y_words = "Y W WIDTH WIDE B BREADTH У Ш ШИРИНА ШИРИНОЙ";
inline constexpr std::string_view box_z_words = "Z H HEIGHT HIGH T THK THICK THICKNESS DEPTH З В ВЫСОТА ВЫСОТОЙ ТОЛЩИНА ТОЛЩИНОЙ";

// ---- turning tools (lang/text/insert_comment)
inline constexpr std::string_view insert_turning_words =
    "TURN TURNING ROUGH ROUGHING FINISH FINISHING FACE FACING OD OUTSIDE PROFILE "
    "РЕЗЕЦ ПРОХОДНОЙ ПРОХ ПОДРЕЗНОЙ КОНТУРНЫЙ УПОРНЫЙ ТОЧЕНИЕ";
inline constexpr std::string_view insert_boring_words = "BORING BORE BB РАСТОЧНОЙ РАСТ РАСТОЧКА";
inline constexpr std::string_view insert_inside_words = "ID INSIDE INTERNAL BORING BORE BB РАСТОЧНОЙ РАСТ РАСТОЧКА ВНУТРЕННИЙ ВНУТР";
inline constexpr std::string_view insert_grooving_words =
    "GROOVE GROOVES GROOVER GROOVING PARTING PARTOFF CUTOFF КАНАВОЧНЫЙ КАНАВКА КАНАВОЧН ОТРЕЗНОЙ ОТРЕЗКА";
inline constexpr std::string_view insert_threading_words = "THREAD THREADS THREADING РЕЗЬБОВОЙ РЕЗЬБА РЕЗЬБЫ";
inline constexpr std::string_view insert_tool_words = "TOOL HOLDER INSERT BLADE BAR TOOLHOLDER РЕЗЕЦ ПЛАСТИНА";
// Comments with these words are about tools that rotate, or about no tool.
inline constexpr std::string_view not_of_turning =
    "DRILL DRILLING MILL ENDMILL TAP TAPPING REAMER REAM CENTER CENTRE SPOT STOCK MATERIAL MATL BARSTOCK TUBING JAW JAWS PULLER PULL STOP "
    "СВЕРЛО ФРЕЗА МЕТЧИК РАЗВЕРТКА ЗЕНКЕР ЗЕНКОВКА ЦЕНТРОВКА ЗАГОТОВКА ПРУТОК";
// Words after a number (.125 WIDE, .032 NR), and words before one (W=3, R0.4).
inline constexpr std::string_view insert_width_after = "WIDE WD W ШИРИНА", insert_width_before = "WIDTH W B ШИРИНА ШИР Ш";
inline constexpr std::string_view insert_nose_after = "NR TNR RAD RADIUS", insert_nose_before = "CR R RAD RADIUS NOSE Р";

inline constexpr std::string_view insert_face_words = "FACE ТОРЦЕВОЙ ТОРЦЕВАЯ", insert_id_words = "ID ВНУТРЕННИЙ ВНУТР";
inline constexpr std::string_view number_of_tool_words = "T TOOL ИНСТРУМЕНТ";
inline constexpr std::string_view shop_mm = "MM ММ";

}  // namespace kadr
