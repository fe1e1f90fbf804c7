// The entry point of the plugin: the robot it is for, the behaviors it has, and how a behavior is created.
#include <QObject>

#include "core/agent/robot_plugin.h"
#include "hop.h"

namespace usar::sample {

class SamplePlugin : public QObject, public agent::RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID USAR_ROBOT_PLUGIN_IID FILE "sample.json")
    Q_INTERFACES(usar::agent::RobotPlugin)

public:
    agent::RobotDescription description() const override {
        agent::BehaviorDescription hop;
        hop.id = "sample/hop"; // Must be the same as in sample.json
        hop.name = "Hop (sample)";
        hop.help = "Climbs, flies forward, lands.";
        hop.parameters = hopParameters();
        return {"USARBot.AirRobot", "AirRobot", {"INS"}, {hop}};
    }

    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext context) const override {
        if (id != "sample/hop")
            return failure("the sample has no such behavior", "behavior " + id, "Use sample/hop");
        return std::make_unique<Hop>(context.parameters);
    }
};

} // namespace usar::sample

#include "sample_plugin.moc"
