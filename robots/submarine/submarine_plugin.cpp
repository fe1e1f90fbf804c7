// The entry point of the Submarine plugin.
#include <QObject>

#include "robots/submarine/descriptions.h"

namespace usar::submarine {

class SubmarinePlugin : public QObject, public SubmarineRobot {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "submarine.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

} // namespace usar::submarine

#include "submarine_plugin.moc"
