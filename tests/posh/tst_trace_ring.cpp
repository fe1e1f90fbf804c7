// The ring between engine and reader: order, texts, and what is dropped.
#include <QTest>

#include <thread>

#include "core/posh/trace/trace_ring.h"
#include "tests/suite/suite.h"

namespace tst_trace_ring {

using namespace usar::posh;

namespace {

TraceRecord numbered(std::uint64_t number) {
    TraceRecord record;
    record.cycle = number;
    record.payload = ~number;
    return record;
}

} // namespace

class tst_TraceRing : public QObject {
    Q_OBJECT
private slots:
    void givesWhatWasTakenInOrder();
    void dropsTheOldestAndCountsThem();
    void cutsLongTexts();
    void losesNothingSilentlyBetweenTwoThreads();
};

void tst_TraceRing::givesWhatWasTakenInOrder() {
    TraceRing ring(4);
    std::vector<TraceRing::Entry> read;
    ring.takeProgram(nullptr);
    ring.take(numbered(1), "near");
    ring.take(numbered(2), {});
    ring.read(read);
    ring.takeProgram(nullptr);
    ring.take(numbered(3), "far");
    ring.read(read);
    QCOMPARE(read.size(), std::size_t(3));
    QCOMPARE(read[0].record, numbered(1));
    QCOMPARE(read[0].text, std::string("near"));
    QCOMPARE(read[1].text, std::string());
    QCOMPARE(read[1].program, 1u);
    QCOMPARE(read[2].text, std::string("far"));
    QCOMPARE(read[2].program, 2u);
    QCOMPARE(ring.dropped(), std::uint64_t(0));
}

void tst_TraceRing::dropsTheOldestAndCountsThem() {
    TraceRing ring(8);
    for (std::uint64_t i = 0; i < 20; ++i)
        ring.take(numbered(i), {});
    std::vector<TraceRing::Entry> read;
    ring.read(read);
    QCOMPARE(read.size(), std::size_t(8));
    QCOMPARE(read.front().record.cycle, std::uint64_t(12));
    QCOMPARE(ring.dropped(), std::uint64_t(12));
}

void tst_TraceRing::cutsLongTexts() {
    TraceRing ring(8);
    ring.take(numbered(1), std::string(200, 'x'));
    std::vector<TraceRing::Entry> read;
    ring.read(read);
    QCOMPARE(read.front().text, std::string(TraceRing::longest_text, 'x'));
}

void tst_TraceRing::losesNothingSilentlyBetweenTwoThreads() {
    constexpr std::uint64_t count = 200'000;
    TraceRing ring(1 << 10);
    std::thread writer([&ring] {
        for (std::uint64_t i = 0; i < count; ++i)
            ring.take(numbered(i), i % 2 ? "odd one" : "");
    });
    std::uint64_t seen = 0;
    std::uint64_t next = 0;
    bool sound = true;
    std::vector<TraceRing::Entry> read;
    while (seen + ring.dropped() < count) {
        read.clear();
        ring.read(read);
        for (const auto& [record, program, text] : read) {
            sound = sound && record.cycle >= next && record.payload == ~record.cycle &&
                    text == (record.cycle % 2 ? "odd one" : "");
            next = record.cycle + 1;
        }
        seen += read.size();
    }
    writer.join();
    QVERIFY(sound);
    QCOMPARE(seen + ring.dropped(), count);
}

USAR_TEST(tst_TraceRing)

} // namespace tst_trace_ring

#include "tst_trace_ring.moc"
