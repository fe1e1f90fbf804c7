// The time line of an exported recording.
#include <cmath>

#include <QTest>

#include "core/mission/runs/export_clock.h"
#include "tests/suite/suite.h"

namespace tst_export_clock {

using namespace usar;
using namespace usar::mission;

namespace {

/// A new connection among the readings.
constexpr double reconnect = -1.0;

using Readings = std::vector<double>;

std::uint64_t ns(double seconds) {
    return static_cast<std::uint64_t>(std::llround(seconds * 1e9));
}

} // namespace

class tst_ExportClock : public QObject {
    Q_OBJECT
private slots:
    void theLineNeverRunsBackward_data() {
        QTest::addColumn<Readings>("readings");
        QTest::addColumn<double>("now");
        QTest::newRow("before the first reading") << Readings{} << 5.0;
        QTest::newRow("it follows the clock") << Readings{5.2, 5.4} << 5.4;
        QTest::newRow("an older reading moves nothing") << Readings{6.0, 5.8} << 6.0;
        QTest::newRow("one leap is damage") << Readings{6.0, 4000.0, 6.2} << 6.2;
        QTest::newRow("a leap that goes on is believed") << Readings{6.0, 4000.0, 4000.2} << 4000.2;
        QTest::newRow("a clock that begins again goes on") << Readings{100.0, 100.0, 0.2, 0.4} << 100.0;
        QTest::newRow("and moves from there") << Readings{100.0, 100.0, 0.2, 0.4, 1.4} << 101.0;
        QTest::newRow("the same clock after a reconnection") << Readings{6.0, reconnect, 7.0} << 7.0;
        QTest::newRow("another clock after a reconnection") << Readings{6.0, reconnect, 0.2, 1.2} << 7.0;
        Readings restarts;
        for (int i = 0; i < 20; ++i)
            restarts.insert(restarts.end(), {1e9, 1e9, 0.0, 0.0});
        QTest::newRow("it ends before its nanoseconds do") << restarts << 9e9;
        QTest::newRow("no number") << Readings{std::nan(""), 5.5, HUGE_VAL, -3.0} << 5.5;
    }

    void theLineNeverRunsBackward() {
        QFETCH(Readings, readings);
        QFETCH(double, now);
        ExportClock clock(Seconds{5.0});
        std::uint64_t last_ns = 0;
        for (const double reading : readings) {
            if (reading == reconnect)
                clock.beginConnection();
            else
                clock.take(Seconds{reading});
            QVERIFY(clock.timesOf({}).logged_ns >= last_ns);
            last_ns = clock.timesOf({}).logged_ns;
        }
        QCOMPARE(clock.timesOf({}).logged_ns, ns(now));
        QCOMPARE(clock.timesOf({}).published_ns, ns(now));
    }

    void aMessageHasItsOwnTimeIfThatCanBe_data() {
        QTest::addColumn<double>("own");
        QTest::addColumn<double>("published");
        QTest::newRow("a little earlier") << 99.5 << 99.5;
        QTest::newRow("an hour earlier") << 4.0 << 100.0;
        QTest::newRow("far ahead") << 1e300 << 100.0;
        QTest::newRow("no number") << std::nan("") << 100.0;
    }

    void aMessageHasItsOwnTimeIfThatCanBe() {
        QFETCH(double, own);
        QFETCH(double, published);
        const ExportClock clock(Seconds{100.0});
        QCOMPARE(clock.timesOf(Seconds{own}).logged_ns, ns(100.0));
        QCOMPARE(clock.timesOf(Seconds{own}).published_ns, ns(published));
    }
};

USAR_TEST(tst_ExportClock)

} // namespace tst_export_clock

#include "tst_export_clock.moc"
