#include "tests/plugins/minimal_plugin.h"

class MissingMetadata : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "no_behaviors.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

#include "missing_metadata.moc"
