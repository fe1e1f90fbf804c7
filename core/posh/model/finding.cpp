#include "core/posh/model/finding.h"

#include <algorithm>
#include <cstddef>

#include "core/posh/model/utf8.h"

namespace usar::posh {

namespace {

std::string placeText(const Spot& at) {
    return std::to_string(at.line) + ':' + std::to_string(at.column);
}

} // namespace

std::string toText(Code code) {
    return (severityOf(code) == Severity::Error ? "E" : "W") + std::to_string(static_cast<int>(code));
}

Severity severityOf(Code code) {
    return static_cast<int>(code) < 400 ? Severity::Error : Severity::Warning;
}

bool isUnreadable(Code code) {
    return static_cast<int>(code) < 300;
}

std::string inQuotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (std::size_t at = 0; at < word.size();) {
        if (at >= longest) {
            text += "…";
            break;
        }
        const CodePoint character = codePointAt(word, at);
        appendUtf8(text, character.value < 0x20 ? U' ' : character.value);
        at += character.length;
    }
    return text + '"';
}

bool isReadable(const Findings& findings) {
    return std::ranges::none_of(findings, isUnreadable, &Finding::code);
}

bool hasErrors(const Findings& findings) {
    return std::ranges::any_of(findings,
                               [](const Finding& finding) { return severityOf(finding.code) == Severity::Error; });
}

std::string toText(const Finding& finding) {
    const char* const kind = severityOf(finding.code) == Severity::Error ? "error " : "warning ";
    std::string text = placeText(finding.at) + ": " + kind + toText(finding.code) + ": " + finding.message;
    if (finding.opener)
        text += " (the parenthesis at " + placeText(*finding.opener) + " is open)";
    return text;
}

} // namespace usar::posh
