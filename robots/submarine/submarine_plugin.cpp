// The entry point of the Submarine plugin.
#include <QObject>

#include "robots/submarine/descriptions.h"

namespace usar::submarine {

class SubmarinePlugin : public QObject, public agent::RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/4" FILE "submarine.json")
    Q_INTERFACES(usar::agent::RobotPlugin)

public:
    agent::RobotDescription description() const override { return describeSubmarine(); }
    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext context) const override {
        return makeBehavior(id, std::move(context));
    }
};

} // namespace usar::submarine

#include "submarine_plugin.moc"
