// The AirRobot and its behaviors, separate from the plugin class so that tests can link them.
#pragma once

#include "core/agent/listed_robot.h"

namespace usar::airrobot {

/// The behaviors "airrobot/cpp" and "airrobot/posh": the same SurveyFlight, controlled by C++ or by a plan.
class AirRobot : public agent::ListedRobot {
public:
    AirRobot();
    /// Returns the lanes of a survey and its duration without obstacles and charging. Fails if no lanes fit into the
    /// area.
    Result<agent::TaskPreview> preview(const std::string& id, const agent::BehaviorContext& context) const override;
};

} // namespace usar::airrobot
