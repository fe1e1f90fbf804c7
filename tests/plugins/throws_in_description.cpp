#include <stdexcept>

#include "tests/plugins/minimal_plugin.h"

class ThrowsInDescription : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    usar::agent::RobotDescription description() const override { throw std::runtime_error("no idea who I am"); }
};

#include "throws_in_description.moc"
