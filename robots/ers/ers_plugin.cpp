// The entry point of the ERS plugin.
#include <QObject>

#include "robots/ers/descriptions.h"

namespace usar::ers {

class ErsPlugin : public QObject, public ErsRobot {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "ers.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

} // namespace usar::ers

#include "ers_plugin.moc"
