#include "tests/robots/drive_trial.h"
#include "tests/suite/suite.h"

namespace tst_p2dx_campaign {

using namespace usar;
using namespace usar::test;

class tst_P2dxCampaign : public QObject {
    Q_OBJECT

private slots:
    void exploresForAnHour_data() {
        QTest::addColumn<int>("where");
        QTest::addColumn<QByteArray>("behavior");
        QTest::addColumn<int>("seed");
        for (const char* behavior : {"p2dx/cpp", "p2dx/posh"})
            for (int seed = 1; seed <= 10; ++seed) {
                QTest::addRow("%s in the room, seed %d", behavior, seed)
                    << int(DriveWorld::Room) << QByteArray(behavior) << seed;
                QTest::addRow("%s on the meadow, seed %d", behavior, seed)
                    << int(DriveWorld::Meadow) << QByteArray(behavior) << seed;
            }
    }
    void exploresForAnHour() {
        QFETCH(int, where);
        QFETCH(QByteArray, behavior);
        QFETCH(int, seed);
        tryDrive(static_cast<DriveWorld>(where), behavior.toStdString(), static_cast<std::uint64_t>(seed),
                 Seconds(3600.0));
    }
};

USAR_TEST(tst_P2dxCampaign)

} // namespace tst_p2dx_campaign

#include "tst_p2dx_campaign.moc"
