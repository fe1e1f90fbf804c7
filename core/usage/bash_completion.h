// A program's completion for bash.
#pragma once

#include "core/usage/program.h"

namespace usar::usage {

/// A script that bash sources, by itself or through bash-completion. It completes verbs, options, the words that an
/// option takes, and files and folders where those are wanted.
QByteArray bashCompletion(const Program& program);

} // namespace usar::usage
