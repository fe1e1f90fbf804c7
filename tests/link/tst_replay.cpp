#include <cmath>
#include <limits>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/link/recording_packing.h"
#include "core/link/replay.h"
#include "tests/doubles/plain_recording.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_replay {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

constexpr double as_fast_as_it_can = std::numeric_limits<double>::infinity();

/// Writes down what it hears, one text each.
struct Listener : ReplayTaker {
    std::vector<std::string> heard;
    std::vector<std::string> since_rewound;
    bool is_quiet = false;
    int rewinds = 0;

    void hear(const std::string& text) {
        if (!is_quiet)
            heard.push_back(text);
        since_rewound.push_back(text);
    }
    void rewound() override {
        ++rewinds;
        since_rewound.clear();
    }
    void opened(std::string_view place) override { hear("opened " + std::string(place)); }
    void closed(std::string_view reason) override { hear("closed " + std::string(reason)); }
    void line(std::string_view text, LineNumber number) override {
        hear(std::to_string(number.value) + " " + std::string(text));
    }
    void sent(const Record& record) override { hear("sent after " + std::to_string(record.line.value)); }
    void note(const Record& record) override { hear("note " + std::string(record.bytes)); }
    void quiet(bool on) override { is_quiet = on; }
};

/// A tick of 100 ms every 100 ms, each answered; the first lines are cut across chunks.
std::string ticking(int ticks) {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::Start});
    doubles::appendPlain(file, {.kind = RecordKind::Opened, .bytes = "h:1"});
    for (int i = 1; i <= ticks; ++i) {
        const auto number = static_cast<std::uint64_t>(i);
        doubles::appendPlain(file,
                             {.kind = RecordKind::In,
                              .time = 100ms * i,
                              .line = {number - 1},
                              .bytes = "STA {Time " + std::to_string(i / 10) + "." + std::to_string(i % 10) + "}\r\n"});
        doubles::appendPlain(file,
                             {.kind = RecordKind::Out, .time = 100ms * i + 1ms, .line = {number}, .bytes = "STEP\r\n"});
    }
    return file;
}

} // namespace

class tst_Replay : public QObject {
    Q_OBJECT
private slots:
    void linesComeInTheirOrderWithTheirNumbers();
    void whatWasSentBetweenTwoLinesOfAChunkComesBetweenThem();
    void numbersGoOnWhereARecordingBegan();
    void theRestOfAChunkInWhichTheLinkWasClosedIsNotRead();
    void playsAtItsPace_data();
    void playsAtItsPace();
    void aFastSimulatorIsPlayedAtTheRobotsPace();
    void aDamagedTimeDoesNotStretchIt();
    void pauseHoldsIt();
    void seekForwardGoesOnAndBackwardBeginsAnew();
    void aMomentBehindTheEndIsTheEnd_data();
    void aMomentBehindTheEndIsTheEnd();
    void theRobotsClockIsSoughtThroughAPause();
    void aWishOnTheWayReplacesTheOneBefore();
    void stepGoesToTheNextBytes();
    void playAtTheEndBeginsAgain();
    void damageIsToldWhenItIsMet();

private:
    std::unique_ptr<Replayer> replayOf(const std::string& file, Listener& listener);
    void playAll(Replayer& replayer);
    RecordTime lengthOf(const std::vector<std::pair<RecordTime, std::string>>& chunks);

    QTemporaryDir folder_;
};

std::unique_ptr<Replayer> tst_Replay::replayOf(const std::string& bytes, Listener& listener) {
    QFile file(folder_.filePath("r.usarrec"));
    if (!file.open(QIODevice::WriteOnly))
        return nullptr;
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    return std::make_unique<Replayer>(*RecordingReader::open(file.fileName()), listener);
}

void tst_Replay::playAll(Replayer& replayer) {
    QSignalSpy ended(&replayer, &Replayer::ended);
    replayer.setSpeed(as_fast_as_it_can);
    replayer.setPlaying(true);
    QTRY_COMPARE(ended.size(), 1);
}

