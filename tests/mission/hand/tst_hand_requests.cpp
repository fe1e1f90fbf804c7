// What a person asks for by hand, before any session hears of it.
#include <QTest>

#include "core/mission/hand/control_state.h"
#include "core/mission/hand/hand_requests.h"
#include "tests/suite/suite.h"

namespace tst_hand_requests {

using namespace usar;
using namespace usar::mission;

namespace {

const Stick forward{1.0, 0.0, 0.0, 0.0};

} // namespace

class tst_HandRequests : public QObject {
    Q_OBJECT
private slots:
    void controlIsTakenAndGivenBackOnce() {
        HandRequests requests;
        QVERIFY(!requests.giveBack());
        QVERIFY(requests.take(Seconds{1.0}));
        QVERIFY(!requests.take(Seconds{2.0}));
        QVERIFY(requests.taken());
        QVERIFY(requests.giveBack());
        QVERIFY(!requests.giveBack());
        QVERIFY(!requests.taken());
    }

    void theSessionHasTheLastWord_data() {
        QTest::addColumn<bool>("confirmed");
        QTest::addColumn<Reins>("reins");
        QTest::addColumn<double>("after_s");
        QTest::addColumn<bool>("ends");
        QTest::newRow("not confirmed yet") << false << Reins::Behavior << 0.9 << false;
        QTest::newRow("never confirmed") << false << Reins::Nobody << 1.1 << true;
        QTest::newRow("confirmed late") << false << Reins::Hand << 5.0 << false;
        QTest::newRow("still confirmed") << true << Reins::Hand << 60.0 << false;
        QTest::newRow("taken away at once") << true << Reins::Behavior << 0.1 << true;
        QTest::newRow("taken away later") << true << Reins::Nobody << 60.0 << true;
    }

    void theSessionHasTheLastWord() {
        QFETCH(bool, confirmed);
        QFETCH(Reins, reins);
        QFETCH(double, after_s);
        QFETCH(bool, ends);
        HandRequests requests;
        requests.take(Seconds{10.0});
        if (confirmed)
            QVERIFY(!requests.hear(Reins::Hand, Seconds{10.05}));
        QCOMPARE(requests.hear(reins, Seconds{10.0 + after_s}), ends);
        QCOMPARE(requests.taken(), !ends);
        QVERIFY(!requests.hear(Reins::Nobody, Seconds{10.0}) || !ends); // it ends once
    }

    void askingAgainIsWaitedForAgain() {
        HandRequests requests;
        requests.take(Seconds{0.0});
        requests.take(Seconds{0.8});
        QVERIFY(!requests.hear(Reins::Nobody, Seconds{1.5}));
        QVERIFY(requests.hear(Reins::Nobody, Seconds{1.9}));
    }

    void aConfirmationCountsForOneRequest() {
        HandRequests requests;
        requests.take(Seconds{0.0});
        QVERIFY(!requests.hear(Reins::Hand, Seconds{0.1}));
        requests.giveBack();
        QVERIFY(!requests.hear(Reins::Hand, Seconds{0.2})); // an update from before
        requests.take(Seconds{5.0});
        QVERIFY(!requests.hear(Reins::Nobody, Seconds{5.1}));
        QVERIFY(requests.taken());
    }

    void aStickIsSaidInControlAndWhenItIsLetGo_data() {
        QTest::addColumn<bool>("taken");
        QTest::addColumn<bool>("held");
        QTest::addColumn<bool>("said");
        QTest::newRow("moved in control") << true << true << true;
        QTest::newRow("let go in control") << true << false << true;
        QTest::newRow("moved without control") << false << true << false;
        QTest::newRow("let go without control") << false << false << true;
    }

    void aStickIsSaidInControlAndWhenItIsLetGo() {
        QFETCH(bool, taken);
        QFETCH(bool, held);
        QFETCH(bool, said);
        HandRequests requests;
        if (taken)
            requests.take(Seconds{0.0});
        QCOMPARE(requests.move(HandSource::Pad, held ? forward : Stick{}), said);
        QCOMPARE(requests.isHeld(HandSource::Pad), held);
    }

    void whatIsHeldIsSaidAgain() {
        HandRequests requests;
        QVERIFY(requests.held().empty());
        QVERIFY(!requests.move(HandSource::Gamepad, forward));
        QVERIFY(!requests.move(HandSource::Keys, forward));
        QVERIFY(requests.held() == (std::vector{HandSource::Keys, HandSource::Gamepad}));
        QVERIFY(requests.move(HandSource::Keys, {}));
        QVERIFY(requests.held() == std::vector{HandSource::Gamepad});
    }

    void onlyAGamepadHasAName() {
        HandRequests requests;
        QVERIFY(!requests.move(HandSource::Gamepad, forward));
        QVERIFY(requests.intentOf(HandSource::Gamepad, "Trusty", 0.5) ==
                (HandIntent{HandSource::Gamepad, "Trusty", forward, 0.5}));
        QVERIFY(requests.intentOf(HandSource::Keys, "Trusty", 0.5) == (HandIntent{HandSource::Keys, {}, {}, 0.5}));
    }
};

USAR_TEST(tst_HandRequests)

} // namespace tst_hand_requests

#include "tst_hand_requests.moc"
