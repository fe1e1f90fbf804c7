#include "robots/submarine/limits.h"

#include <array>

namespace usar::submarine {

namespace {
constexpr std::array questions{"Robot", "Camera", "MisPkg", "Range"};
} // namespace

bool Questionnaire::goOn(modules::ConfigurationModule& configuration) {
    using modules::QueryState;
    if (asked_ == questions.size())
        return true;
    const char* const type = questions[asked_];
    const QueryState state = configuration.state(type);
    if (state == QueryState::Unknown)
        configuration.query(type);
    if (state == QueryState::Unknown || state == QueryState::Pending)
        return false;
    if (const auto* const answer = configuration.answer(type)) // Otherwise the host has told the user
        take(*answer);
    return ++asked_ == questions.size();
}

void Questionnaire::take(const protocol::ConfigurationInfo& answer) {
    if (const auto cameras = protocol::cameraConfigurationsOf(answer); !cameras.empty())
        limits_.camera = cameras.front();
    if (const auto packages = protocol::packageConfigurationsOf(answer); !packages.empty())
        limits_.mount = packages.front();
    if (const auto sensors = protocol::sensorConfigurationsOf(answer); !sensors.empty())
        limits_.ray_reach_m = sensors.front().range_max_m.value_or(limits_.ray_reach_m);
    if (!protocol::robotConfigurationOf(answer) || answer.items.empty())
        return;
    const protocol::ConfiguredItem& robot = answer.items.front();
    limits_.propeller_rad_s = robot.number("MaxPropellerSpeed").value_or(limits_.propeller_rad_s);
    limits_.rudder_rad = robot.number("MaxRudderAngle").value_or(limits_.rudder_rad);
    limits_.stern_plane_rad = robot.number("MaxSternPlaneAngle").value_or(limits_.stern_plane_rad);
}

} // namespace usar::submarine