void tst_Replay::linesComeInTheirOrderWithTheirNumbers() {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::Opened, .bytes = "h:1"});
    doubles::appendPlain(file, {.kind = RecordKind::In, .time = 1ms, .bytes = "NFO {A 1}\r\n\r\nSTA"});
    doubles::appendPlain(file, {.kind = RecordKind::In, .time = 2ms, .line = {1}, .bytes = " {B 2}\r\nhalf a li"});
    doubles::appendPlain(file, {.kind = RecordKind::Closed, .time = 3ms, .line = {2}, .bytes = "gone"});
    doubles::appendPlain(file, {.kind = RecordKind::Opened, .time = 4ms, .line = {2}, .bytes = "h:1"});
    doubles::appendPlain(file, {.kind = RecordKind::In, .time = 5ms, .line = {2}, .bytes = "NFO {C 3}\r\n"});
    Listener listener;
    const auto replayer = replayOf(file, listener);
    QVERIFY(listener.heard.empty());
    playAll(*replayer);
    const std::vector<std::string> expected{"opened h:1",  "1 NFO {A 1}", "2 STA {B 2}",
                                            "closed gone", "opened h:1",  "3 NFO {C 3}"};
    QCOMPARE(listener.heard, expected);
}

void tst_Replay::whatWasSentBetweenTwoLinesOfAChunkComesBetweenThem() {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::In, .time = 1ms, .bytes = "A {1}\r\nB {2}\r\nC {3}\r\n"});
    doubles::appendPlain(file, {.kind = RecordKind::Note, .time = 2ms, .line = {1}, .name = "n", .bytes = "x"});
    doubles::appendPlain(file, {.kind = RecordKind::Out, .time = 2ms, .line = {2}, .bytes = "STEP\r\n"});
    doubles::appendPlain(file, {.kind = RecordKind::Out, .time = 3ms, .line = {3}, .bytes = "STEP\r\n"});
    Listener listener;
    const auto replayer = replayOf(file, listener);
    playAll(*replayer);
    const std::vector<std::string> expected{"1 A {1}", "note x", "2 B {2}", "sent after 2", "3 C {3}", "sent after 3"};
    QCOMPARE(listener.heard, expected);
}

void tst_Replay::numbersGoOnWhereARecordingBegan() {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::In, .time = 1ms, .line = {4711}, .bytes = "A {1}\r\n"});
    Listener listener;
    const auto replayer = replayOf(file, listener);
    playAll(*replayer);
    QCOMPARE(listener.heard, std::vector<std::string>{"4712 A {1}"});
}

void tst_Replay::theRestOfAChunkInWhichTheLinkWasClosedIsNotRead() {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::In, .bytes = "A {1}\r\nB {2}\r\n"});
    doubles::appendPlain(file, {.kind = RecordKind::Closed, .line = {1}});
    doubles::appendPlain(file, {.kind = RecordKind::Opened, .line = {1}, .bytes = "h:1"});
    doubles::appendPlain(file, {.kind = RecordKind::In, .line = {1}, .bytes = "C {3}\r\n"});
    Listener listener;
    const auto replayer = replayOf(file, listener);
    playAll(*replayer);
    const std::vector<std::string> expected{"1 A {1}", "closed ", "opened h:1", "2 C {3}"};
    QCOMPARE(listener.heard, expected);
}

void tst_Replay::playsAtItsPace_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("ticks");
    QTest::addColumn<int>("least_ms");
    QTest::newRow("as it was") << 1.0 << 4 << 390;
    QTest::newRow("ten times") << 10.0 << 40 << 390;
    QTest::newRow("a hundred times") << 100.0 << 400 << 390;
    QTest::newRow("more than a hundred is a hundred") << 5000.0 << 400 << 390;
    QTest::newRow("half") << 0.5 << 2 << 390;
    QTest::newRow("as fast as it can") << as_fast_as_it_can << 4000 << 0;
}

void tst_Replay::playsAtItsPace() {
    QFETCH(double, speed);
    QFETCH(int, ticks);
    QFETCH(int, least_ms);
    Listener listener;
    const auto replayer = replayOf(ticking(ticks), listener);
    QSignalSpy ended(replayer.get(), &Replayer::ended);
    replayer->setSpeed(speed);
    QElapsedTimer timer;
    timer.start();
    replayer->setPlaying(true);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, 20000);
    QVERIFY2(timer.elapsed() >= least_ms, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(static_cast<int>(listener.heard.size()), 1 + 2 * ticks);
    QCOMPARE(replayer->figures().position, replayer->figures().span);
    QVERIFY(!replayer->figures().playing);
}

