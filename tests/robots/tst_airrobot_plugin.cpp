#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/plugins/plugin_loader.h"
#include "tests/suite/suite.h"

namespace tst_airrobot_plugin {

using namespace usar;
using namespace usar::agent;

class tst_AirRobotPlugin : public QObject {
    Q_OBJECT

private slots:
    void isLoadedByTheProgramsOwnLoader() {
        PluginLoader loader;
        loader.scan({QString(USAR_BINARY_DIR) + "/robots"});
        for (const PluginRecord& record : loader.records())
            QVERIFY2(record.state == PluginState::Loaded, qPrintable(record.reason));
        const auto plugin = loader.pluginFor("airrobot/cpp");
        QVERIFY2(plugin, plugin ? "" : plugin.error().text().c_str());
        const BehaviorDescription* behavior = loader.behavior("airrobot/cpp");
        QVERIFY(behavior->needs_area);
        QVERIFY(behavior->parameters.size() > 40);
    }

    void makesABehaviorThatIsSafeAtOnce() {
        PluginLoader loader;
        loader.scan({QString(USAR_BINARY_DIR) + "/robots"});
        const auto plugin = loader.pluginFor("airrobot/cpp");
        QVERIFY(plugin);
        const auto parameters = ParameterSet::make(loader.behavior("airrobot/cpp")->parameters);
        QVERIFY(parameters);
        const auto behavior = (*plugin)->createBehavior("airrobot/cpp", {{}, *parameters});
        QVERIFY(behavior);
        QVERIFY((*behavior)->safeCommand() == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        const auto other = (*plugin)->createBehavior("airrobot/dance", {{}, *parameters});
        QVERIFY(!other);
        QVERIFY(other.error().text().find("airrobot/cpp") != std::string::npos);
    }
};

USAR_TEST(tst_AirRobotPlugin)

} // namespace tst_airrobot_plugin

#include "tst_airrobot_plugin.moc"
