// The entry point of the P2DX plugin.
#include <QObject>

#include "robots/p2dx/descriptions.h"

namespace usar::p2dx {

class P2dxPlugin : public QObject, public agent::RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/4" FILE "p2dx.json")
    Q_INTERFACES(usar::agent::RobotPlugin)

public:
    agent::RobotDescription description() const override { return describeP2dx(); }
    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext context) const override {
        return makeBehavior(id, std::move(context));
    }
};

} // namespace usar::p2dx

#include "p2dx_plugin.moc"