RecordTime tst_Replay::lengthOf(const std::vector<std::pair<RecordTime, std::string>>& chunks) {
    std::string file;
    doubles::appendOldHead(file);
    for (const auto& [time, bytes] : chunks)
        doubles::appendPlain(file, {.kind = RecordKind::In, .time = time, .bytes = bytes + "\r\n"});
    Listener listener;
    return replayOf(file, listener)->survey().play_span;
}

void tst_Replay::aFastSimulatorIsPlayedAtTheRobotsPace() {
    QCOMPARE(lengthOf({{1ms, "STA {Time 5.0}"}, {2ms, "STA {Time 7.0}"}, {3ms, "STA {Time 9.0}"}}), RecordTime(4001ms));
    QCOMPARE(lengthOf({{1s, "STA {Time 5.0}"}, {2s, "STA {Time 5.1}"}, {3s, "STA {Time 5.2}"}}), RecordTime(3s));
    QCOMPARE(lengthOf({{1s, "no time"}, {2s, "STA {Time"}}), RecordTime(2s));
}

void tst_Replay::aDamagedTimeDoesNotStretchIt() {
    for (const char* damaged : {"1e308", "nan", "-1e9", "x", ""})
        QVERIFY(lengthOf({{1ms, "STA {Time 5.0}"},
                          {2ms, std::string("STA {Time ") + damaged + "}"},
                          {3ms, "STA {Time 7.0}"}}) < 2500ms);
}

void tst_Replay::pauseHoldsIt() {
    Listener listener;
    const auto replayer = replayOf(ticking(1000), listener);
    replayer->setPlaying(true);
    QTRY_VERIFY(listener.heard.size() >= 3);
    replayer->setPlaying(false);
    const auto heard = listener.heard.size();
    const Seconds position = replayer->figures().position;
    const test::Beats beats(16); // as it is played
    QVERIFY(test::holdsUntil([&] { return listener.heard.size() == heard && replayer->figures().position == position; },
                             [&] { return beats.count() >= 5; }));
}

void tst_Replay::seekForwardGoesOnAndBackwardBeginsAnew() {
    Listener listener;
    const auto replayer = replayOf(ticking(100), listener);
    replayer->seek(Seconds{5.05});
    QTRY_VERIFY(!replayer->figures().seeking);
    QCOMPARE(listener.rewinds, 0);
    QVERIFY(listener.heard.empty()); // all of it was only the way
    QCOMPARE(listener.since_rewound.size(), std::size_t{101});
    QCOMPARE(replayer->figures().position, Seconds{5.05});
    replayer->seek(Seconds{2.0});
    QTRY_VERIFY(!replayer->figures().seeking);
    QCOMPARE(listener.rewinds, 1);
    QCOMPARE(listener.since_rewound.size(), std::size_t{40});
    QCOMPARE(listener.since_rewound.back(), std::string("20 STA {Time 2.0}"));
    replayer->step();
    QCOMPARE(listener.heard.back(), std::string("21 STA {Time 2.1}"));
}

void tst_Replay::aMomentBehindTheEndIsTheEnd_data() {
    QTest::addColumn<double>("to_s");
    QTest::newRow("a little") << 10.5;
    QTest::newRow("more than nanoseconds can count") << 1e300;
    QTest::newRow("infinitely far") << HUGE_VAL;
}

void tst_Replay::aMomentBehindTheEndIsTheEnd() {
    QFETCH(const double, to_s);
    Listener listener;
    const auto replayer = replayOf(ticking(100), listener);
    replayer->seek(Seconds{to_s});
    QTRY_VERIFY(!replayer->figures().seeking);
    QCOMPARE(listener.rewinds, 0);
    QCOMPARE(listener.since_rewound.size(), std::size_t{201});
    QCOMPARE(replayer->figures().position, replayer->survey().play_span);
}

