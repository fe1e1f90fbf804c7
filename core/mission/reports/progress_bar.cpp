#include "core/mission/reports/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/time_range.h"

namespace usar::mission {

namespace {

const std::string to_line_start = "\r";
const std::string clear_to_line_end = "\x1b[K";

/// True for the bytes of UTF-8 that a character begins with.
bool beginsCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

std::size_t charactersIn(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, beginsCharacter));
}

/// The first `count` characters.
std::string cutTo(std::size_t count, const std::string& text) {
    const auto end = std::ranges::find_if(text, [&](char byte) { return beginsCharacter(byte) && count-- == 0; });
    return {text.begin(), end};
}

} // namespace

std::optional<Seconds> wallTimeLeft(const Progress& progress, Seconds wall_elapsed) {
    if (progress.time_left && progress.speed_x > 0.0)
        return *progress.time_left / progress.speed_x;
    if (progress.percent >= 1.0)
        return wall_elapsed * (100.0 - progress.percent) / progress.percent;
    return std::nullopt;
}

namespace {

/// Returns the figures that are known, the most important first; each begins with the gap before it.
std::vector<std::string> figuresOf(const Progress& progress, Seconds wall_elapsed) {
    std::vector<std::string> figures;
    const auto add = [&](const std::string& text) { figures.push_back("  " + text); };
    const auto addWhole = [&](std::optional<double> value, const std::string& unit) {
        if (value && std::isfinite(*value))
            add(fixed(std::floor(*value), 0) + unit);
    };
    if (progress.speed_x > 0.0)
        add(fixed(progress.speed_x, progress.speed_x < 10.0 ? 1 : 0) + "x");
    if (const auto left = wallTimeLeft(progress, wall_elapsed))
        add("ETA " + countdownText(*left));
    if (const auto range = progress.time_left_range; range && progress.speed_x > 0.0)
        figures.push_back(" (" + countdownText(range->least / progress.speed_x) + " to " +
                          countdownText(range->most / progress.speed_x) + ")");
    addWhole(progress.coverage_pct, " % covered");
    addWhole(progress.distance_m, " m traveled");
    if (progress.elapsed)
        add(countdownText(*progress.elapsed) + " elapsed");
    addWhole(progress.range_left_m, " m range left");
    return figures;
}

} // namespace

std::string barLine(double percent, const std::string& words, const std::vector<std::string>& figures,
                    std::optional<std::size_t> columns) {
    constexpr int width = 20;
    percent = std::clamp(percent, 0.0, 100.0);
    const auto filled = static_cast<std::size_t>(std::lround(percent / 100.0 * width));
    std::string line = "[" + std::string(filled, '#') + std::string(width - filled, '-') + "] ";
    const std::string number = fixed(std::floor(percent), 0);
    line += std::string(number.size() < 3 ? 3 - number.size() : 0, ' ') + number + " %  " + words;
    for (const std::string& figure : figures) {
        if (columns && charactersIn(line + figure) > *columns)
            break;
        line += figure;
    }
    return columns ? cutTo(*columns, line) : line;
}

std::string progressLine(const Progress& progress, Seconds wall_elapsed, std::optional<std::size_t> columns) {
    return barLine(progress.percent, progress.state, figuresOf(progress, wall_elapsed), columns);
}

std::string ProgressBar::show(const Progress& progress, Seconds wall, std::optional<std::size_t> columns) {
    return draw(progress.percent, columns,
                [&](std::optional<std::size_t> room) { return progressLine(progress, wall, room); });
}

std::string ProgressBar::draw(double percent, std::optional<std::size_t> columns,
                              const std::function<std::string(std::optional<std::size_t> columns)>& line) {
    const int tenth = static_cast<int>(percent / 10.0);
    if (is_terminal_) {
        drawn_ = true;
        if (columns && *columns > 0)
            --*columns; // In the last column some terminals go on to the next line.
        return to_line_start + line(columns) + clear_to_line_end;
    }
    if (tenth <= last_tenth_)
        return {};
    last_tenth_ = tenth;
    return line({}) + "\n";
}

std::string ProgressBar::say(const std::string& text) {
    return (std::exchange(drawn_, false) ? to_line_start + clear_to_line_end : std::string()) + text + "\n";
}

} // namespace usar::mission
