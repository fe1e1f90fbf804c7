#include <stdexcept>

#include "tests/plugins/minimal_plugin.h"

class ThrowsWhenMade : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    ThrowsWhenMade() { throw std::runtime_error("not today"); }
};

#include "throws_when_made.moc"
