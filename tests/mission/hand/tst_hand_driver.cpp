// Holds by hand, by a clock of the test.
#include <QTest>

#include "core/mission/hand/hand_driver.h"
#include "tests/suite/suite.h"

namespace tst_hand_driver {

using namespace usar;
using namespace usar::mission;
using Change = HandDriver::Change;

namespace {

HandIntent forward(double share, HandSource source = HandSource::Keys) {
    return {.source = source, .stick = {.forward = share}};
}

/// An AirRobot that the user has taken.
struct Held {
    Held() {
        protocol::RobotState state;
        state.kind = protocol::VehicleKind::Aerial;
        hand.take({{1}, "STA", state, {}});
        hand.setOn(true);
    }
    std::optional<std::string> reason(Seconds wall, std::optional<Seconds> silent = std::nullopt) const {
        return hand.reasonToStop(wall, Seconds{0.3}, silent, "R1");
    }
    HandDriver hand;
};

} // namespace

class tst_HandDriver : public QObject {
    Q_OBJECT
private slots:
    void aHoldBeginsAndEndsWithTheDevice() {
        Held held;
        QCOMPARE(held.hand.accept(forward(0.0), Seconds{0.0}), Change::None);
        QCOMPARE(held.hand.accept(forward(1.0), Seconds{0.1}), Change::Begins);
        QCOMPARE(held.hand.accept(forward(0.5), Seconds{0.2}), Change::None);
        QCOMPARE(held.hand.accept(forward(1.0, HandSource::Pad), Seconds{0.3}), Change::None);
        QCOMPARE(held.hand.accept(forward(0.0), Seconds{0.4}), Change::Ends);
    }

    void aSilentDeviceCountsAsReleased() {
        Held held;
        held.hand.accept(forward(1.0), Seconds{10.0});
        QVERIFY(!held.reason(Seconds{10.2}));
        QCOMPARE(held.reason(Seconds{10.4}), std::optional<std::string>("nothing was heard from the input device"));
    }

    void aSilentRobotIsStopped() {
        Held held;
        held.hand.accept(forward(1.0), Seconds{10.0});
        QVERIFY(!held.reason(Seconds{10.1}, Seconds{0.9}));
        QCOMPARE(held.reason(Seconds{10.1}, Seconds{1.1}), std::optional<std::string>("R1 is silent"));
    }

    void slowTimeIsNoSilence() {
        Held held;
        held.hand.tick(Seconds{8.0});
        held.hand.tick(Seconds{9.0}); // a second of wall time between two STA
        held.hand.accept(forward(1.0), Seconds{10.0});
        QVERIFY(!held.reason(Seconds{10.1}, Seconds{3.9}));
        QVERIFY(held.reason(Seconds{10.1}, Seconds{4.1}));
        held.hand.tick(Seconds{99.0}); // a pause is no pace
        QVERIFY(held.reason(Seconds{10.1}, Seconds{12.1}));
    }

    void commandsNameTheDevice() {
        Held held;
        held.hand.accept({.source = HandSource::Gamepad, .device = "Pad 3", .stick = {.forward = 1.0}}, Seconds{0.0});
        const HandCommands first = held.hand.advance();
        QCOMPARE(first.commands.size(), std::size_t(1));
        QCOMPARE(toText(first.source), std::string("by hand: gamepad Pad 3"));
        QCOMPARE(held.hand.repeat(Seconds{1.0}).commands.size(), std::size_t(1));
        const HandCommands rest = held.hand.stop("stopped by the operator");
        QCOMPARE(rest.commands.size(), std::size_t(1));
        QCOMPARE(toText(rest.source), std::string("by hand: stop, stopped by the operator"));
        QVERIFY(!held.hand.holding() && held.hand.on());
        QVERIFY(held.hand.advance().commands.empty());
    }

    void theRobotIsAskedOnlyUnderControl() {
        Held held;
        const HandCommands question = held.hand.question(Seconds{1.0});
        QCOMPARE(question.commands.size(), std::size_t(1));
        QCOMPARE(toText(question.source), std::string("by hand: how it is driven"));
        held.hand.setOn(false);
        QVERIFY(held.hand.question(Seconds{60.0}).commands.empty());
    }

    void lettingGoIsSaidInWords() {
        QCOMPARE(lettingGo(HandSource::Keys), std::string("the keys were let go"));
        QCOMPARE(lettingGo(HandSource::Pad), std::string("the pad was let go"));
    }
};

USAR_TEST(tst_HandDriver)

} // namespace tst_hand_driver

#include "tst_hand_driver.moc"
