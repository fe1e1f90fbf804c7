#include "core/link/greeting_check.h"

#include <algorithm>

#include "core/base/text.h"

namespace usar::link {

namespace {

/// This many lines of another shape prove that a server is not USARSim.
constexpr int patience_lines = 3;

bool isControlByte(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\t' && c != '\r' && c != '\n';
}

enum class Shape { Message, WordAlone, Other };

Shape shapeOf(std::string_view line) {
    const auto word_end = std::ranges::find_if_not(line, isWordByte);
    const auto word_size = static_cast<std::size_t>(word_end - line.begin());
    if (word_size == 0 || word_size > 32)
        return Shape::Other;
    const auto rest = line.substr(word_size);
    const auto next = rest.find_first_not_of(" \t");
    if (next == std::string_view::npos)
        return Shape::WordAlone;
    return rest[next] == '{' ? Shape::Message : Shape::Other;
}

bool isKnownGreeting(std::string_view line) {
    static constexpr std::string_view greetings[] = {"HTTP/", "SSH-", "220 ", "220-", "<!",
                                                     "<html", "RFB ", "+OK",  "-ERR", "* OK"};
    return std::ranges::any_of(greetings, [&](std::string_view greeting) { return line.starts_with(greeting); });
}

} // namespace

void GreetingCheck::takeBytes(std::string_view bytes) {
    if (verdict_ == Verdict::Unknown && std::ranges::any_of(bytes, isControlByte))
        verdict_ = Verdict::Foreign;
}

void GreetingCheck::takeLine(std::string_view line) {
    if (verdict_ != Verdict::Unknown)
        return;
    const Shape shape = shapeOf(line);
    if (shape == Shape::Message)
        verdict_ = Verdict::Usarsim;
    else if (shape == Shape::Other && (isKnownGreeting(line) || ++strange_ >= patience_lines))
        verdict_ = Verdict::Foreign;
}

} // namespace usar::link
