// The command line of usar-mission in words.
#pragma once

#include "core/usage/program.h"

namespace usar::app {

usage::Program missionProgram();

} // namespace usar::app
