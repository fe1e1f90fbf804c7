#include "robots/airrobot/survey_body.h"

#include <array>
#include <utility>

namespace usar::airrobot {

void SurveyBody::begin(const agent::Tick& tick) {
    tick_ = &tick;
    with([&tick](SurveyFlight& flight, agent::CommandPort& port) {
        flight.perceive(tick, port);
        if (flight.atWork() && !flight.landing())
            flight.look();
    });
    acting_ = true;
}

bool SurveyBody::order(agent::Order order) {
    flight_.order(order, port_);
    return true;
}

void SurveyBody::passOn() {
    for (agent::CausedCommand& caused : port_.takeCommands()) {
        if (protocol::isDrive(caused.command))
            drive(std::move(caused.command), toText(caused.cause.source));
        else
            send(std::move(caused.command), toText(caused.cause.source));
    }
    for (agent::Published& value : port_.takePublished())
        publish(std::move(value));
    if (acting_)
        noteState();
}

/// Writes the state that the acts share to the blackboard, so that the user can see it and set breakpoints on its
/// changes.
void SurveyBody::noteState() {
    static constexpr std::array words{"launch", "take-off", "to-lane", "lane", "home", "landing", "ground", "finished"};
    write("phase", posh::Symbol{words[static_cast<std::size_t>(flight_.phase())]});
    write("lane", static_cast<std::int64_t>(flight_.lane()));
    write("returning", flight_.returning());
}

} // namespace usar::airrobot
