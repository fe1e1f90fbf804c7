// The command line of usar-behavior-host in words.
#pragma once

#include "core/usage/program.h"

namespace usar::app {

inline usage::Program behaviorHostProgram() {
    return {.name = "usar-behavior-host",
            .title = "run a robot's behavior in a process of its own",
            .description = {"usar-behavior-host runs one behavior for mission-control and usar-mission, so that only "
                            "that process ends if the behavior crashes or hangs. They start it where a behavior is to "
                            "run in a separate process (usar-mission run --isolate); it is never started by hand."},
            .verbs = {{.name = {},
                       .calls = {"usar-behavior-host SOCKET"},
                       .purpose = "Runs a robot's behavior for mission-control and usar-mission, which start it to run "
                                  "a behavior in a separate process (usar-mission run --isolate). SOCKET is the number "
                                  "of an open file that it inherits.",
                       .options = {usage::helpOption(), usage::versionOption()},
                       .exit_codes = {{0, "the behavior was no longer needed"},
                                      {1, "the behavior could not be made"},
                                      {2, "it was started by hand, or by another version"}}}},
            .see_also = {"mission-control", "usar-mission"}};
}

} // namespace usar::app
