// The entry point of the AirRobot plugin.
#include <QObject>

#include "robots/airrobot/descriptions.h"

namespace usar::airrobot {

class AirRobotPlugin : public QObject, public agent::RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/4" FILE "airrobot.json")
    Q_INTERFACES(usar::agent::RobotPlugin)

public:
    agent::RobotDescription description() const override { return describeAirRobot(); }
    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext context) const override {
        return makeBehavior(id, std::move(context));
    }
    Result<agent::TaskPreview> preview(const std::string&, const agent::BehaviorContext& context) const override {
        return previewSurvey(context);
    }
};

} // namespace usar::airrobot

#include "airrobot_plugin.moc"
