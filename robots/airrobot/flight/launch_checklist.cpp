#include "robots/airrobot/flight/launch_checklist.h"

#include <array>

namespace usar::airrobot {

namespace {

constexpr Seconds first_data_time{10.0};

enum class Kind { Geometry, Configuration };

struct Question {
    Kind kind;
    const char* type;
    bool (*take_geometry)(SensorLayout&, const protocol::GeometryInfo&);
    bool (*take_configuration)(SensorLayout&, const protocol::ConfigurationInfo&);
};

constexpr std::array questions{
    Question{Kind::Configuration, "Robot", nullptr, takeRobotLimits},
    Question{Kind::Geometry, "Sonar", takeSonarGeometry, nullptr},
    Question{Kind::Configuration, "Sonar", nullptr, takeSonarLimits},
    Question{Kind::Geometry, "RangeScanner", takeScannerGeometry, nullptr},
    Question{Kind::Configuration, "RangeScanner", nullptr, takeScannerLimits},
};

modules::QueryState stateOf(const Question& question, const modules::RobotModules& robot) {
    return question.kind == Kind::Geometry ? robot.geometry.state(question.type)
                                           : robot.configuration.state(question.type);
}

void ask(const Question& question, modules::RobotModules& robot) {
    if (question.kind == Kind::Geometry)
        robot.geometry.query(question.type);
    else
        robot.configuration.query(question.type);
}

bool take(const Question& question, const modules::RobotModules& robot, SensorLayout& layout) {
    if (question.kind == Kind::Geometry) {
        const auto* answer = robot.geometry.answer(question.type);
        return answer && question.take_geometry(layout, *answer);
    }
    const auto* answer = robot.configuration.answer(question.type);
    return answer && question.take_configuration(layout, *answer);
}

std::string wordsFor(const Question& question) {
    return std::string(question.type) + (question.kind == Kind::Geometry ? " geometry" : " configuration");
}

} // namespace

bool LaunchChecklist::geometryKnown() const {
    return question_ == questions.size();
}

bool LaunchChecklist::answered(modules::RobotModules& robot, agent::CommandPort& port) {
    while (question_ < questions.size()) {
        const Question& question = questions[question_];
        const modules::QueryState state = stateOf(question, robot);
        if (state == modules::QueryState::Unknown) {
            ask(question, robot);
            break;
        }
        if (state == modules::QueryState::Pending)
            break;
        if (!take(question, robot, layout_))
            port.publish(agent::BehaviorEvent{Severity::Warning, "The server did not say its " + wordsFor(question) +
                                                                     "; the stock AirRobot's is taken."});
        ++question_;
    }
    return question_ == questions.size();
}

std::string LaunchChecklist::missingSensor(const modules::RobotModules& robot) const {
    if (!robot.sensors.ins())
        return "INS";
    if (!robot.sensors.scan(layout_.scanner_name))
        return "RangeScanner";
    for (const SonarMount& sonar : layout_.sonars)
        if (!robot.sensors.sonar(sonar.name))
            return "Sonar " + sonar.name;
    return {};
}

LaunchState LaunchChecklist::step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port) {
    if (!answered(robot, port)) {
        words_ = "waiting for " + wordsFor(questions[question_]);
        return LaunchState::Waiting;
    }
    if (!asked_all_)
        asked_all_ = now;
    if (const std::string missing = missingSensor(robot); !missing.empty()) {
        const bool failed = now - *asked_all_ > first_data_time;
        words_ = failed ? "The sensor " + missing + " sends nothing, and the survey needs it"
                        : "waiting for first data of " + missing;
        return failed ? LaunchState::Failed : LaunchState::Waiting;
    }
    words_ = "ready";
    ready_ = true;
    return LaunchState::Ready;
}

} // namespace usar::airrobot
