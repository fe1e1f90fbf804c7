#include "tests/robots/drive_trial.h"

using namespace usar;
using namespace usar::tests;

class TestP2dxDrive : public QObject {
    Q_OBJECT

private slots:
    void exploresWithoutATouchOrATrap_data() {
        QTest::addColumn<int>("where");
        QTest::addColumn<QByteArray>("behavior");
        for (const char* behavior : {"p2dx/cpp", "p2dx/posh"}) {
            QTest::addRow("%s in the room", behavior) << int(DriveWorld::Room) << QByteArray(behavior);
            QTest::addRow("%s on the meadow", behavior) << int(DriveWorld::Meadow) << QByteArray(behavior);
        }
    }
    void exploresWithoutATouchOrATrap() {
        QFETCH(int, where);
        QFETCH(QByteArray, behavior);
        tryDrive(static_cast<DriveWorld>(where), behavior.toStdString(), 1, Seconds(300.0));
    }
};

QTEST_APPLESS_MAIN(TestP2dxDrive)
#include "tst_p2dx_drive.moc"
