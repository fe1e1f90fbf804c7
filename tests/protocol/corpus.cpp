#include "corpus.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace corpus {

namespace {

std::filesystem::path ownFolder() {
    return std::filesystem::path(USAR_SOURCE_DIR) / "tests/data/protocol";
}

std::filesystem::path otherFolder() {
    const char* const named = std::getenv("USAR_PROTOCOL_CORPUS");
    return named ? std::filesystem::path(named) : std::filesystem::path(USAR_SOURCE_DIR) / "../shared/corpus";
}

void append(const std::filesystem::path& file, std::vector<Line>& lines) {
    std::ifstream in(file, std::ios::binary);
    std::string source;
    int number = 0;
    for (std::string text; std::getline(in, text);) {
        ++number;
        if (text.starts_with("# source:"))
            source = text;
        else if (!text.empty() && !text.starts_with('#'))
            lines.push_back({text, source, source.find("(captured") != std::string::npos,
                             file.filename().string() + ":" + std::to_string(number)});
    }
}

std::string unescaped(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        ++i;
        result += text[i] == 'r' ? '\r' : text[i] == 'n' ? '\n' : text[i];
    }
    return result;
}

} // namespace

std::vector<Line> infoLines() {
    std::vector<Line> lines;
    append(ownFolder() / "info_lines.txt", lines);
    append(ownFolder() / "captured_lines.txt", lines);
    append(otherFolder() / "info-messages.txt", lines);
    return lines;
}

std::vector<Line> commandLines() {
    std::vector<Line> lines;
    append(ownFolder() / "command_lines.txt", lines);
    append(otherFolder() / "commands.txt", lines);
    return lines;
}

std::vector<std::string> recordedChunks() {
    std::vector<Line> lines;
    append(ownFolder() / "recorded_chunks.txt", lines);
    append(otherFolder() / "chunks-ut2004-p2dx.txt", lines);
    std::vector<std::string> chunks;
    for (const Line& line : lines)
        chunks.push_back(unescaped(line.text));
    return chunks;
}

} // namespace corpus
