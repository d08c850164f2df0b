#pragma once
// Where the text of a program comes from: a file of any length, or text in memory. UTF-16 is converted to UTF-8.

#include "lang/text/line_reader.h"  // open_file, text_source
#include "lang/text/utf16.h"        // open_text, as_text