void tst_Replay::theRobotsClockIsSoughtThroughAPause() {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::Start});
    doubles::appendPlain(file, {.kind = RecordKind::Opened, .bytes = "h:1"});
    for (std::uint64_t i = 1; i <= 20; ++i) // a second each; behind the tenth time stood still for an hour
        doubles::appendPlain(file, {.kind = RecordKind::In,
                                    .time = 1s * i + (i > 10 ? 1h : 0h),
                                    .line = {i - 1},
                                    .bytes = "STA {Time " + std::to_string(100 + i) + ".0}\r\n"});
    Listener listener;
    const auto replayer = replayOf(file, listener);
    for (const int line : {15, 5, 20, 1, 11, 10}) {
        replayer->seekToClock(Seconds{100.0 + line});
        QTRY_VERIFY(!replayer->figures().seeking);
        QCOMPARE(listener.since_rewound.back(),
                 std::to_string(line) + " STA {Time " + std::to_string(100 + line) + ".0}");
    }
}

void tst_Replay::aWishOnTheWayReplacesTheOneBefore() {
    Listener listener;
    const auto replayer = replayOf(ticking(20000), listener);
    for (const double to_s : {1900.0, 3.0, 1500.0, 2.0})
        replayer->seek(Seconds{to_s});
    QVERIFY(replayer->figures().seeking);
    QTRY_VERIFY(!replayer->figures().seeking);
    QCOMPARE(listener.since_rewound.size(), std::size_t{40});
    QVERIFY(!listener.is_quiet);
}

void tst_Replay::stepGoesToTheNextBytes() {
    Listener listener;
    const auto replayer = replayOf(ticking(3), listener);
    replayer->step();
    QCOMPARE(listener.heard.back(), std::string("1 STA {Time 0.1}"));
    replayer->step();
    QCOMPARE(listener.heard.back(), std::string("2 STA {Time 0.2}"));
    QCOMPARE(replayer->figures().position, Seconds{0.2});
    for (int i = 0; i < 5; ++i)
        replayer->step(); // at the end there is nothing more
    QCOMPARE(listener.heard.size(), std::size_t{7});
}

void tst_Replay::playAtTheEndBeginsAgain() {
    Listener listener;
    const auto replayer = replayOf(ticking(3), listener);
    playAll(*replayer);
    QSignalSpy ended(replayer.get(), &Replayer::ended);
    replayer->setPlaying(true);
    QTRY_COMPARE(ended.size(), 1);
    QCOMPARE(listener.rewinds, 1);
    QCOMPARE(listener.since_rewound.size(), std::size_t{7});
}

/// A file with an index is not read before it is played.
void tst_Replay::damageIsToldWhenItIsMet() {
    std::string file;
    recording::appendHead(file);
    RecordPacker packer;
    BlockWriter blocks(file.size());
    Random random = seeded(1, 1);
    std::uniform_int_distribution<int> letter('a', 'z');
    for (int i = 0; i < 900; ++i) {
        std::string line(998, ' ');
        std::ranges::generate(line, [&] { return static_cast<char>(letter(random)); });
        packer.add({.kind = RecordKind::In, .time = 1ms * i, .bytes = line + "\r\n"});
    }
    packer.add({.kind = RecordKind::End, .time = 1s});
    blocks.append(file, packer.take());
    blocks.appendIndex(file);
    file[file.size() / 2] ^= 1;
    QFile damaged(folder_.filePath("damaged.usarrec"));
    QVERIFY(damaged.open(QIODevice::WriteOnly));
    damaged.write(file.data(), static_cast<qint64>(file.size()));
    damaged.close();
    Listener listener;
    Replayer replayer(*RecordingReader::open(damaged.fileName(), OpenMode::Quick), listener);
    QSignalSpy told(&replayer, &Replayer::damaged);
    QVERIFY(replayer.survey().complaint().empty());
    playAll(replayer);
    QCOMPARE(told.size(), 1);
    QVERIFY(replayer.survey().complaint().find("damaged") != std::string::npos);
    replayer.seek(Seconds{0.0});
    playAll(replayer);
    QCOMPARE(told.size(), 1);
}

USAR_TEST(tst_Replay)

} // namespace tst_replay

#include "tst_replay.moc"
