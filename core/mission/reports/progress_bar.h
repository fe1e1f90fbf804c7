// How a run shows its progress on a terminal, or in a file that standard error goes to.
#pragma once

#include <string>

#include "core/mission/session/progress_text.h"

namespace usar::mission {

/// A bar that redraws itself on a terminal, else a line for every tenth. A value: it makes the bytes, and whoever owns
/// it writes them.
class ProgressBar {
public:
    explicit ProgressBar(bool is_terminal) : is_terminal_(is_terminal) {}

    /// What is to be written for this progress; empty where there is nothing new. `wall` is wall time since the run
    /// began.
    [[nodiscard]] std::string show(const Progress& progress, Seconds wall);
    /// A line of text in place of the bar, which is drawn again below it with the next progress.
    [[nodiscard]] std::string say(const std::string& text);

private:
    bool is_terminal_;
    int last_tenth_ = -1;
    bool drawn_ = false; ///< the cursor is behind a bar
};

} // namespace usar::mission
