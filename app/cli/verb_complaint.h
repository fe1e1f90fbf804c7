// Reports an error of one of usar-mission's verbs.
#pragma once

#include <cstdio>

#include "core/base/result.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

/// Prints the error to standard error and returns the exit code for bad input.
inline int complain(const Error& error) {
    std::fprintf(stderr, "usar-mission: %s\n", error.text().c_str());
    return mission::BadInput;
}

} // namespace usar::app
