#include <stdexcept>

#include <QTest>

#include "core/agent/behavior_start.h"
#include "tests/plugins/minimal_plugin.h"
#include "tests/suite/suite.h"

namespace tst_guarded_plugin {

using namespace usar;
using namespace usar::agent;

namespace {

enum class Fault { None, Exception, Number, Nothing };

/// Fails in the way it was told to.
class FaultyPlugin : public test::MinimalPlugin {
public:
    explicit FaultyPlugin(Fault fault) : fault_(fault) {}

    Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const override {
        fail();
        if (fault_ == Fault::Nothing)
            return std::unique_ptr<Behavior>();
        return MinimalPlugin::createBehavior(id, std::move(context));
    }
    Result<TaskPreview> preview(const std::string& id, const BehaviorContext& context) const override {
        fail();
        return MinimalPlugin::preview(id, context);
    }

private:
    void fail() const {
        if (fault_ == Fault::Exception)
            throw std::runtime_error("no geometry");
        if (fault_ == Fault::Number)
            throw 7;
    }
    Fault fault_;
};

} // namespace

class tst_GuardedPlugin : public QObject {
    Q_OBJECT
private slots:
    void aGoodPluginIsHeard();
    void whatAPluginThrowsIsAnErrorWithAMend();
    void aThrownThingOfAnyKindIsCaught();
    void aMissingBehaviorIsAnError();
};

void tst_GuardedPlugin::aGoodPluginIsHeard() {
    const FaultyPlugin plugin(Fault::None);
    QVERIFY(makeBehavior(plugin, "test/idle", {}));
    QVERIFY(previewTask(plugin, "test/idle", {}));
    const auto refused = makeBehavior(plugin, "test/other", {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().what, std::string("no such behavior"));
}

void tst_GuardedPlugin::whatAPluginThrowsIsAnErrorWithAMend() {
    const FaultyPlugin plugin(Fault::Exception);
    const auto made = makeBehavior(plugin, "test/idle", {});
    const auto preview = previewTask(plugin, "test/idle", {});
    QVERIFY(!made && !preview);
    QCOMPARE(made.error(), preview.error());
    QCOMPARE(QString::fromStdString(made.error().text()),
             QString("behavior test/idle: its plugin threw: no geometry. Choose another behavior, or fix its plugin."));
}

void tst_GuardedPlugin::aThrownThingOfAnyKindIsCaught() {
    const FaultyPlugin plugin(Fault::Number);
    QVERIFY(!makeBehavior(plugin, "test/idle", {}));
    QVERIFY(!previewTask(plugin, "test/idle", {}));
}

void tst_GuardedPlugin::aMissingBehaviorIsAnError() {
    QVERIFY(!makeBehavior(FaultyPlugin(Fault::Nothing), "test/idle", {}));
}

USAR_TEST(tst_GuardedPlugin)

} // namespace tst_guarded_plugin

#include "tst_guarded_plugin.moc"
