#include "robots/airrobot/survey_body.h"

#include <utility>

namespace usar::airrobot {

void SurveyBody::begin(const agent::Tick& tick) {
    tick_ = &tick;
    with([&tick](SurveyFlight& flight, agent::CommandPort& port) {
        flight.perceive(tick, port);
        if (flight.atWork() && !flight.landing())
            flight.look();
    });
}

bool SurveyBody::order(agent::Order order) {
    flight_.order(order, port_);
    return true;
}

void SurveyBody::passOn() {
    for (agent::CausedCommand& caused : port_.takeCommands()) {
        if (protocol::isDrive(caused.command))
            drive(std::move(caused.command), caused.cause.source);
        else
            send(std::move(caused.command), caused.cause.source);
    }
    for (agent::Published& value : port_.takePublished())
        publish(std::move(value));
}

} // namespace usar::airrobot
