#include "core/mission/session/notices.h"

#include <array>
#include <utility>

#include "core/base/numbers.h"

namespace usar::mission {

namespace {

/// Words of the topics, in their order; a word ends with ": " if a further word follows.
constexpr std::array<std::string_view, std::size_t(Topic::StartPoses) + 1> topic_words{
    "adjustment", "behavior: ", "cell size",     "clock",    "control",  "lines: ",   "far parts",
    "fault",      "link",       "no connection", "no robot", "overlong", "placement", "queue",
    "recording",  "replay",     "second robot",  "sensor: ", "silence",  "spawn",     "start poses"};

std::string_view wordOf(Topic topic) {
    return topic_words[static_cast<std::size_t>(topic)];
}

} // namespace

std::string textOf(Topic topic, std::string_view which) {
    return std::string(wordOf(topic)).append(which);
}

std::string spanText(Seconds span) {
    return shortest(span.count()) + " s";
}

void Notices::say(Severity severity, Topic topic, std::string text, std::string_view which) {
    if (!muted_)
        taker_({.severity = severity, .text = std::move(text), .topic = textOf(topic, which)});
}

void Notices::trouble(Severity severity, Topic topic, std::string text, std::string_view which) {
    standing_.emplace(textOf(topic, which), topic);
    say(severity, topic, std::move(text), which);
}

void Notices::over(Topic topic, std::string text, std::string_view which) {
    std::string topic_text = textOf(topic, which);
    if (standing_.erase(topic_text) > 0 && !muted_)
        taker_({.severity = Severity::Note, .text = std::move(text), .topic = std::move(topic_text), .over = true});
}

void Notices::endThoseOfTheConnection() {
    for (const auto& [text, topic] : std::map(standing_))
        if (topic != Topic::NoConnection && topic != Topic::Link && topic != Topic::Spawn)
            over(topic, {}, std::string_view(text).substr(wordOf(topic).size()));
}

void Notices::endAll() {
    for (const auto& [text, topic] : std::map(standing_))
        if (topic != Topic::NoConnection)
            over(topic, {}, std::string_view(text).substr(wordOf(topic).size()));
}

} // namespace usar::mission
