// The entry point of the AirRobot plugin.
#include <QObject>

#include "robots/airrobot/descriptions.h"

namespace usar::airrobot {

class AirRobotPlugin : public QObject, public AirRobot {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "airrobot.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

} // namespace usar::airrobot

#include "airrobot_plugin.moc"
