#include "core/mission/session/notices.h"

#include <utility>

#include "core/base/numbers.h"

namespace usar::mission {

namespace {

/// Ends with ": " if a further word follows.
std::string_view wordOf(Topic topic) {
    switch (topic) {
    case Topic::Behavior:
        return "behavior: ";
    case Topic::CellSize:
        return "cell size";
    case Topic::Control:
        return "control";
    case Topic::DamagedLine:
        return "lines: ";
    case Topic::FarParts:
        return "far parts";
    case Topic::Fault:
        return "fault";
    case Topic::Link:
        return "link";
    case Topic::NoConnection:
        return "no connection";
    case Topic::NoRobot:
        return "no robot";
    case Topic::Overlong:
        return "overlong";
    case Topic::Placement:
        return "placement";
    case Topic::Queue:
        return "queue";
    case Topic::Recording:
        return "recording";
    case Topic::Replay:
        return "replay";
    case Topic::SecondRobot:
        return "second robot";
    case Topic::Sensor:
        return "sensor: ";
    case Topic::Silence:
        return "silence";
    case Topic::Spawn:
        return "spawn";
    case Topic::StartPoses:
        return "start poses";
    }
    return {};
}

} // namespace

std::string textOf(Topic topic, std::string_view which) {
    return std::string(wordOf(topic)).append(which);
}

std::string spanText(Seconds span) {
    std::string text;
    appendShortest(text, span.count());
    return text + " s";
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
