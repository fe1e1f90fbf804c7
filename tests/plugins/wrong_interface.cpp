#include "tests/plugins/minimal_plugin.h"

class WrongInterface : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.example.ImageFilter/1" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
};

#include "wrong_interface.moc"
