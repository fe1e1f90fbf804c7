// Functions by which usar-mission writes to a terminal and ends.
#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

#include <sys/ioctl.h>
#include <unistd.h>

#include <QJsonDocument>
#include <QJsonObject>

namespace usar::app {

inline void tell(const std::string& text) {
    std::fputs(text.c_str(), stderr);
}

inline void complain(const std::string& text) {
    tell("usar-mission: " + text + "\n");
}

inline bool isTerminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

/// Returns the width of the terminal at standard error; nullopt if there is no terminal, or it does not say.
inline std::optional<std::size_t> terminalColumns() {
    winsize size{};
    const bool told = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return told ? std::optional<std::size_t>(size.ws_col) : std::nullopt;
}

/// Prints the summary as the last line of standard output; returns `exit_code`.
inline int end(int exit_code, const QJsonObject& summary) {
    std::printf("%s\n", QJsonDocument(summary).toJson(QJsonDocument::Compact).constData());
    return exit_code;
}

} // namespace usar::app
