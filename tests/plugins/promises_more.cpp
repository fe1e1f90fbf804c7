#include "tests/plugins/minimal_plugin.h"

class PromisesMore : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "promises_more.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

#include "promises_more.moc"
