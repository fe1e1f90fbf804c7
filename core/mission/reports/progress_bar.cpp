#include "core/mission/reports/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/time_range.h"

namespace usar::mission {

namespace {

const std::string to_line_start = "\r";
const std::string clear_to_line_end = "\x1b[K";

} // namespace

std::optional<Seconds> wallTimeLeft(const Progress& progress, Seconds wall_elapsed) {
    if (progress.time_left && progress.speed_x > 0.0)
        return *progress.time_left / progress.speed_x;
    if (progress.percent >= 1.0)
        return wall_elapsed * (100.0 - progress.percent) / progress.percent;
    return std::nullopt;
}

std::string progressLine(const Progress& progress, Seconds wall_elapsed) {
    constexpr int width = 20;
    const double percent = std::clamp(progress.percent, 0.0, 100.0);
    const auto filled = static_cast<std::size_t>(std::lround(percent / 100.0 * width));
    std::string line = "[" + std::string(filled, '#') + std::string(width - filled, '-') + "] ";
    const std::string number = fixed(std::floor(percent), 0);
    line += std::string(number.size() < 3 ? 3 - number.size() : 0, ' ') + number + " %  " + progress.state;
    if (progress.speed_x > 0.0)
        line += "  " + fixed(progress.speed_x, progress.speed_x < 10.0 ? 1 : 0) + "x";
    if (const auto left = wallTimeLeft(progress, wall_elapsed))
        line += "  ETA " + countdownText(*left);
    if (const auto range = progress.time_left_range; range && progress.speed_x > 0.0)
        line += " (" + countdownText(range->least / progress.speed_x) + " to " +
                countdownText(range->most / progress.speed_x) + ")";
    return line;
}

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
