#include "tests/plugins/minimal_plugin.h"

class NoInterface : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
};

#include "no_interface.moc"
