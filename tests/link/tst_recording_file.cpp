// Recordings as files: cut off, damaged, killed, on a full disk, converted, and an hour long.
#include <csignal>
#include <functional>
#include <future>
#include <thread>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QBuffer>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_reader.h"
#include "core/link/recording_text.h"
#include "core/link/recording_writer.h"
#include "tests/doubles/plain_recording.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_recording_file {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        QTest::qFail("cannot write a test's file", __FILE__, __LINE__);
}

/// Every kind of record, one a second.
void forEachKind(const std::function<void(const Record& record)>& add) {
    add({.kind = RecordKind::Start, .time = 0s, .bytes = "host: h\nport: 3000\n"});
    add({.kind = RecordKind::Opened, .time = 1s, .bytes = "h:3000"});
    add({.kind = RecordKind::Out, .time = 2s, .name = "session: connect", .bytes = "GETSTARTPOSES\r\n"});
    add({.kind = RecordKind::In, .time = 3s, .bytes = "NFO {Level a}\r\nSTA {Ti"});
    add({.kind = RecordKind::In, .time = 4s, .line = {1}, .bytes = "me 1.0}\r\n"});
    add({.kind = RecordKind::Note, .time = 5s, .line = {2}, .trigger = {2}, .name = "published", .bytes = "goal -"});
    add({.kind = static_cast<RecordKind>(77), .time = 6s, .line = {2}, .bytes = "of the future"});
    add({.kind = RecordKind::Closed, .time = 7s, .line = {2}, .bytes = "gone"});
    add({.kind = RecordKind::End, .time = 8s, .line = {2}});
}

/// These records in a file of version 1. `ends`: where each of them ends.
QByteArray smallRecording(std::vector<std::size_t>* ends = nullptr) {
    std::string file;
    doubles::appendOldHead(file);
    forEachKind([&](const Record& record) {
        doubles::appendPlain(file, record);
        if (ends)
            ends->push_back(file.size());
    });
    return QByteArray::fromStdString(file);
}

std::vector<std::string> textsOf(RecordingReader& reader) {
    std::vector<std::string> texts;
    while (const auto record = reader.next())
        recording::appendText(texts.emplace_back(), *record);
    return texts;
}

} // namespace

class tst_RecordingFile : public QObject {
    Q_OBJECT
private slots:
    void whatIsWrittenIsRead();
    void whatIsBeingWrittenIsReadWithoutAComplaint();
    void flushingEndsAlsoWhereNothingCanBeWritten();
    void opensCutOffAtEveryByte();
    void everyDamagedByteCostsOneRecord();
    void damageIsSearchedOnceHoweverOftenTheFileIsRead();
    void whatIsNoRecordingIsRefusedWithAMend_data();
    void whatIsNoRecordingIsRefusedWithAMend();
    void aFileThatExistsIsLeftAlone();
    void killedAtAnyMomentItLosesASecondAtMost();
    void aFullDiskIsSaidOnceAndLeavesWholeBlocks();
    void aBufferThatOverflowsEndsTheRecording();
    void recordingToTextAndBackIsTheSameRecords();
    void damageBecomesACommentInTheText();
    void brokenTextIsRefusedWithItsLine();
    void seekGoesToTheFirstRecordNotEarlier_data();
    void seekGoesToTheFirstRecordNotEarlier();
    void garbageNeitherHangsNorCrashes();

private:
    QTemporaryDir folder_;
    QString path(const char* name = "a.usarrec") const { return folder_.filePath(name); }
};

