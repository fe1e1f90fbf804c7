#include "tests/plugins/minimal_plugin.h"

class TwinPlugin : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

#include "twin.moc"
