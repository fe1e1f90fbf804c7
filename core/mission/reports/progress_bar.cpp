#include "core/mission/reports/progress_bar.h"

#include <utility>

namespace usar::mission {

namespace {

const std::string to_line_start = "\r";
const std::string clear_to_line_end = "\x1b[K";

} // namespace

std::string ProgressBar::show(const Progress& progress, Seconds wall) {
    const int tenth = static_cast<int>(progress.percent / 10.0);
    if (is_terminal_) {
        drawn_ = true;
        return to_line_start + progressLine(progress, wall) + clear_to_line_end;
    }
    if (tenth <= last_tenth_)
        return {};
    last_tenth_ = tenth;
    return progressLine(progress, wall) + "\n";
}

std::string ProgressBar::say(const std::string& text) {
    return (std::exchange(drawn_, false) ? to_line_start + clear_to_line_end : std::string()) + text + "\n";
}

} // namespace usar::mission
