// The progress display of a run, for a terminal or for a file that standard error is redirected to.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/mission/runs/mission_runner.h"

namespace usar::mission {

/// Wall time until the end, from the behavior's own estimate, or else from the percentage so far; nullopt if neither
/// helps.
std::optional<Seconds> wallTimeLeft(const Progress& progress, Seconds wall_elapsed);

/// Formats a line such as "[########------------]  40 %  scanning lane 4 of 9  120x  ETA 0:12 (0:10 to 0:14)  37 %
/// covered  812 m traveled  16:00 elapsed  310 m range left"; what is not known is left out. `columns`: the most
/// characters that it may have, so figures at its end are left out, and then words are cut; absent: any number.
std::string progressLine(const Progress& progress, Seconds wall_elapsed, std::optional<std::size_t> columns = {});

/// The same for anything that is done by and by: "[########------------]  40 %", the words, and the figures, each of
/// which begins with the gap before it.
std::string barLine(double percent, const std::string& words, const std::vector<std::string>& figures,
                    std::optional<std::size_t> columns = {});

/// A bar that is redrawn in place on a terminal; otherwise one line for every 10 %. It only returns the bytes; its
/// owner writes them.
class ProgressBar {
public:
    explicit ProgressBar(bool is_terminal) : is_terminal_(is_terminal) {}

    /// Returns the text to write for this progress; empty if there is nothing new. `wall` is the wall time since the
    /// run began. `columns`: of the terminal, where a line that is longer could not be drawn in place; absent: unknown.
    [[nodiscard]] std::string show(const Progress& progress, Seconds wall, std::optional<std::size_t> columns = {});
    /// The same with any line, which is made for so many columns.
    [[nodiscard]] std::string draw(double percent, std::optional<std::size_t> columns,
                                   const std::function<std::string(std::optional<std::size_t> columns)>& line);
    /// Returns a line of text that replaces the bar; the next `show` draws the bar again below it.
    [[nodiscard]] std::string say(const std::string& text);

private:
    bool is_terminal_;
    int last_tenth_ = -1; ///< last tenth (0-10) that a line was written for; -1: none yet
    bool drawn_ = false;  ///< the cursor is at the end of a drawn bar
};

} // namespace usar::mission