void tst_RecordingFile::whatIsWrittenIsRead() {
    const QString file = folder_.filePath("new/folder/r.usarrec");
    {
        auto writer = RecordingWriter::create(file, {{"host", "h"}, {"robot", "R1"}}, {5});
        QVERIFY2(writer, writer ? "" : writer.error().text().c_str());
        (*writer)->write({.kind = RecordKind::In, .line = {5}, .bytes = "STA {Time 1}\r\n"});
        (*writer)->write(
            {.kind = RecordKind::Out, .line = {6}, .trigger = {6}, .name = "me", .bytes = "DRIVE {Left 1}\r\n"});
    }
    const auto reader = RecordingReader::open(file);
    QVERIFY2(reader, reader ? "" : reader.error().text().c_str());
    const RecordingSurvey& survey = (*reader)->survey();
    QCOMPARE(survey.facts.at("robot"), std::string("R1"));
    QCOMPARE(survey.first_line.value, 5u);
    QCOMPARE(survey.records, 4u);
    QCOMPARE(survey.bytes_in, 14u);
    QCOMPARE(survey.bytes_out, 16u);
    QVERIFY(survey.ended && survey.complaint().empty());
    QCOMPARE((*reader)->next()->kind, RecordKind::Start);
    QVERIFY((*reader)->next()->bytes == "STA {Time 1}\r\n");
    const auto out = (*reader)->next();
    QVERIFY(out->name == "me" && out->trigger == LineNumber{6} && out->line == LineNumber{6});
    QCOMPARE((*reader)->next()->kind, RecordKind::End);
    QVERIFY(!(*reader)->next());
}

void tst_RecordingFile::whatIsBeingWrittenIsReadWithoutAComplaint() {
    const QString file = path("growing.usarrec");
    auto writer = RecordingWriter::create(file, {}, {}, {.flush = 1h}); // alone it would not write for long
    QVERIFY(writer.has_value());
    (*writer)->write({.kind = RecordKind::In, .bytes = "STA {Time 1}\r\n"});
    std::promise<void> flushed;
    (*writer)->flush([&] { flushed.set_value(); });
    QVERIFY(flushed.get_future().wait_for(10s) == std::future_status::ready);
    const QByteArray so_far = bytesOf(file);
    const QByteArray block = so_far.mid(recording::head_bytes); // any whole one
    for (const qsizetype begun : {0, 1, 24, 30}) {              // bytes of the next record
        QFile growing(file);
        QVERIFY(growing.open(QIODevice::ReadWrite) && growing.resize(so_far.size()) && growing.seek(so_far.size()));
        growing.write(block.mid(0, begun));
        growing.close();
        const auto reader = RecordingReader::open(file);
        QVERIFY2(reader, reader ? "" : reader.error().text().c_str());
        const RecordingSurvey& survey = (*reader)->survey();
        QVERIFY(survey.being_written && !survey.ended && survey.damage.empty());
        QCOMPARE(survey.complaint(), std::string());
        QCOMPARE(survey.records, 2u);
        QCOMPARE(textsOf(**reader).size(), std::size_t(2));
    }
    QFile::resize(file, so_far.size());
    writer->reset();
    const auto over = RecordingReader::open(file);
    QVERIFY(over && (*over)->survey().ended && !(*over)->survey().being_written);
}

void tst_RecordingFile::flushingEndsAlsoWhereNothingCanBeWritten() {
    auto writer = RecordingWriter::create(path("small.usarrec"), {}, {}, {.buffer_bytes = 100, .flush = 1h});
    QVERIFY(writer.has_value());
    int told = 0;
    (*writer)->write({.kind = RecordKind::In, .bytes = std::string(1000, 'x')}); // more than it may keep
    QVERIFY((*writer)->broken());
    (*writer)->flush([&] { ++told; });
    QCOMPARE(told, 1);
    writer->reset();
    QCOMPARE(told, 1);
}

void tst_RecordingFile::opensCutOffAtEveryByte() {
    std::vector<std::size_t> ends;
    const QByteArray whole = smallRecording(&ends);
    for (qsizetype size = 0; size < whole.size(); ++size) {
        put(path(), whole.left(size));
        const auto reader = RecordingReader::open(path());
        const auto cut = static_cast<std::size_t>(size);
        const auto records =
            static_cast<std::size_t>(std::ranges::count_if(ends, [&](auto end) { return end <= cut; }));
        QCOMPARE(reader.has_value(), records > 0);
        if (!reader)
            continue;
        QCOMPARE((*reader)->survey().records, records);
        QCOMPARE((*reader)->survey().tail_lost_bytes, cut - ends[records - 1]);
        QVERIFY(!(*reader)->survey().ended);
        QVERIFY((*reader)->survey().complaint().find("not ended in order") != std::string::npos);
        QCOMPARE(textsOf(**reader).size(), records);
    }
}

