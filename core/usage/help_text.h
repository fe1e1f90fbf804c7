// The text that --help prints.
#pragma once

#include "core/usage/program.h"

namespace usar::usage {

/// How to call the verb, its purpose, options, notes and exit codes, in lines of at most 100 characters as far as words
/// allow it.
QString helpText(const Verb& verb);
/// Without verbs: as of its only verb, and the sections that belong there. With verbs: how to call each of them and its
/// purpose.
QString helpText(const Program& program);

/// The text to print if the arguments, without the program's name, ask for help; otherwise nothing. After a verb it is
/// that verb's text.
std::optional<QString> answerToHelp(const Program& program, const QStringList& arguments);

} // namespace usar::usage
