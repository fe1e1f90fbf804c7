// From the robot's clock to the moment of a recording: pauses, slow stretches, clocks that start again.
#include <limits>

#include <QTest>

#include "core/link/play_clock.h"
#include "tests/suite/suite.h"

namespace tst_clock_table {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

struct Said {
    RecordTime play;
    double now_s;
};
using Saying = std::vector<Said>;

ClockTable tableOf(const Saying& saying) {
    ClockTable table;
    for (const Said& said : saying)
        table.add(said.play, Seconds(said.now_s));
    return table;
}

} // namespace

class tst_ClockTable : public QObject {
    Q_OBJECT
private slots:
    void theClocksMomentsAreFoundInTheRecording_data();
    void theClocksMomentsAreFoundInTheRecording();
    void whatNoClockSaysIsPassedOver();
};

void tst_ClockTable::theClocksMomentsAreFoundInTheRecording_data() {
    QTest::addColumn<Saying>("saying");
    QTest::addColumn<double>("now_s");
    QTest::addColumn<double>("play_s");
    const Saying steady{{1s, 50.0}, {2s, 51.0}, {3s, 52.0}};
    QTest::newRow("steady") << steady << 51.0 << 2.0;
    QTest::newRow("between two words") << steady << 51.5 << 2.5;
    QTest::newRow("the first word") << steady << 50.0 << 1.0;
    QTest::newRow("before it") << steady << 3.0 << 1.0;
    QTest::newRow("after the last") << steady << 99.0 << 3.0;
    const Saying halted{{1s, 50.0}, {2s, 51.0}, {32s, 51.2}, {33s, 52.2}};
    QTest::newRow("before a halt") << halted << 51.0 << 2.0;
    QTest::newRow("a moment into a halt") << halted << 51.02 << 2.02;
    QTest::newRow("after a halt") << halted << 52.0 << 32.8;
    const Saying slow{{1s, 50.0}, {2s, 50.5}, {3s, 51.0}, {4s, 51.5}};
    QTest::newRow("at half the pace") << slow << 51.0 << 3.0;
    QTest::newRow("at half the pace, between two words") << slow << 51.2 << 3.2;
    const Saying restarted{{1s, 50.0}, {2s, 51.0}, {5s, 0.5}, {6s, 1.5}, {55s, 50.5}};
    QTest::newRow("a clock that started again") << restarted << 1.0 << 5.5;
    QTest::newRow("said by both, the later one") << restarted << 50.5 << 55.0;
    QTest::newRow("said by the first one alone") << restarted << 50.9 << 2.0 - 0.1;
}

void tst_ClockTable::theClocksMomentsAreFoundInTheRecording() {
    QFETCH(Saying, saying);
    QFETCH(double, now_s);
    QFETCH(double, play_s);
    const auto play = tableOf(saying).at(Seconds(now_s));
    QVERIFY(play.has_value());
    QVERIFY2(std::abs(Seconds(*play).count() - play_s) < 1e-6, qPrintable(QString::number(Seconds(*play).count())));
}

void tst_ClockTable::whatNoClockSaysIsPassedOver() {
    QVERIFY(!ClockTable().at(Seconds(1.0)));
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!tableOf({{1s, none}, {2s, infinite}, {3s, -1e300}}).at(Seconds(1.0)));
    const ClockTable table = tableOf({{1s, 50.0}, {2s, none}, {3s, 1e300}, {4s, 53.0}});
    QCOMPARE(table.at(Seconds(52.0)), std::optional<RecordTime>(3s));
}

USAR_TEST(tst_ClockTable)

} // namespace tst_clock_table

#include "tst_clock_table.moc"