void tst_RecordingFile::everyDamagedByteCostsOneRecord() {
    std::vector<std::size_t> ends;
    const QByteArray whole = smallRecording(&ends);
    for (qsizetype at = recording::head_bytes; at < whole.size(); ++at) {
        QByteArray damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        put(path(), damaged);
        const auto reader = RecordingReader::open(path());
        QVERIFY2(reader, qPrintable(QString("byte %1").arg(at)));
        const RecordingSurvey& survey = (*reader)->survey();
        QCOMPARE(survey.records, ends.size() - 1);
        QCOMPARE(survey.damage.size(), std::size_t{1});
        const std::uint64_t end = *std::ranges::upper_bound(ends, static_cast<std::size_t>(at));
        QCOMPARE(survey.damage[0].offset + survey.damage[0].bytes, end);
        QVERIFY(survey.damage[0].offset <= static_cast<std::uint64_t>(at));
        QVERIFY(!survey.complaint().empty());
    }
}

/// Each damaged record looks as if further ones of half a megabyte began in it, so that three use up most of what the
/// reader spends on such searches.
void tst_RecordingFile::damageIsSearchedOnceHoweverOftenTheFileIsRead() {
    constexpr int count = 6000;
    std::string lure;
    for (int repeat = 0; repeat < 32; ++repeat)
        lure += std::string("\x01\x00\x08\x00", 4);
    std::string file;
    doubles::appendOldHead(file);
    for (int number = 0; number < count; ++number) {
        doubles::appendPlain(file, {.kind = RecordKind::In, .time = number * 1ms, .bytes = lure});
        if (number == 10 || number == 20 || number == 30)
            file[file.size() - lure.size() - recording::record_head_bytes + 4] ^= 1; // Its checksum.
    }
    put(path("lures.usarrec"), QByteArray::fromStdString(file));
    const auto reader = RecordingReader::open(path("lures.usarrec"));
    QVERIFY(reader);
    QCOMPARE((*reader)->survey().records, std::uint64_t(count - 3));
    for (int pass = 0; pass < 3; ++pass) {
        (*reader)->seek(RecordTime{0});
        int read = 0;
        while ((*reader)->next())
            ++read;
        QCOMPARE(read, count - 3);
    }
}

void tst_RecordingFile::whatIsNoRecordingIsRefusedWithAMend_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("empty") << QByteArray() << QByteArray("the file is empty");
    QTest::newRow("a mission") << QByteArray("{\"name\": \"quick scan\"}") << QByteArray("byte 0 does not begin");
    QTest::newRow("its text form") << QByteArray("USAR recording, text form 1\n") << QByteArray("text-to-recording");
    QTest::newRow("half its head") << smallRecording().left(6) << QByteArray("ends at byte 6");
    QTest::newRow("the head alone") << smallRecording().left(12) << QByteArray("not one whole record");
    QByteArray newer = smallRecording();
    newer[8] = 3;
    QTest::newRow("a newer version") << newer << QByteArray("byte 8");
    QByteArray mangled = smallRecording();
    mangled.replace("\r\n", "\n");
    QTest::newRow("sent as text") << mangled << QByteArray("byte 0 does not begin");
}

void tst_RecordingFile::whatIsNoRecordingIsRefusedWithAMend() {
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, words);
    put(path(), bytes);
    const auto reader = RecordingReader::open(path());
    QVERIFY(!reader);
    const QByteArray text = QByteArray::fromStdString(reader.error().text());
    QVERIFY2(text.contains(words) && text.contains("a.usarrec"), text);
    QVERIFY(!reader.error().mend.empty());
}

void tst_RecordingFile::aFileThatExistsIsLeftAlone() {
    put(path(), "precious");
    const auto writer = RecordingWriter::create(path(), {}, {});
    QVERIFY(!writer);
    QVERIFY2(writer.error().text().find("another name") != std::string::npos, writer.error().text().c_str());
    QCOMPARE(bytesOf(path()), QByteArray("precious"));
}

