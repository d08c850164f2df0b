// Examples and exit status at the end of each command's help.

#include "cli/options/help_text.h"
#include "config/language.h"

namespace kadr::cli {

std::string run_examples() {
  return told(
      "Examples:\n"
      "  kadr run flange.nc                              guess the control, print the summary\n"
      "  kadr run flange.nc --control s2c42 --plot f.svg draw the path\n"
      "  kadr run part.tap --control mach3 --trace -     every action as a line of JSON\n"
      "  kadr run part.nc --setup shop.json --lang ru    offsets and start from a file, in Russian\n"
      "Exit status: 0 ran to its end, 1 stopped by an alarm, 2 wrong usage or unreadable file.",
      "Примеры:\n"
      "  kadr run flange.nc                              УЧПУ определить по тексту, вывести сводку\n"
      "  kadr run flange.nc --control s2c42 --plot f.svg вычертить траекторию\n"
      "  kadr run part.tap --control mach3 --trace -     каждое действие строкой JSON\n"
      "  kadr run part.nc --setup shop.json --lang ru    корректоры и исходное положение из файла, по-русски\n"
      "Код возврата: 0 — УП дошла до конца, 1 — остановлена ошибкой, 2 — неверная команда или файл не читается.");
}

std::string debug_examples() {
  return told(
      "Commands, one a line (`help` lists them): step, next, finish, continue, until LINE, break LINE if #100 > 5, watch #100,\n"
      "print EXPRESSION, where, state, list, mdi BLOCK, back, quit. A place is printed as file:line: text.\n"
      "Examples:\n"
      "  kadr debug part.nc                              commands from the keyboard\n"
      "  kadr debug part.nc < commands.txt               commands from a file\n"
      "Exit status: 0 ran to its end or quit, 1 stopped by an alarm, 2 wrong usage or unreadable file.",
      "Команды, по одной в строке (перечень: `help`): step, next, finish, continue, until СТРОКА, break СТРОКА if #100 > 5,\n"
      "watch #100, print ВЫРАЖЕНИЕ, where, state, list, mdi КАДР, back, quit. Место выводится как файл:строка: текст.\n"
      "Примеры:\n"
      "  kadr debug part.nc                              команды с клавиатуры\n"
      "  kadr debug part.nc < commands.txt               команды из файла\n"
      "Код возврата: 0 — УП дошла до конца или quit, 1 — остановлена ошибкой, 2 — неверная команда или файл не читается.");
}

std::string check_examples() {
  return told(
      "Examples:\n"
      "  kadr check programs/                            every program of a folder, every fault\n"
      "  kadr check a.nc b.nc --control gost\n"
      "  kadr check programs/ --format sarif >r.sarif    for an editor or a code host\n"
      "  kadr check . --exclude 'old/*' --control-for '*.nct=nct' --strict\n"
      "  kadr check . --format json --output known.json; kadr check . --baseline known.json\n"
      "Exit status: 0 no error, 1 errors found, 2 wrong usage or unreadable file.",
      "Примеры:\n"
      "  kadr check programs/                            все УП папки, все ошибки\n"
      "  kadr check a.nc b.nc --control gost\n"
      "  kadr check programs/ --format sarif >r.sarif    для редактора или хранилища программ\n"
      "  kadr check . --exclude 'old/*' --control-for '*.nct=nct' --strict\n"
      "  kadr check . --format json --output known.json; kadr check . --baseline known.json\n"
      "Код возврата: 0 — ошибок нет, 1 — найдены ошибки, 2 — неверная команда или файл не читается.");
}

std::string explain_examples() {
  return told(
      "Examples:\n"
      "  kadr explain s2c42 G41         a code: group, words, source\n"
      "  kadr explain s2c42 L83         a cycle and its body\n"
      "  kadr explain mach3 X           an address\n"
      "  kadr explain mach3             the whole control\n"
      "  kadr explain mach3 radius_mismatch   an alarm and what to do\n"
      "  kadr explain nct setup         the keys of a set-up\n"
      "Exit status: 0, 2 wrong usage, or the control has nothing of that name.",
      "Примеры:\n"
      "  kadr explain s2c42 G41         код: группа, слова, источник\n"
      "  kadr explain s2c42 L83         цикл и его тело\n"
      "  kadr explain mach3 X           адрес\n"
      "  kadr explain mach3             всё УЧПУ\n"
      "  kadr explain mach3 radius_mismatch   ошибка и что делать\n"
      "  kadr explain nct setup         ключи исходного состояния\n"
      "Код возврата: 0; 2 — неверная команда или у УЧПУ нет ничего с таким именем.");
}

std::string controls_examples() {
  return told("Exit status: 0.\nSee also: kadr explain ID, kadr machines.",
              "Код возврата: 0.\nСм. также: kadr explain ОБОЗНАЧЕНИЕ, kadr machines.");
}

std::string machines_examples() {
  return told(
      "Examples:\n"
      "  kadr machines                  all of them, a line each\n"
      "  kadr machines nct-vmc          the axes of one: rapid rates, travels, accelerations\n"
      "  kadr machines shop.toml        of one's own file: whether it is right\n"
      "Exit status: 0, 2 no such machine, or its file is wrong.",
      "Примеры:\n"
      "  kadr machines                  все станки, по строке на каждый\n"
      "  kadr machines nct-vmc          оси одного: быстрые ходы, перемещения, ускорения\n"
      "  kadr machines shop.toml        свой файл: верен ли он\n"
      "Код возврата: 0; 2 — такого станка нет или его файл с ошибкой.");
}

std::string setup_examples() {
  return told(
      "Examples:\n"
      "  kadr setup part.nc --control nct                what is to be filled in, to standard output\n"
      "  kadr setup part.nc --control nct --out shop.json; kadr run part.nc --control nct --setup shop.json\n"
      "Exit status: 0 written, 2 wrong usage, unreadable file, or the file --out is there already.",
      "Примеры:\n"
      "  kadr setup part.nc --control nct                что надо заполнить, на стандартный вывод\n"
      "  kadr setup part.nc --control nct --out shop.json; kadr run part.nc --control nct --setup shop.json\n"
      "Код возврата: 0 — записано; 2 — неверная команда, файл не читается или файл --out уже есть.");
}

std::string tape_examples() {
  return told(
      "Examples:\n"
      "  kadr tape encode flange.nc flange.tape     text to rows with even parity\n"
      "  kadr tape decode flange.tape               rows to text; parity errors by row on stderr\n"
      "  kadr tape encode part.nc part.tape --code eia   rows of EIA RS-244, odd parity\n"
      "Exit status: 0 all well, 1 parity errors, a tape that lies wrongly or a character that has no code, 2 wrong usage.",
      "Примеры:\n"
      "  kadr tape encode flange.nc flange.tape     текст в строки перфоленты с чётным числом отверстий\n"
      "  kadr tape decode flange.tape               строки в текст; ошибки чётности построчно в stderr\n"
      "  kadr tape encode part.nc part.tape --code eia   строки в коде EIA RS-244, нечётное число отверстий\n"
      "Код возврата: 0 — без ошибок; 1 — ошибки чётности, лента считана не так или у символа нет кода; 2 — неверная команда.");
}

std::string state_examples() {
  return told(
      "Examples:\n"
      "  kadr state check shop.state                    sound, or what is damaged in it\n"
      "  kadr state recover shop.state --out new.state  what is sound, in a new file; the old one stays as it is\n"
      "Exit status: 0 sound, 1 damaged, 2 wrong usage, or no state that can be read.",
      "Примеры:\n"
      "  kadr state check shop.state                    исправен ли файл или что в нём повреждено\n"
      "  kadr state recover shop.state --out new.state  уцелевшее — в новый файл; прежний не меняется\n"
      "Код возврата: 0 — исправен, 1 — повреждён, 2 — неверная команда или это не читаемый файл состояния.");
}

std::string mill_examples() {
  return told(
      "Examples:\n"
      "  kadr mill pocket cover.dxf --tool-diameter 10 --depth 12 --pass 4 --control s2c42 --output cover.nc\n"
      "  kadr mill pocket cam.txt --tool-diameter 8 --depth 5 --scheme СПИР --stepover 60% --control mach3\n"
      "  kadr mill face plate.svg --tool-diameter 50 --depth 1 --control nct --plot face.svg\n"
      "  kadr mill slot groove.txt --tool-diameter 8 --depth 6 --pass 2 --control gost\n"
      "Exit status: 0 written and verified, 1 the contour or the path is faulty, 2 wrong usage or unreadable file.",
      "Примеры:\n"
      "  kadr mill pocket cover.dxf --tool-diameter 10 --depth 12 --pass 4 --control s2c42 --output cover.nc\n"
      "  kadr mill pocket cam.txt --tool-diameter 8 --depth 5 --scheme СПИР --stepover 60% --control mach3\n"
      "  kadr mill face plate.svg --tool-diameter 50 --depth 1 --control nct --plot face.svg\n"
      "  kadr mill slot groove.txt --tool-diameter 8 --depth 6 --pass 2 --control gost\n"
      "Код возврата: 0 — записано и проверено, 1 — ошибка в контуре или траектории, 2 — неверная команда или файл не читается.");
}

std::string diff_examples() {
  return told(
      "Examples:\n"
      "  kadr diff part.nc part-new.nc                   what the edited program does otherwise\n"
      "  kadr diff part.nc part-new.nc --plot diff.svg   a picture of it\n"
      "  kadr diff part.tap part.mpf --control-a mach3 --control-b nct --tolerance 0.01\n"
      "A line cut in two is the same line; comments, numbers of blocks and how it is written do not count.\n"
      "Exit status: 0 both do the same, 1 they differ or one is stopped by an alarm, 2 wrong usage or unreadable file.",
      "Примеры:\n"
      "  kadr diff part.nc part-new.nc                   что изменённая УП делает иначе\n"
      "  kadr diff part.nc part-new.nc --plot diff.svg   чертёж различий\n"
      "  kadr diff part.tap part.mpf --control-a mach3 --control-b nct --tolerance 0.01\n"
      "Отрезок, разбитый на два, — тот же отрезок; комментарии, номера кадров и запись значения не имеют.\n"
      "Код возврата: 0 — делают одно и то же, 1 — различаются или одна остановлена ошибкой, 2 — неверная команда или файл не читается.");
}

std::string convert_examples() {
  return told(
      "Examples:\n"
      "  kadr convert flange.nc --from s2c42 --to mach3 --setup flange.json --out flange.tap --setup-out mach3.json\n"
      "  kadr convert part.nc --to fanuc > part-fanuc.nc\n"
      "Both programs are run by their controls; one that is not proven to do the same is not written.\n"
      "Exit status: 0 written and proven, 1 refused (each way of writing it with the place that it fails at), 2 wrong usage or unreadable "
      "file.",
      "Примеры:\n"
      "  kadr convert flange.nc --from s2c42 --to mach3 --setup flange.json --out flange.tap --setup-out mach3.json\n"
      "  kadr convert part.nc --to fanuc > part-fanuc.nc\n"
      "Обе УП отрабатываются своими системами; недоказанная не записывается.\n"
      "Код возврата: 0 — записано и доказано, 1 — отказ (для каждого способа записи названо место), 2 — неверная команда или файл не "
      "читается.");
}

std::string serve_examples() {
  return told(
      "Examples:\n"
      "  kadr serve\n"
      "  kadr serve programs --port 9000 --no-browser\n"
      "Ends with Ctrl-C. Exit status: 2 the folder cannot be read, the port is taken.",
      "Примеры:\n"
      "  kadr serve\n"
      "  kadr serve programs --port 9000 --no-browser\n"
      "Закончить: Ctrl-C. Код возврата: 2 — папка не читается, порт занят.");
}

std::string cut_examples() {
  return told(
      "Examples:\n"
      "  kadr cut pocket.ngc --stock box:0,0,-20,100,100,0 --tools tools.toml\n"
      "  kadr cut pocket.ngc --stock box:0,0,-20,100,100,0 --tools tools.toml --out part.stl --json part.json\n"
      "  kadr cut part.nc --stock cylinder:0,0,-30,0,60 --tools tools.toml --fixture box:-60,-60,-50,60,60,-30\n"
      "Exit status: 0 all well, 1 a collision or an alarm, 2 wrong usage or unreadable file.",
      "Примеры:\n"
      "  kadr cut pocket.ngc --stock box:0,0,-20,100,100,0 --tools tools.toml\n"
      "  kadr cut pocket.ngc --stock box:0,0,-20,100,100,0 --tools tools.toml --out part.stl --json part.json\n"
      "  kadr cut part.nc --stock cylinder:0,0,-30,0,60 --tools tools.toml --fixture box:-60,-60,-50,60,60,-30\n"
      "Код возврата: 0 — всё в порядке, 1 — столкновение или ошибка УП, 2 — неверная команда или файл не читается.");
}

std::string report_examples() {
  return told(
      "Examples:\n"
      "  kadr report flange.nc --out flange.html\n"
      "  kadr report pocket.ngc --setup shop.json --stock box:0,0,-20,100,100,0 --tools tools.toml --out pocket.html\n"
      "The file opens in any browser, without a network.\n"
      "Exit status: 0 all well, 1 an alarm or a collision (the report is written), 2 wrong usage.",
      "Примеры:\n"
      "  kadr report flange.nc --out flange.html\n"
      "  kadr report pocket.ngc --setup shop.json --stock box:0,0,-20,100,100,0 --tools tools.toml --out pocket.html\n"
      "Файл открывается в любом браузере, без сети.\n"
      "Код возврата: 0 — всё в порядке, 1 — ошибка УП или столкновение (отчёт записан), 2 — неверная команда.");
}

std::string man_examples() {
  return told(
      "Examples:\n"
      "  kadr man >kadr.1; man -l kadr.1\n"
      "  kadr man --lang ru >kadr.1     the page in Russian",
      "Примеры:\n"
      "  kadr man --lang ru >kadr.1; man -l kadr.1\n"
      "  kadr man --lang en >kadr.1     страница по-английски");
}

std::string completion_examples() {
  return told(
      "Examples:\n"
      "  kadr completion bash >~/.local/share/bash-completion/completions/kadr\n"
      "  kadr completion zsh >~/.zfunc/_kadr              a folder of fpath\n"
      "  kadr completion fish >~/.config/fish/completions/kadr.fish",
      "Примеры:\n"
      "  kadr completion bash >~/.local/share/bash-completion/completions/kadr\n"
      "  kadr completion zsh >~/.zfunc/_kadr              папка из fpath\n"
      "  kadr completion fish >~/.config/fish/completions/kadr.fish");
}

}  // namespace kadr::cli
