#include "tests/plugins/minimal_plugin.h"

usar::agent::RobotDescription neverDefined();

class Unresolved : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    usar::agent::RobotDescription description() const override { return neverDefined(); }
};

#include "unresolved.moc"
