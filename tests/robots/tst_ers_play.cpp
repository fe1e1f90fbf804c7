#include "tests/robots/play_trial.h"
#include "tests/suite/suite.h"

namespace tst_ers_play {

using namespace usar;
using namespace usar::test;

class tst_ErsPlay : public QObject {
    Q_OBJECT

private slots:
    void findsTheBallAndKicksItWithoutAFall_data() {
        QTest::addColumn<int>("seed");
        QTest::newRow("facing it") << 1;
        QTest::newRow("from the other side") << 2;
        QTest::newRow("beside it, on the left") << 3;
        QTest::newRow("beside it, on the right") << 4;
    }
    void findsTheBallAndKicksItWithoutAFall() {
        QFETCH(int, seed);
        const Play played = play(static_cast<std::uint64_t>(seed), Seconds(150.0));
        QVERIFY(played.ending && played.ending->success);
        QVERIFY(played.truth.first_touch.has_value());
        QVERIFY(played.truth.touches > 1);
        QCOMPARE(played.truth.falls, 0);
        QVERIFY(played.worst_tilt_rad < radians(30.0));
        QVERIFY(played.events.empty());
    }
};

USAR_TEST(tst_ErsPlay)

} // namespace tst_ers_play

#include "tst_ers_play.moc"
