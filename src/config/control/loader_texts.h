#pragma once
// All messages of the loader of control files in both languages: one table, English next to Russian. The English text identifies a
// sentence; a text without a row does not compile.

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "config/language.h"

namespace kadr::loader_texts {

struct Row {
  std::string_view en, ru;
};

// Each {} stands for a key, code or value of the file, in the same order in both languages.
inline constexpr Row rows[] = {
    // ---- values
    {"{}: id is missing", "{}: нет id"},
    {"{}: id is missing: a file that extends another is a control of its own",
     "{}: нет id: файл, дополняющий другой, описывает самостоятельную систему"},
    {"{}: extends itself", "{}: extends указывает на сам этот файл"},
    {"no control '{}'; there are: {}, or a file of your own (NAME.toml)", "УЧПУ «{}» нет; есть: {} или свой файл (ИМЯ.toml)"},
    {"{} must be a whole number from {} to {}", "{}: должно быть целое число от {} до {}"},
    {"{} must be a number from 0 to 1000000", "{}: должно быть число от 0 до 1000000"},
    {"{} must be more than 0", "{}: должно быть больше 0"},
    {"{} must be a table", "{}: должна быть таблица"},
    {"{} must be a list", "{}: должен быть список"},
    {"{} must be a text", "{}: должна быть строка в кавычках"},
    {"{} must be a letter A to Z", "{}: должна быть одна буква от A до Z"},
    {"{} must be true or false", "{}: должно быть true или false"},
    {"unknown key '{}'", "неизвестный ключ «{}»"},
    {"unknown behaviour '{}'", "неизвестный ключ раздела [behaviour]: «{}»"},
    {", nearest: '{}'", "; ближайший: «{}»"},
    {"{} has no effect {}", "{} не действует {}"},
    // ---- [grammar]
    {"{}: format: {}", "{}: format: {}"},
    {"format \"{}\" is not understood: {}", "формат «{}» непонятен: {}"},
    {"nothing may follow the end of block", "после конца кадра ничего быть не может"},
    {"a count is 1 to 9", "число слов — от 1 до 9"},
    {"an address is a letter A to Z", "адрес — буква от A до Z"},
    {"the address stands twice", "адрес записан дважды"},
    {"a block number has no fraction", "у номера кадра дробной части нет"},
    {"a sign is written + or ±", "знак обозначается + или ±"},
    {"one or two digits say how many stand before and after the point", "одна или две цифры: сколько знаков до запятой и сколько после"},
    {"only digits may follow", "дальше могут стоять только цифры"},
    {"at least one digit stands before the point", "до запятой должен быть хотя бы один знак"},
    {"long_parameters: letters A to Z and the signs # @ $ &, at most eight",
     "long_parameters: буквы от A до Z и знаки # @ $ &, всего не более восьми"},
    {"end_of_block: line or line_only", "end_of_block: line или line_only"},
    {"parameters_in: letters A to Z", "parameters_in: буквы от A до Z"},
    {"most_codes must be a table: { M = 2 }", "most_codes: должна быть таблица, например { M = 2 }"},
    {"most_codes: letters A to Z", "most_codes: буквы от A до Z"},
    {"{}: [address] {} must be '{}'", "{}: у [address] {} должно быть '{}'"},
    {"unknown operation '{}'", "неизвестное действие «{}»"},
    {"'{}': letters A to Z, or of {}", "«{}»: буквы от A до Z или знаки {}"},
    {"operand: bracket, value or pair", "operand: bracket, value или pair"},
    {"{} stands twice", "{} записано дважды"},
    {"{}: more than {} rows", "{}: больше {} строк"},
    {"without [grammar] expressions = true", "без expressions = true в разделе [grammar]"},
    {"expressions and formal_parameter do not work together", "expressions и formal_parameter вместе не действуют"},
    {"percent_ignored: a program could not begin with the % that program_start_required asks for",
     "percent_ignored: УП не могла бы начаться с %, которого требует program_start_required"},
    {"label and section do not work together", "label и section вместе не действуют"},
    {"without percent_number", "без percent_number"},
    {"beside percent_ignored", "при percent_ignored"},
    {"with end_of_block = \"line_only\"", "при end_of_block = \"line_only\""},
    {"without formal_parameter", "без formal_parameter"},
    {"without expressions", "без expressions"},
    {"without a code that does 'zero_shift'", "без кода с функцией 'zero_shift'"},
    {"most_codes has no effect: no address {}", "most_codes не действует: адреса {} нет"},
    // ---- [behaviour]
    {"[behaviour] has no key {} any more; instead: {}", "в разделе [behaviour] ключа {} больше нет; вместо него: {}"},
    {"{} must be one of {}", "{}: одно из слов {}"},
    {"arc_radius_difference: a number, or two of them: while the unit is mm, and inch",
     "arc_radius_difference: число или два: в миллиметрах и в дюймах"},
    {"dialect = \"correctors\": [address] L must be 'corrector_word'",
     "dialect = \"correctors\": у [address] L должно быть 'corrector_word'"},
    {"{} has no effect without a row that does '{}'", "{} не действует: нет строки с функцией '{}'"},
    {"delayed_assignment has no effect without [grammar] expressions", "delayed_assignment не действует без [grammar] expressions"},
    // ---- the machine of the NCT
    {"[grammar] {} needs the machine of the NCT: extends = \"nct\" (dialect = \"nct\")",
     "[grammar] {}: нужен станок УЧПУ NCT: extends = \"nct\" (dialect = \"nct\")"},
    {"dialect = \"nct\" needs [grammar] macro and expressions", "dialect = \"nct\": нужны [grammar] macro и expressions"},
    {"dialect = \"nct\" needs `parameters` = \"nct-parameters\"", "dialect = \"nct\": нужна строка parameters = \"nct-parameters\""},
    {"dialect = \"nct\" needs [grammar] variables of 100000 and more", "dialect = \"nct\": [grammar] variables — от 100000"},
    {"dialect = \"nct\" needs [grammar] label = \"O\"", "dialect = \"nct\": нужно [grammar] label = \"O\""},
    {"{} does not work with the machine of the NCT (dialect = \"nct\")", "{} не действует со станком УЧПУ NCT (dialect = \"nct\")"},
    {"{} has no effect with the machine of the NCT (dialect = \"nct\")", "{} не влияет на станок УЧПУ NCT (dialect = \"nct\")"},
    {"encoding: ascii, utf-8, cp1251, koi8-r, cp866, iso7 or eia", "encoding: ascii, utf-8, cp1251, koi8-r, cp866, iso7 или eia"},
    {"[convert] {}: no code of this control that does 'machine_function'", "[convert] {}: у системы нет такого кода с 'machine_function'"},
    {"[convert] M{}: an M code of the other control, such as \"M8\"", "[convert] M{}: нужен код M другой системы, например \"M8\""},
    {"[convert] M{}: '{}' is this control itself", "[convert] M{}: «{}» — сама эта система"},
    {"[convert] M{} and M{} are both M{} of '{}': the way back is not known",
     "[convert] M{} и M{} — обе M{} системы «{}»: обратный перевод неоднозначен"},
    {"[feed_codes] and [speed_codes] do not work with the machine of the NCT (dialect = \"nct\")",
     "[feed_codes] и [speed_codes] не действуют со станком УЧПУ NCT (dialect = \"nct\")"},
    {"unknown dialect '{}'", "диалекта «{}» нет"},
    {"needs the machine of the NCT: extends = \"nct\" (dialect = \"nct\")", "нужен станок УЧПУ NCT: extends = \"nct\" (dialect = \"nct\")"},
    // ---- [axes], [order]
    {"{}: [axes] names: 1 to 16 axes", "{}: [axes] names: от 1 до 16 осей"},
    {"names: each axis a name of its own", "names: у каждой оси своё имя"},
    {"rotary: no such axis", "rotary: такой оси нет"},
    {"diameter: no such axis", "diameter: такой оси нет"},
    {"names: axis {} has no word in [address]", "names: для оси {} нет слова в [address]"},
    {"{}: '{}' needs three axes", "{}: '{}' требует трёх осей"},
    {"dialect = \"correctors\" and [grammar] section need three axes", "dialect = \"correctors\" и [grammar] section требуют трёх осей"},
    {"[behaviour] arc_centers = \"as_distance\" needs a 'center' for each of the first three axes",
     "[behaviour] arc_centers = \"as_distance\": для каждой из первых трёх осей нужен 'center'"},
    {"{}: [order] phases is missing", "{}: нет [order] phases"},
    {"unknown phase '{}'", "неизвестная фаза «{}»"},
    {"phase twice", "фаза названа дважды"},
    {"phase '{}' is not in [order]", "фазы «{}» нет в [order]"},
    // ---- [address]
    {"{}: [address] is missing", "{}: нет раздела [address]"},
    {"an address is a letter A to Z, or ,C ,R ,A, with a table", "адрес — буква от A до Z или ,C ,R ,A, и при нём таблица"},
    {"no axis '{}'", "оси «{}» нет"},
    {"unit: length or angle", "unit: length или angle"},
    {"`does` is missing", "нет ключа `does`"},
    {"unknown function '{}'", "неизвестная функция «{}»"},
    {"{} belongs to a code, [g] or [m]", "{} — для кода, [g] или [m]"},
    {"{} belongs to a word, [address]", "{} — для слова, [address]"},
    {"{} needs {}", "{}: нужно {}"},
    {"the machine of the NCT: extends = \"nct\" (dialect = \"nct\")", "описание станка УЧПУ NCT: extends = \"nct\" (dialect = \"nct\")"},
    {"{} is a word {}", "{} — слово с адресом {}"},
    {"[grammar] label is another letter", "в [grammar] label другая буква"},
    {"'formal_parameter' needs [grammar] formal_parameter = \"{}\"", "'formal_parameter': нужно [grammar] formal_parameter = \"{}\""},
    {"{} needs `axis`", "{}: нужен ключ `axis`"},
    {"`axis` has no effect: {} has none", "`axis` не действует: у {} оси нет"},
    {"axis {} has the word {} already", "у оси {} уже есть слово {}"},
    {"`phase` has no effect: {} does nothing by itself", "`phase` не действует: {} само ничего не выполняет"},
    {"`scale` has no effect: {} is no value", "`scale` не действует: {} — не величина"},
    {"`second` needs does = \"corrector_word\": nothing else takes a second number",
     "`second`: нужно does = \"corrector_word\", второе число бывает только там"},
    {"`{}` has no effect: {} is not limited on this control", "`{}` не действует: {} в этой системе не ограничивается"},
    {"scale must be a number, not 0", "scale: должно быть число, не 0"},
    {"least must not be more than most", "least не может быть больше most"},
    // ---- [groups], [g], [m]
    {"a group is a table", "группа описывается таблицей"},
    {"at most {} groups", "групп не более {}"},
    {"{}: letters A to Z, or c, r, a for ,C ,R ,A", "{}: буквы от A до Z или c, r, a вместо ,C ,R ,A"},
    {"a code is a table", "код описывается таблицей"},
    {"'{}' is no code number", "«{}» — не номер кода"},
    {"{} belongs to [m] \"other\"", "{} — ключ для [m] \"other\""},
    {"no group '{}'", "группы «{}» нет"},
    {"with: codes of its group, such as \"{}8\"", "with: коды той же группы, например \"{}8\""},
    {"takes: no address {}", "takes: адреса {} нет"},
    {"needs: no address {}", "needs: адреса {} нет"},
    {"needs {}, which it does not take", "needs: адреса {} нет среди takes"},
    {"at most {} codes", "кодов не более {}"},
    {"no [cycle.{}]", "нет раздела [cycle.{}]"},
    {"{}: [cycle.{}] needs steps, not a body", "{}: в [cycle.{}] должны быть steps, а не body"},
    {"{}: [cycle.{}] needs a body, not steps", "{}: в [cycle.{}] должно быть body, а не steps"},
    {"{} has a row already (the same code with other digits)", "строка для {} уже есть (тот же код, записанный иначе)"},
    {"only M codes may have 'other'", "'other' бывает только у кодов M"},
    {"from must not be more than to", "from не может быть больше to"},
    {"other: only 'machine_function'", "other: только 'machine_function'"},
    {"`arg` has no effect: {} has none", "`arg` не действует: у {} его нет"},
    {"`takes` has no effect: {} uses no words", "`takes` не действует: {} слов не использует"},
    {"arg of {} must be {}", "arg функции {}: должно быть {}"},
    {"{} to {}", "от {} до {}"},
    {"'drilling' is G73 to G89, or an `arg` says which of them: 730, 740, 760",
     "'drilling' — это G73…G89, иначе `arg` указывает, который из них: 730, 740, 760"},
    {"arg is beyond [behaviour] fixtures", "arg больше, чем [behaviour] fixtures"},
    {"{} with a mode of its own is for G codes", "{} со своим режимом — для кодов G"},
    {"'machine_function' is for M codes", "'machine_function' — для кодов M"},
    {"'dwell' must take the word of its time", "'dwell': в takes должно быть слово времени выдержки"},
    {"{}: [groups] \"{}\": initial code {} is not of this group", "{}: [groups] \"{}\": исходный код {} не из этой группы"},
    {"unknown code", "неизвестный код"},
    {"end: {} is no mode: '{}'", "end: {} — не режим: '{}'"},
    {"unknown alarm '{}'", "неизвестная ошибка «{}»"},
    {"{}: '{}' needs [[variables]] is = \"{}\"", "{}: для '{}' нужно [[variables]] is = \"{}\""},
    {"{}: [{}] has no effect without an address that does '{}'", "{}: [{}] не действует без адреса с функцией '{}'"},
    // ---- [cycle]
    {"a cycle is a table", "цикл описывается таблицей"},
    {"a cycle is named by its code, G81, or its call, L81", "цикл именуется по коду, G81, или по вызову, L81"},
    {"unknown step", "неизвестный шаг цикла"},
    {"body: each block a text", "body: каждый кадр — строка в кавычках"},
    {"a cycle has steps or a body", "у цикла — либо steps, либо body"},
    {"parameters: a letter and the formal parameter that it sets, as in { X = \"R01\" }",
     "parameters: буква и формальный параметр, который она задаёт, как в { X = \"R01\" }"},
    {"cycle {}: ", "цикл {}: "},
    {"passes_by_parameter is for cycles that are called: L83", "passes_by_parameter — для вызываемых циклов: L83"},
    {"a number from 1 must follow L", "за L должен идти номер, от 1"},
    {"a cycle that is called needs [grammar] section", "вызываемому циклу нужно [grammar] section"},
    {"its words are [grammar] formal_parameter", "его слова — [grammar] formal_parameter"},
    {"steps of a cycle that is called: passes_by_parameter alone, else a body",
     "steps вызываемого цикла: только passes_by_parameter, иначе — body"},
    {"{} has no effect on a cycle that is called", "{} на вызываемый цикл не действует"},
    {"a body is for cycles that are called, L81, or where there are [grammar] long_parameters",
     "body — для вызываемых циклов, L81, или там, где есть [grammar] long_parameters"},
    {"needs_override_off has no effect on a cycle that is not called", "needs_override_off действует только на вызываемый цикл"},
    {"needs must have Z and R", "в needs должны быть Z и R"},
    {"peck_full and peck_break need Q: the cycle would never end", "peck_full и peck_break требуют Q: иначе цикл не кончится"},
    // ---- [[variables]]
    {"a variable is a table", "переменная описывается таблицей"},
    {"unknown kind '{}'", "неизвестный вид «{}»"},
    {"ranges: a list of ranges", "ranges: список диапазонов"},
    {"a variable has `from` or `ranges`", "у переменной — либо `from`, либо `ranges`"},
    {"a symbol is of A to Z, 0 to 9, _", "имя — из букв A…Z, цифр и _"},
    {"access: R, W or RW", "access: R, W или RW"},
    {"a range is [from, count] or [from, count, stride, repeat]", "диапазон — [from, count] или [from, count, stride, repeat]"},
    {"`{}` has no effect without the machine of the NCT", "`{}` не действует без станка УЧПУ NCT"},
    {"count must be {}", "count: должно быть {}"},
    {"stride must be at least {}", "stride: не меньше {}"},
    {"repeat must be at least [behaviour] fixtures", "repeat: не меньше, чем [behaviour] fixtures"},
    {"{} has no effect: there is one", "{} не действует: она одна"},
    {"from must be 1000 or more", "from: должно быть не меньше 1000"},
    {"#{} is beyond [grammar] variables", "#{} больше, чем [grammar] variables"},
    // ---- [guess], aliases, extends
    {"[{}] {} has no effect: the control that is extended says the same", "[{}] {} не действует: в расширяемой системе то же самое"},
    {"[guess] {}: a weight is a number other than 0, {} at most", "[guess] {}: вес — число, не 0, по модулю не больше {}"},
    {"aliases have no effect in a file of your own: it is named by its path",
     "aliases в собственном файле не действует: его называют по пути"},
    {"aliases: a list of texts", "aliases: список строк"},
    {"aliases: '{}' is not a name: small letters, digits, - and .", "aliases: «{}» — не имя: строчные латинские буквы, цифры, - и ."},
    {"aliases: '{}' stands twice", "aliases: «{}» указано дважды"},
    {"aliases: '{}' is the name of another control: {}", "aliases: «{}» — имя другой системы: {}"},
    // ---- parameters, alarms
    {"a parameter is a table", "параметр описывается таблицей"},
    {"no table of parameters '{}'", "таблицы параметров «{}» нет"},
    {"no alarm '{}'", "ошибки «{}» нет"},
};

/// A row of the table, found at compile time.
struct Sentence {
  consteval Sentence(const char* en) {  // NOLINT(google-explicit-constructor): a sentence is written where it is said
    while (row < std::size(rows) && rows[row].en != en) ++row;
    if (row == std::size(rows)) throw "no such row";
  }
  std::size_t row = 0;
};

/// Returns the sentence in the current language, with its {} filled in.
template <class... Args>
std::string say(Sentence sentence, const Args&... args) {
  const std::string form = told(std::string(rows[sentence.row].en), std::string(rows[sentence.row].ru));
  if constexpr (sizeof...(Args) == 0) return form;
  else return fmt::format(fmt::runtime(form), args...);
}

/// Translates a sentence that arrives in English (from lang/block/format).
inline std::string translated_sentence(std::string_view en) {
  for (const Row& row : rows)
    if (row.en == en) return told(std::string(row.en), std::string(row.ru));
  return std::string(en);
}

}  // namespace kadr::loader_texts