/// The child counts into the recording and, beside it, into a pipe what it has handed to the writer by when.
void tst_RecordingFile::killedAtAnyMomentItLosesASecondAtMost() {
    using Clock = std::chrono::steady_clock;
    int ends[2];
    QCOMPARE(::pipe(ends), 0);
    const QString file = path("killed.usarrec");
    const pid_t child = ::fork();
    if (child == 0) {
        const auto writer = RecordingWriter::create(file, {}, {});
        for (std::uint64_t line = 1;; ++line) {
            (*writer)->write({.kind = RecordKind::In, .line = {line}, .bytes = "STA {Time 1}\r\n"});
            const std::int64_t said[2]{static_cast<std::int64_t>(line), Clock::now().time_since_epoch().count()};
            if (::write(ends[1], said, sizeof said) != sizeof said)
                ::_exit(1);
            std::this_thread::sleep_for(1ms);
        }
    }
    ::close(ends[1]);
    std::map<std::int64_t, Clock::duration> handed;
    std::int64_t said[2];
    while (::read(ends[0], said, sizeof said) == sizeof said) {
        handed[said[0]] = Clock::duration(said[1]);
        if (handed.rbegin()->second - handed.begin()->second > 1300ms)
            break; // by the child's own account: it may have begun late
    }
    QVERIFY(test::sendSignal(child, SIGKILL));
    const auto killed = Clock::now().time_since_epoch();
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    const auto reader = RecordingReader::open(file);
    QVERIFY2(reader, reader ? "" : reader.error().text().c_str());
    std::int64_t newest = 0;
    while (const auto record = (*reader)->next())
        newest = static_cast<std::int64_t>(record->line.value);
    int older_than_a_second = 0;
    for (const auto& [line, when] : handed)
        if (killed - when > 1s) {
            ++older_than_a_second;
            QVERIFY2(line <= newest, qPrintable(QString("line %1 of %2 is missing").arg(line).arg(newest)));
        }
    QVERIFY(older_than_a_second > 0);
    QVERIFY((*reader)->survey().damage.empty());
}

void tst_RecordingFile::aFullDiskIsSaidOnceAndLeavesWholeBlocks() {
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 200'007; // in the midst of a block
    const QString file = path("full.usarrec");
    std::vector<Error> troubles;
    {
        const auto writer = RecordingWriter::create(file, {}, {}, {.buffer_bytes = 256 << 20, .flush = 1ms});
        QVERIFY(writer);
        std::promise<void> begun;
        (*writer)->flush([&] { begun.set_value(); });
        QVERIFY(begun.get_future().wait_for(10s) == std::future_status::ready);
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        QElapsedTimer patience;
        patience.start();
        while (!(*writer)->broken() && !patience.hasExpired(10000))
            (*writer)->write({.kind = RecordKind::In, .bytes = "STA {Time 1}\r\n"});
        for (int i = 0; i < 3; ++i)
            if (const auto trouble = (*writer)->takeTrouble())
                troubles.push_back(*trouble);
    }
    ::setrlimit(RLIMIT_FSIZE, &before);
    QCOMPARE(troubles.size(), std::size_t{1});
    const QByteArray text = QByteArray::fromStdString(troubles[0].text());
    QVERIFY2(text.contains("full.usarrec") && text.contains("no room left") && text.contains("Free some room"), text);
    const auto reader = RecordingReader::open(file);
    QVERIFY(reader);
    QVERIFY((*reader)->survey().damage.empty());
    QVERIFY((*reader)->survey().file_bytes > 100'000);
}

void tst_RecordingFile::aBufferThatOverflowsEndsTheRecording() {
    const QString file = path("slow.usarrec");
    const auto writer = RecordingWriter::create(file, {}, {}, {.buffer_bytes = 1000, .flush = 10min});
    QVERIFY(writer);
    const std::string many(2000, 'x');
    (*writer)->write({.kind = RecordKind::In, .bytes = many});
    QVERIFY((*writer)->broken());
    const auto trouble = (*writer)->takeTrouble();
    QVERIFY(trouble && trouble->text().find("too slow") != std::string::npos);
}

void tst_RecordingFile::recordingToTextAndBackIsTheSameRecords() {
    put(path(), smallRecording());
    QBuffer text;
    text.open(QIODevice::ReadWrite);
    QVERIFY(recordingToText(path(), text));
    QVERIFY2(text.data().contains("77 6.000000000 2 \"of the future\"\n"), text.data());
    text.seek(0);
    QBuffer again;
    again.open(QIODevice::ReadWrite);
    QVERIFY(textToRecording(text, "t.txt", again));
    put(path(), again.data());
    QBuffer text_again;
    text_again.open(QIODevice::ReadWrite);
    QVERIFY(recordingToText(path(), text_again));
    QCOMPARE(text_again.data(), text.data());
}

void tst_RecordingFile::damageBecomesACommentInTheText() {
    std::vector<std::size_t> ends;
    QByteArray damaged = smallRecording(&ends);
    damaged[static_cast<qsizetype>(ends[1] + 30)] = '?';
    put(path(), damaged);
    QBuffer text;
    text.open(QIODevice::ReadWrite);
    QVERIFY(recordingToText(path(), text));
    const QByteArray comment = "# " + QByteArray::number(qulonglong(ends[2] - ends[1])) + " damaged bytes at byte " +
                               QByteArray::number(qulonglong(ends[1])) + "\n";
    QVERIFY2(text.data().contains(comment), text.data());
    text.seek(0);
    QBuffer mended;
    mended.open(QIODevice::ReadWrite);
    QVERIFY(textToRecording(text, "t.txt", mended));
    put(path(), mended.data());
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader && (*reader)->survey().damage.empty());
    QCOMPARE((*reader)->survey().records, ends.size() - 1);
}

