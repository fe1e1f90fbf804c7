// The entry point of the P2DX plugin.
#include <QObject>

#include "robots/p2dx/descriptions.h"

namespace usar::p2dx {

class P2dxPlugin : public QObject, public P2dxRobot {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "p2dx.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

} // namespace usar::p2dx

#include "p2dx_plugin.moc"
