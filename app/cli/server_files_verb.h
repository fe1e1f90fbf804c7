// The verb of usar-mission that makes configuration files for real USARSim servers from the robot files.
#pragma once

#include <QStringList>

#include "core/usage/program.h"

namespace usar::app {

usage::Verb serverFilesVerb();

/// Runs the verb with the arguments that follow the program's name; returns the exit code. Errors go to standard error.
int runServerFilesVerb(const QStringList& arguments);

} // namespace usar::app
