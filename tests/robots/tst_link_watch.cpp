#include <cmath>
#include <vector>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/link_watch.h"
#include "tests/suite/suite.h"

namespace tst_link_watch {

using namespace usar;
using namespace usar::airrobot;

namespace {

/// A robot that obeys like one: with a velocity that approaches the commanded one, and `late_s` after it was told.
struct ToyLink {
    explicit ToyLink(double late_s) : delay(static_cast<std::size_t>(std::lround(late_s / 0.2))) {}

    /// Flies for a while as `told` says at each time.
    template <class Told>
    void run(double time_s, Told told, bool free = true) {
        for (int tick = 0; tick < std::lround(time_s / 0.2); ++tick) {
            now_s += 0.2;
            commands.push_back(told(now_s));
            const std::size_t back = delay + 1;
            const LinkWatch::Motion obeyed =
                commands.size() > back ? commands[commands.size() - 1 - back] : LinkWatch::Motion{};
            motion.velocity_m_s += 0.35 * (obeyed.velocity_m_s - motion.velocity_m_s);
            motion.yaw_rate_rad_s += 0.35 * (obeyed.yaw_rate_rad_s - motion.yaw_rate_rad_s);
            LinkWatch::Motion measured = motion;
            measured.velocity_m_s += wind_m_s;
            watch.note(Seconds(now_s), commands.back(), measured, free);
        }
    }

    LinkWatch watch;
    std::size_t delay;
    double now_s = 0.0;
    Vec3 wind_m_s = Vec3::Zero();
    LinkWatch::Motion motion;
    std::vector<LinkWatch::Motion> commands;
};

/// Turns and stops, as on lanes.
LinkWatch::Motion alongLanes(double now_s) {
    const double part = std::fmod(now_s, 9.0);
    return {Vec3(part < 6.0 ? 1.0 : 0.0, 0.0, part < 1.0 ? 0.5 : 0.0), part > 7.0 ? 0.5 : 0.0};
}

} // namespace

class tst_LinkWatch : public QObject {
    Q_OBJECT

    static LinkWatch::Motion climbing(double climb_m_s) { return {Vec3(0.0, 0.0, climb_m_s), 0.0}; }

private slots:
    /// It looked for ceilings, swung from side to side and broke before it had flown enough (random survey 63030).
    void feelsALateLinkAsItLeavesTheGround_data() {
        QTest::addColumn<double>("lifts_after_s");
        QTest::addColumn<double>("late_s");
        QTest::newRow("usual link") << 0.8 << 0.0;
        QTest::newRow("a tick more") << 1.0 << 0.0;
        QTest::newRow("late link") << 2.8 << 2.0;
    }
    void feelsALateLinkAsItLeavesTheGround() {
        QFETCH(double, lifts_after_s);
        QFETCH(double, late_s);
        LinkWatch watch;
        for (int tick = 0; tick < 10; ++tick)
            watch.note(Seconds(0.2 * tick), {}, {}, false);
        for (int tick = 0; tick < 30; ++tick) {
            const double since_s = 0.2 * tick;
            watch.note(Seconds(2.0 + since_s), climbing(1.0), climbing(since_s > lifts_after_s - 0.1 ? 0.3 : 0.0),
                       false);
        }
        QVERIFY2(std::abs(watch.late().count() - late_s) < 0.01, qPrintable(QString::number(watch.late().count())));
    }

    void measuresHowLateTheRobotObeys_data() {
        QTest::addColumn<double>("late_s");
        QTest::addColumn<double>("told_s");
        QTest::newRow("not late") << 0.0 << 0.0;
        QTest::newRow("not surely late") << 0.2 << 0.0;
        QTest::newRow("somewhat late") << 0.8 << 0.8;
        QTest::newRow("late") << 1.6 << 1.6;
        QTest::newRow("very late") << 3.0 << 3.0;
    }
    void measuresHowLateTheRobotObeys() {
        QFETCH(double, late_s);
        QFETCH(double, told_s);
        for (const Vec3& wind_m_s : {Vec3(0.0, 0.0, 0.0), Vec3(-1.0, 2.0, 0.0)}) {
            ToyLink link(late_s);
            link.wind_m_s = wind_m_s;
            link.run(40.0, alongLanes);
            QVERIFY2(std::abs(link.watch.late().count() - told_s) < 0.21,
                     qPrintable(QString::number(link.watch.late().count())));
        }
    }

    void doesNotGuess_data() {
        QTest::addColumn<bool>("moves");
        QTest::addColumn<bool>("free");
        QTest::newRow("hovering") << false << true;
        QTest::newRow("on the ground") << true << false;
    }
    void doesNotGuess() {
        QFETCH(bool, moves);
        QFETCH(bool, free);
        ToyLink link(1.6);
        link.run(
            40.0, [moves](double now_s) { return moves ? alongLanes(now_s) : LinkWatch::Motion{}; }, free);
        QCOMPARE(link.watch.late(), Seconds{0.0});
    }

    void aRobotThatDoesNotObeyAtAllIsNotLate() {
        LinkWatch watch;
        for (int tick = 0; tick < 200; ++tick) {
            const double now_s = 0.2 * tick;
            watch.note(Seconds(now_s), alongLanes(now_s), {Vec3(0.0, std::sin(now_s), 0.0), 0.0}, true);
        }
        QCOMPARE(watch.late(), Seconds{0.0});
    }

    void noticesThatTheLinkIsQuickAgain() {
        ToyLink link(1.6);
        link.run(40.0, alongLanes);
        QVERIFY(link.watch.late() > Seconds{1.0});
        link.delay = 0;
        link.run(40.0, alongLanes);
        QCOMPARE(link.watch.late(), Seconds{0.0});
    }
};

USAR_TEST(tst_LinkWatch)

} // namespace tst_link_watch

#include "tst_link_watch.moc"
