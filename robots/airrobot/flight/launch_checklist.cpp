#include "robots/airrobot/flight/launch_checklist.h"

#include <array>
#include <variant>

#include "core/base/text.h"

namespace usar::airrobot {

namespace {

constexpr Seconds first_data_time{10.0};

using TakeGeometry = bool (*)(SensorLayout&, const protocol::GeometryInfo&);
using TakeConfiguration = bool (*)(SensorLayout&, const protocol::ConfigurationInfo&);

struct Question {
    const char* type;
    std::variant<TakeGeometry, TakeConfiguration> take; ///< stores the answer; false if it has no usable value
};

constexpr std::array questions{
    Question{"Robot", takeRobotLimits},          Question{"Sonar", takeSonarGeometry},
    Question{"Sonar", takeSonarLimits},          Question{"RangeScanner", takeScannerGeometry},
    Question{"RangeScanner", takeScannerLimits},
};

modules::GeometryModule& moduleFor(TakeGeometry, modules::RobotModules& robot) {
    return robot.geometry;
}

modules::ConfigurationModule& moduleFor(TakeConfiguration, modules::RobotModules& robot) {
    return robot.configuration;
}

/// Asks the question if that has not been done before. Returns nullopt while the answer may still come, and then
/// whether it had a usable value.
std::optional<bool> settle(const Question& question, modules::RobotModules& robot, SensorLayout& layout) {
    return std::visit(
        [&](auto take) -> std::optional<bool> {
            auto& module = moduleFor(take, robot);
            const modules::QueryState state = module.state(question.type);
            if (state == modules::QueryState::Unknown)
                module.query(question.type);
            if (state == modules::QueryState::Unknown || state == modules::QueryState::Pending)
                return std::nullopt;
            const auto* const answer = module.answer(question.type);
            return answer && take(layout, *answer);
        },
        question.take);
}

std::string wordsFor(const Question& question) {
    const bool geometry = std::holds_alternative<TakeGeometry>(question.take);
    return std::string(question.type) + (geometry ? " geometry" : " configuration");
}

} // namespace

bool LaunchChecklist::answered(modules::RobotModules& robot, agent::CommandPort& port) {
    for (; question_ < questions.size(); ++question_) {
        const auto taken = settle(questions[question_], robot, layout_);
        if (!taken)
            return false;
        if (!*taken)
            port.publish(agent::BehaviorEvent{Severity::Warning, "The server did not say its " +
                                                                     wordsFor(questions[question_]) +
                                                                     "; the stock AirRobot's is taken."});
    }
    return true;
}

std::vector<std::string> LaunchChecklist::missingSensors(const modules::RobotModules& robot) const {
    std::vector<std::string> missing;
    if (!robot.sensors.ins())
        missing.emplace_back("INS");
    if (!robot.sensors.scan(layout_.scanner_name))
        missing.emplace_back("RangeScanner");
    for (const SonarMount& sonar : layout_.sonars)
        if (!robot.sensors.sonar(sonar.name))
            missing.push_back("Sonar " + sonar.name);
    return missing;
}

LaunchState LaunchChecklist::step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port) {
    if (!answered(robot, port)) {
        words_ = "waiting for " + wordsFor(questions[question_]);
        return LaunchState::Waiting;
    }
    if (!asked_all_)
        asked_all_ = now;
    missing_ = missingSensors(robot);
    if (!missing_.empty()) {
        const bool failed = now - *asked_all_ > first_data_time;
        const char* const silent = missing_.size() == 1 ? "This sensor sends nothing, and the survey needs it: "
                                                        : "These sensors send nothing, and the survey needs them: ";
        words_ = (failed ? silent : "waiting for first data of ") + listOf(missing_);
        return failed ? LaunchState::Failed : LaunchState::Waiting;
    }
    words_ = "ready";
    ready_ = true;
    return LaunchState::Ready;
}

} // namespace usar::airrobot
