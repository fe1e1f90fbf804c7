#include "tests/plugins/minimal_plugin.h"

class BadPreset : public QObject, public usar::test::MinimalPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "good.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    usar::agent::RobotDescription description() const override {
        usar::agent::RobotDescription description = usar::test::minimalDescription();
        description.behaviors[0].presets = {{"quick", "Quick", "As fast as it goes.", {{"speed_m_s", 9.0}}}};
        return description;
    }
};

#include "bad_preset.moc"
