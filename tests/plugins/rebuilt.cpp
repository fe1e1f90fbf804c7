// What an author makes of good.cpp: the same behavior, and another name to be known by.
#include "tests/plugins/minimal_plugin.h"

class RebuiltPlugin : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    usar::agent::RobotDescription description() const override {
        usar::agent::RobotDescription description = MinimalPlugin::description();
        description.name = "Rebuilt robot";
        return description;
    }
};

#include "rebuilt.moc"
