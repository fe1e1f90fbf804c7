// A program's page for man(1).
#pragma once

#include "core/usage/program.h"

namespace usar::usage {

/// The page in the macros of man(7), in ASCII alone, so that every version of man reads it the same. `version` and
/// `date` (2026-11-27) are those of the whole package.
QByteArray manPage(const Program& program, const QString& version, const QString& date);

} // namespace usar::usage
