// The instruments of each kind of robot: those that it can have, and no others.
#include <QTest>

#include "tests/e2e/drive_page.h"
#include "tests/suite/suite.h"

namespace tst_window_instruments {

using namespace usar;

class tst_WindowInstruments : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatTheRobotCanHaveIsShown_data();
    void onlyWhatTheRobotCanHaveIsShown();
};

void tst_WindowInstruments::onlyWhatTheRobotCanHaveIsShown_data() {
    QTest::addColumn<QString>("robot_class");
    QTest::addColumn<bool>("scans");
    QTest::addColumn<bool>("flies");
    QTest::addColumn<bool>("sonars");
    QTest::addColumn<QString>("way");
    QTest::newRow("AirRobot") << "AirRobot" << true << true << true << "flown";
    QTest::newRow("P2DX") << "P2DX" << true << false << true << "driven";
    QTest::newRow("submarine") << "Submarine" << false << false << false << "traveled";
    QTest::newRow("ERS") << "ERS" << false << false << false << "walked";
}

void tst_WindowInstruments::onlyWhatTheRobotCanHaveIsShown() {
    QFETCH(QString, robot_class);
    QFETCH(bool, scans);
    QFETCH(bool, flies);
    QFETCH(bool, sonars);
    QFETCH(QString, way);
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const widgets::WindowViews& views = page.window().views();
    QVERIFY(views.laser->isHidden() && views.instruments->emptyWords().contains("No robot"));
    QVERIFY(page.spawnClass(robot_class));
    QVERIFY(page.clockGoesOn(Seconds(1.5)));
    QTRY_COMPARE(!views.laser->isHidden(), scans);
    QTRY_COMPARE(!views.terrain->isHidden(), flies);
    QTRY_VERIFY(!views.instruments->attitude()->isHidden() && views.instruments->emptyWords().isEmpty());
    QTRY_COMPARE(!views.instruments->ring()->isHidden(), sonars); // The window has asked where they are.
    QTRY_COMPARE(views.instruments->figures().contains("to bottom"), robot_class == "Submarine");
    QTRY_COMPARE(views.instruments->figures().contains("over ground"), flies);
    QStringList readouts;
    for (const widgets::Readout* readout : views.status->findChildren<widgets::Readout*>())
        readouts << readout->accessibleName();
    QVERIFY2(readouts.contains(way), qPrintable(readouts.join(", ")));
    for (const widgets::Readout* readout : views.status->findChildren<widgets::Readout*>())
        if (readout->accessibleName() == "charges")
            QCOMPARE(!readout->isHidden(), flies);
    for (const QPushButton* button : views.behavior->findChildren<QPushButton*>())
        if (button->text() == "Land now")
            QCOMPARE(!button->isHidden(), flies);
    QCOMPARE(page.window().commands().action("mission.land")->isVisible(), flies);
}

USAR_TEST(tst_WindowInstruments)

} // namespace tst_window_instruments

#include "tst_window_instruments.moc"
