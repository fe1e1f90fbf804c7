// Work on many things at a time.
#include <atomic>
#include <stdexcept>
#include <vector>

#include <QTest>

#include "core/campaign/runs/parallel.h"
#include "tests/suite/suite.h"

namespace tst_parallel {

using namespace usar::campaign;

class tst_Parallel : public QObject {
    Q_OBJECT

private slots:
    void doesEachOnce_data();
    void doesEachOnce();
    void endsAllBeforeItReturns();
    void throwsWhatTheWorkThrows();
};

void tst_Parallel::doesEachOnce_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("nothing") << 0;
    QTest::newRow("one") << 1;
    QTest::newRow("fewer than processors, or as many") << 2;
    QTest::newRow("many") << 10'007;
}

void tst_Parallel::doesEachOnce() {
    QFETCH(const int, count);
    std::vector<int> times(static_cast<std::size_t>(count), 0);
    inParallel(times.size(), [&](std::size_t i) { ++times[i]; });
    QCOMPARE(times, std::vector<int>(times.size(), 1));
}

void tst_Parallel::endsAllBeforeItReturns() {
    std::atomic<int> running{0};
    std::atomic<int> done{0};
    inParallel(64, [&](std::size_t) {
        ++running;
        QTest::qSleep(1);
        --running;
        ++done;
    });
    QCOMPARE(running.load(), 0);
    QCOMPARE(done.load(), 64);
}

void tst_Parallel::throwsWhatTheWorkThrows() {
    std::atomic<int> done{0};
    const auto failing = [&](std::size_t i) {
        if (i == 5)
            throw std::runtime_error("the fifth");
        ++done;
    };
    QVERIFY_EXCEPTION_THROWN(inParallel(100, failing), std::runtime_error);
    QVERIFY(done < 100);
}

USAR_TEST(tst_Parallel)

} // namespace tst_parallel

#include "tst_parallel.moc"
