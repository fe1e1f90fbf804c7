// How soon a robot that is driven by hand is told to stop, in wall-clock time.
#include <QElapsedTimer>
#include <QTest>

#include "tests/mission/session/held_robot.h"
#include "tests/suite/suite.h"

namespace tst_hand_timing {

using namespace usar;
using namespace usar::mission;
using namespace usar::test;

class tst_HandTiming : public QObject {
    Q_OBJECT
private slots:
    void lettingGoStopsWithin50Ms() {
        HeldRobot f;
        QVERIFY(f.ready);
        QElapsedTimer since;
        since.start();
        f.session.drive(holding(HandSource::Keys, {}));
        QTRY_VERIFY(stopped(f));
        QVERIFY2(since.elapsed() < 50, qPrintable(QString::number(since.elapsed())));
    }

    void aHandThatSaysNothingIsTakenForDeadWithin600Ms() {
        HeldRobot f;
        QVERIFY(f.ready);
        QElapsedTimer since;
        since.start();
        QTRY_VERIFY(stopped(f));
        QVERIFY2(since.elapsed() < 600, qPrintable(QString::number(since.elapsed())));
    }
};

USAR_TEST(tst_HandTiming)

} // namespace tst_hand_timing

#include "tst_hand_timing.moc"
