// Programs for the tests of their pages, and the tools that read those.
#pragma once

#include "core/usage/program.h"

namespace usar::usage_tests {

/// A program with the verbs `fly` and `tell`, and texts that roff would take for its own.
usage::Program smallProgram();
/// One without verbs.
usage::Program plainProgram();

/// What the program prints to standard output for this input; empty unless it ends well and complains of nothing.
QString outputOf(const QString& program, const QStringList& arguments, const QByteArray& input = {},
                 const QString& folder = {});

} // namespace usar::usage_tests
