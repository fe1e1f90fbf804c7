// The entry point of the ERS plugin.
#include <QObject>

#include "robots/ers/descriptions.h"

namespace usar::ers {

class ErsPlugin : public QObject, public agent::RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/4" FILE "ers.json")
    Q_INTERFACES(usar::agent::RobotPlugin)

public:
    agent::RobotDescription description() const override { return describeErs(); }
    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext context) const override {
        return makeBehavior(id, std::move(context));
    }
};

} // namespace usar::ers

#include "ers_plugin.moc"
