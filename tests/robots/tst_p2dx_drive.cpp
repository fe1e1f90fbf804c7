#include "tests/robots/drive_trial.h"
#include "tests/suite/suite.h"

namespace tst_p2dx_drive {

using namespace usar;
using namespace usar::test;

class tst_P2dxDrive : public QObject {
    Q_OBJECT

private slots:
    void exploresWithoutATouchOrATrap_data() {
        QTest::addColumn<int>("where");
        QTest::addColumn<QByteArray>("behavior");
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("duration_s");
        for (const char* behavior : {"p2dx/cpp", "p2dx/posh"}) {
            QTest::addRow("%s in the room", behavior) << int(DriveWorld::Room) << QByteArray(behavior) << 1 << 300.0;
            QTest::addRow("%s between shelves", behavior)
                << int(DriveWorld::Room) << QByteArray(behavior) << 5 << 300.0;
            QTest::addRow("%s on the meadow", behavior)
                << int(DriveWorld::Meadow) << QByteArray(behavior) << 1 << 600.0;
        }
    }
    void exploresWithoutATouchOrATrap() {
        QFETCH(int, where);
        QFETCH(QByteArray, behavior);
        QFETCH(int, seed);
        QFETCH(double, duration_s);
        tryDrive(static_cast<DriveWorld>(where), behavior.toStdString(), static_cast<std::uint64_t>(seed),
                 Seconds(duration_s));
    }
};

USAR_TEST(tst_P2dxDrive)

} // namespace tst_p2dx_drive

#include "tst_p2dx_drive.moc"
