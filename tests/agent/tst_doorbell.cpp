#include <atomic>
#include <thread>

#include <QElapsedTimer>
#include <QObject>
#include <QTest>

#include "core/agent/doorbell.h"
#include "tests/suite/suite.h"

namespace tst_doorbell {

using usar::Seconds;
using usar::agent::Doorbell;

class tst_Doorbell : public QObject {
    Q_OBJECT
private slots:
    void tellsThatNobodyRangWhenItsPatienceIsOver() {
        Doorbell bell;
        QElapsedTimer timer;
        timer.start();
        QVERIFY(!bell.wait([] { return false; }, Seconds{0.05}));
        QVERIFY2(timer.elapsed() >= 49, qPrintable(QString::number(timer.elapsed())));
        QVERIFY(bell.wait([] { return true; }, Seconds{0.0}));
    }

    /// A ring that got lost would cost one of them its whole patience.
    void noRingIsLost() {
        constexpr int turns = 5000;
        constexpr Seconds patience{30.0};
        Doorbell at_one;
        Doorbell at_other;
        std::atomic<int> asked = 0;
        std::atomic<int> answered = 0;
        int plain = 0; // ThreadSanitizer sees whether the atomics guard it.
        std::thread other([&] {
            for (int turn = 1; turn <= turns; ++turn) {
                if (!at_other.wait([&] { return asked >= turn; }, patience))
                    return;
                ++plain;
                answered = turn;
                at_one.ring();
            }
        });
        int came = 0;
        for (int turn = 1; turn <= turns; ++turn) {
            asked = turn;
            at_other.ring();
            if (!at_one.wait([&] { return answered >= turn; }, patience))
                break;
            ++came;
            QCOMPARE(plain, turn);
        }
        other.join();
        QCOMPARE(came, turns);
    }
};

USAR_TEST(tst_Doorbell)

} // namespace tst_doorbell

#include "tst_doorbell.moc"
