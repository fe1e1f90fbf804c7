// Lines of protocol text for tests: our own in tests/data/protocol, and a larger collection where one is found.
#pragma once

#include <string>
#include <vector>

namespace corpus {

/// One line and the header it stands under. `captured`: the header says that a real server or client sent it.
struct Line {
    std::string text;
    std::string source;
    bool captured = false;
    /// "info_lines.txt:12", for naming rows.
    std::string place;
};

/// Lines of tests/data/protocol, and of the same kind of file in the folder that the environment variable
/// USAR_PROTOCOL_CORPUS or, without it, shared/corpus beside the checkout holds. `# source: …` lines are headers.
std::vector<Line> infoLines();
std::vector<Line> commandLines();

/// Pieces as successive recv calls gave them, escapes undone.
std::vector<std::string> recordedChunks();

} // namespace corpus