void tst_RecordingFile::brokenTextIsRefusedWithItsLine() {
    const auto complaint = [](const QByteArray& bytes) {
        QByteArray copy = bytes;
        QBuffer text(&copy);
        text.open(QIODevice::ReadOnly);
        QBuffer out;
        out.open(QIODevice::WriteOnly);
        const auto done = textToRecording(text, "t.txt", out);
        return done ? QByteArray() : QByteArray::fromStdString(done.error().text());
    };
    QVERIFY(complaint("in 0.000000000 0 \"\"\n").contains("t.txt, line 1: this is not the text form"));
    const QByteArray third = complaint("USAR recording, text form 1\n# fine\nin 0.5 0 \"\"\n");
    QVERIFY2(third.contains("t.txt, line 3, column 7: the time"), third);
}

void tst_RecordingFile::seekGoesToTheFirstRecordNotEarlier_data() {
    QTest::addColumn<double>("time_s");
    QTest::addColumn<int>("expected_s");
    QTest::newRow("the beginning") << 0.0 << 0;
    QTest::newRow("on a record") << 3.0 << 3;
    QTest::newRow("between two") << 3.5 << 4;
    QTest::newRow("the end") << 8.0 << 8;
    QTest::newRow("beyond it") << 9.0 << -1;
}

void tst_RecordingFile::seekGoesToTheFirstRecordNotEarlier() {
    QFETCH(double, time_s);
    QFETCH(int, expected_s);
    put(path(), smallRecording());
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader);
    (*reader)->seek(std::chrono::duration_cast<RecordTime>(Seconds{time_s}));
    const auto record = (*reader)->next();
    QCOMPARE(record ? int(record->time / 1s) : -1, expected_s);
}

void tst_RecordingFile::garbageNeitherHangsNorCrashes() {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::Start});
    // Each of these bytes could begin the longest of records.
    for (int i = 0; i < 400000; ++i)
        file += std::string_view("\x00\x00\x10\x00\x01", 5)[static_cast<std::size_t>(i % 5)];
    put(path(), QByteArray::fromStdString(file));
    QElapsedTimer timer;
    timer.start();
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader);
    QCOMPARE((*reader)->survey().records, 1u);
    QVERIFY2(timer.elapsed() < 60'000, qPrintable(QString::number(timer.elapsed())));
}

USAR_TEST(tst_RecordingFile)

} // namespace tst_recording_file

#include "tst_recording_file.moc"
