#include <atomic>
#include <thread>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/shared_processor.h"
#include "tests/suite/suite.h"

namespace tst_shared_processor {

using namespace usar;
using namespace usar::agent;

namespace {

cpu_set_t allowedFor(pthread_t thread) {
    cpu_set_t allowed{};
    pthread_getaffinity_np(thread, sizeof allowed, &allowed);
    return allowed;
}

/// A thread that waits, the other one of two.
class Other {
public:
    ~Other() {
        left_ = true;
        left_.notify_one();
        thread_.join();
    }
    pthread_t handle() { return thread_.native_handle(); }

private:
    std::atomic<bool> left_ = false;
    std::thread thread_{[this] { left_.wait(false); }};
};

} // namespace

class tst_SharedProcessor : public QObject {
    Q_OBJECT

private slots:
    void theRuleGoesByHowMuchTheyWork_data() {
        QTest::addColumn<std::vector<double>>("worked");
        QTest::addColumn<QString>("shares");
        using Shares = std::vector<double>;
        // Looks are 60 ms apart.
        QTest::newRow("busy, and undisturbed then") << Shares{0.7, 0.97, 0.95} << "yyy";
        QTest::newRow("mostly waiting") << Shares{0.1, 0.3, 0.39} << "nnn";
        QTest::newRow("busy later") << Shares{0.1, 0.5} << "ny";
        QTest::newRow("disturbed: again after 0.1 s") << Shares{0.7, 0.5, 0.7, 0.7} << "ynny";
        QTest::newRow("disturbed again: 0.2 s") << Shares{0.7, 0.5, 0.7, 0.7, 0.5, 0.7, 0.7, 0.7, 0.7} << "ynnynnnny";
        QTest::newRow("undisturbed between: 0.1 s") << Shares{0.7, 0.5, 0.7, 0.7, 0.9, 0.5, 0.7, 0.7} << "ynnyynny";
        QTest::newRow("waiting after a pause") << Shares{0.7, 0.5, 0.1, 0.1, 0.1, 0.7} << "ynnnny";
    }
    void theRuleGoesByHowMuchTheyWork() {
        QFETCH(std::vector<double>, worked);
        QFETCH(QString, shares);
        constexpr Seconds passed{0.06};
        SharingRule rule;
        QString said;
        for (const double share : worked)
            said += rule.shouldShare(passed, share * passed) ? 'y' : 'n';
        QCOMPARE(said, shares);
    }

    void bothThreadsAreBoundToOneProcessorForAWhile() {
        Other other;
        const cpu_set_t before = allowedFor(pthread_self());
        {
            const OneProcessor one(other.handle());
            const cpu_set_t mine = allowedFor(pthread_self());
            const cpu_set_t others = allowedFor(other.handle());
            QCOMPARE(CPU_COUNT(&mine), 1);
            QVERIFY(CPU_EQUAL(&mine, &others));
        }
        for (const pthread_t thread : {pthread_self(), other.handle()}) {
            const cpu_set_t after = allowedFor(thread);
            QVERIFY(CPU_EQUAL(&after, &before));
        }
    }

    /// However busy the machine is, the end lets both run where they might before.
    void turnsLeaveNoThreadBound() {
        Other other;
        const cpu_set_t before = allowedFor(pthread_self());
        {
            SharedProcessor shared(other.handle());
            QElapsedTimer since;
            for (since.start(); since.elapsed() < 200;)
                shared.turn();
        }
        for (const pthread_t thread : {pthread_self(), other.handle()}) {
            const cpu_set_t after = allowedFor(thread);
            QVERIFY(CPU_EQUAL(&after, &before));
        }
    }
};

USAR_TEST(tst_SharedProcessor)

} // namespace tst_shared_processor

#include "tst_shared_processor.moc"
