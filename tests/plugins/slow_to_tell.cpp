// Takes its time to describe itself (seconds in the environment's USAR_TEST_SLOW_S), and longer than anybody waits to
// foretell a wide area. It writes the file that USAR_TEST_SLOW_BEGUN names when it begins.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/plugins/minimal_plugin.h"

class SlowToTell : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID USAR_ROBOT_PLUGIN_IID FILE "slow_to_tell.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    usar::agent::RobotDescription description() const override {
        if (const char* const file = std::getenv("USAR_TEST_SLOW_BEGUN"))
            std::ofstream(file) << "begun";
        if (const char* const seconds = std::getenv("USAR_TEST_SLOW_S"))
            std::this_thread::sleep_for(usar::Seconds(std::strtod(seconds, nullptr)));
        usar::agent::RobotDescription robot = usar::test::minimalDescription();
        robot.class_name = "USARBot.AirRobot";
        robot.behaviors.front().id = "slow/idle";
        robot.behaviors.front().name = "Idle at last";
        robot.behaviors.front().needs_area = true;
        return robot;
    }
    usar::Result<std::unique_ptr<usar::agent::Behavior>> createBehavior(const std::string&,
                                                                        usar::agent::BehaviorContext) const override {
        return std::make_unique<usar::test::IdleBehavior>();
    }
    usar::Result<usar::agent::TaskPreview> preview(const std::string&,
                                                   const usar::agent::BehaviorContext& context) const override {
        const double width_m = (context.task.area_in_map.max_m - context.task.area_in_map.min_m).x();
        if (width_m > 30.0)
            std::this_thread::sleep_for(std::chrono::minutes(1));
        return usar::agent::TaskPreview{
            {{1.0, 2.0}, {3.0, 2.0}}, width_m, usar::Seconds(4.0), std::to_string(static_cast<int>(width_m)) + " wide"};
    }
};

#include "slow_to_tell.moc"
