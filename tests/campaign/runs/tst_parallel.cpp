// Work on many things at a time.
#include <atomic>
#include <stdexcept>
#include <string>
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
    inParallel(1000, [&](std::size_t i) {
        ++running;
        std::string text;
        for (std::size_t number = 0; number < i; ++number) // The last ones take longest.
            text += std::to_string(number);
        done += static_cast<int>(text.size() < i);
        --running;
        ++done;
    });
    QCOMPARE(running.load(), 0);
    QCOMPARE(done.load(), 1000);
}

/// No work is under way any longer when the exception arrives.
void tst_Parallel::throwsWhatTheWorkThrows() {
    std::atomic<int> running{0};
    std::atomic<int> begun{0};
    const auto failing = [&](std::size_t i) {
        ++begun;
        if (i == 5)
            throw std::runtime_error("the sixth");
        ++running;
        --running;
    };
    QVERIFY_EXCEPTION_THROWN(inParallel(100, failing), std::runtime_error);
    QCOMPARE(running.load(), 0);
    QVERIFY(begun > 5);
    const int begun_then = begun;
    inParallel(3, [&](std::size_t) {}); // It works again, and nothing of the first goes on beside it.
    QCOMPARE(begun.load(), begun_then);
}

USAR_TEST(tst_Parallel)

} // namespace tst_parallel

#include "tst_parallel.moc"
