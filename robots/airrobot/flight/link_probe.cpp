#include "robots/airrobot/flight/link_probe.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/text.h"

namespace usar::airrobot {

namespace {

constexpr Seconds ask_every{0.6};
/// Answers come with the lines of the next tick, and a tick may be a fifth of a second.
constexpr Seconds usual_answer{0.4};
constexpr Seconds told_from{0.3};
/// An answer that has not come for so long got lost.
constexpr Seconds answer_lost_after{30.0};
/// A single question that stays open may have been lost on its way.
constexpr int sure_of = 2;

/// The flight needs these sensors, so they are there. Their answers are short, and the same as for others who ask.
struct Question {
    const char* type;
    bool geometry;
};
constexpr std::array questions{Question{"INS", true}, Question{"INS", false}, Question{"RangeScanner", true},
                               Question{"RangeScanner", false}};

Seconds beyondUsual(Seconds time) {
    const Seconds late = time - usual_answer;
    return late < told_from ? Seconds(0.0) : late;
}

} // namespace

void LinkProbe::hear(const protocol::InfoMessage& message) {
    static_assert(questions.size() == kinds);
    const auto* const geometry = std::get_if<protocol::GeometryInfo>(&message);
    const auto* const configuration = std::get_if<protocol::ConfigurationInfo>(&message);
    if (!geometry && !configuration)
        return;
    const std::string& type = geometry ? geometry->type : configuration->type;
    for (std::size_t kind = 0; kind < kinds; ++kind)
        if (questions[kind].geometry == (geometry != nullptr) && sameWord(type, questions[kind].type))
            heard_[kind] = true;
}

void LinkProbe::step(Seconds now, agent::CommandPort& port) {
    for (std::size_t kind = 0; kind < kinds; ++kind)
        if (std::exchange(heard_[kind], false))
            take(kind, now);
    if (!asked_at_ || now < *asked_at_ || now - *asked_at_ >= ask_every)
        ask(now, port);
    if (measured_)
        late_ = std::max(*measured_, openFor(now));
}

void LinkProbe::take(std::size_t kind, Seconds now) {
    const Asked answered = asked_[kind];
    if (!answered.open)
        return; // Somebody else has asked.
    measured_ = beyondUsual(now - answered.at);
    for (Asked& one : asked_)
        one.open = one.open && one.at > answered.at; // Answers keep their order, so earlier ones got lost.
}

void LinkProbe::ask(Seconds now, agent::CommandPort& port) {
    Asked& asked = asked_[next_];
    if (asked.open && now >= asked.at && now - asked.at < answer_lost_after)
        return;
    const protocol::Token type = *protocol::Token::make(questions[next_].type);
    if (questions[next_].geometry)
        port.send(protocol::GetGeometry{type}, "measuring the link");
    else
        port.send(protocol::GetConfiguration{type}, "measuring the link");
    asked = {now, true};
    asked_at_ = now;
    next_ = (next_ + 1) % kinds;
}

Seconds LinkProbe::openFor(Seconds now) const {
    const auto open = std::ranges::count_if(
        asked_, [&](const Asked& one) { return one.open && now - one.at >= usual_answer + told_from; });
    if (open < sure_of)
        return Seconds(0.0);
    Seconds oldest = now;
    for (const Asked& one : asked_)
        if (one.open)
            oldest = std::min(oldest, one.at);
    return beyondUsual(now - oldest);
}

} // namespace usar::airrobot
