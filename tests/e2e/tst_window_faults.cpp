// Faults from the dock and from a mission file, in the real window against the real simulator.
#include <QTest>
#include <QTreeWidget>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/quantity_box.h"

namespace tst_window_faults {

using namespace usar;

namespace {

/// The dock, driven as a person does it.
class FaultDock {
public:
    explicit FaultDock(WindowPage& page) : page_(page), panel_(page.window().views().faults) {}

    void open() {
        page_.window().commands().action("view.dock.faults")->trigger();
        QVERIFY(QTest::qWaitFor([&] { return panel_->isVisible(); }));
    }
    void chooseKind(const QString& title) {
        auto* kind = panel_->findChild<QComboBox*>();
        const int wanted = kind->findText(title);
        while (kind->currentIndex() != wanted)
            QTest::keyClick(kind, kind->currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
        QCOMPARE(kind->currentText(), title);
    }
    QTreeWidget* list() { return panel_->findChild<QTreeWidget*>(); }
    QStringList states() {
        QStringList states;
        for (int row = 0; row < list()->topLevelItemCount(); ++row)
            states << list()->topLevelItem(row)->text(0) + ": " + list()->topLevelItem(row)->text(1);
        return states;
    }
    void select(int row) {
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {},
                          list()->visualItemRect(list()->topLevelItem(row)).center());
    }

private:
    WindowPage& page_;
    widgets::FaultPanel* panel_;
};

/// As the sensor panel shows it.
QString shownValue(WindowPage& page, const QString& name) {
    const widgets::SensorModel& model = page.window().views().sensors->model();
    for (int row = 0; row < model.rowCount(); ++row) {
        const QModelIndex stream = model.index(row, 0);
        for (int leaf = 0; leaf < model.rowCount(stream); ++leaf)
            if (model.index(leaf, widgets::SensorModel::Name, stream).data().toString().contains(name))
                return model.index(leaf, widgets::SensorModel::Value, stream).data().toString();
    }
    return {};
}

} // namespace

class tst_WindowFaults : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aFaultIsInjectedSeenAndEnded();
    void theFaultsOfAMissionBeginWithIt();
    void aWrongFaultInAMissionFileIsNamedWithItsPlace();
};

void tst_WindowFaults::aFaultIsInjectedSeenAndEnded() {
    WindowPage page;
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    FaultDock dock(page);
    dock.open();
    dock.chooseKind("Wind");
    page.press("Inject fault");
    QTRY_COMPARE_WITH_TIMEOUT(dock.states(), QStringList{"wind: active"}, soon_ms);
    QVERIFY(!page.notified("fault begins: wind").isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(shownValue(page, "battery").toDouble() > 1000.0, soon_ms);
    dock.chooseKind("Battery");
    page.press("Inject fault");
    QTRY_COMPARE_WITH_TIMEOUT(shownValue(page, "battery").toDouble(), 0.0, soon_ms);
    QCOMPARE(dock.states(), (QStringList{"battery: active", "wind: active"}));
    dock.select(1);
    page.press("End fault");
    QTRY_COMPARE_WITH_TIMEOUT(dock.states(), (QStringList{"battery: active", "wind: over"}), soon_ms);
    QVERIFY(!page.notified("fault ends: wind").isEmpty());
    page.window().commands().action("faults.end_all")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(dock.states(), (QStringList{"battery: over", "wind: over"}), soon_ms);
    page.screenshot("faults");
}

void tst_WindowFaults::theFaultsOfAMissionBeginWithIt() {
    QTemporaryDir folder;
    QFile json(folder.filePath("mission.json"));
    QVERIFY(json.open(QIODevice::WriteOnly));
    json.write(R"({"name": "windy", "area": {"x": -10, "y": -8, "width": 20, "height": 16},
                   "faults": ["wind speed=1 from=2", "sensor_dropout sensor=INS share=0.1 from=3000"]})");
    json.close();
    WindowPage page({.mission_file = json.fileName()});
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    FaultDock dock(page);
    dock.open();
    QVERIFY(dock.states().isEmpty());
    page.window().commands().action("mission.start")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(
        dock.states(), (QStringList{"sensor_dropout sensor=INS share=0.1: to come", "wind speed=1: active"}), soon_ms);
    page.window().commands().action("mission.stop")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.window().commands().action("mission.start")->isEnabled(), soon_ms);
    page.window().commands().action("mission.start")->trigger(); // once more: not two winds at once
    QTRY_COMPARE_WITH_TIMEOUT(dock.states().filter("wind speed=1: active").size() +
                                  10 * dock.states().filter("wind speed=1: over").size(),
                              11, soon_ms);
}

void tst_WindowFaults::aWrongFaultInAMissionFileIsNamedWithItsPlace() {
    QTemporaryDir folder;
    QFile json(folder.filePath("mission.json"));
    QVERIFY(json.open(QIODevice::WriteOnly));
    json.write(
        "{\"name\": \"x\", \"area\": {\"x\": 0, \"y\": 0, \"width\": 5, \"height\": 5},\n\"faults\": [\"wnd\"]}");
    json.close();
    WindowPage page({.mission_file = json.fileName()});
    const auto told = [&] { return page.notified("mission.json:2:11: fault \"wnd\": unknown kind 'wnd'"); };
    QTRY_VERIFY_WITH_TIMEOUT(told().contains("Did you mean 'wind'"), soon_ms);
}

USAR_TEST(tst_WindowFaults)

} // namespace tst_window_faults

#include "tst_window_faults.moc"
