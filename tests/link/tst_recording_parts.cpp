// A recording in parts: what is renamed and deleted, and that its reader and its replay notice nothing of the seams.
#include <functional>
#include <limits>
#include <numeric>

#include <sys/file.h>
#include <unistd.h>

#include <QBuffer>
#include <QDateTime>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/link/recording_parts.h"
#include "core/link/recording_text.h"
#include "core/link/replay.h"
#include "tests/doubles/plain_recording.h"
#include "tests/suite/suite.h"

namespace tst_recording_parts {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

/// Sanitizers keep memory of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

/// A record that owns its texts.
struct Kept {
    Record record;
    std::string name;
    std::string bytes;
    Record view() const {
        Record copy = record;
        copy.name = name;
        copy.bytes = bytes;
        return copy;
    }
};
Kept kept(Record record) {
    return {record, std::string(record.name), std::string(record.bytes)};
}

std::vector<Kept> recordsIn(RecordingReader& reader) {
    std::vector<Kept> records;
    while (const auto record = reader.next())
        records.push_back(kept(*record));
    return records;
}

struct Listener : ReplayTaker {
    QStringList heard;
    void hear(std::string_view what, std::uint64_t number, std::string_view text) {
        heard << QString("%1 %2 %3")
                     .arg(QString::fromUtf8(what.data(), static_cast<qsizetype>(what.size())))
                     .arg(number)
                     .arg(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())));
    }
    void rewound() override { heard.clear(); }
    void opened(std::string_view place) override { hear("opened", 0, place); }
    void closed(std::string_view reason) override { hear("closed", 0, reason); }
    void line(std::string_view text, LineNumber number) override { hear("line", number.value, text); }
    void sent(const Record& record) override { hear("sent", record.line.value, record.bytes); }
    void note(const Record& record) override { hear("note", record.line.value, record.bytes); }
    void quiet(bool) override {}
};

QStringList replayed(std::unique_ptr<RecordingReader> reader) {
    Listener listener;
    Replayer replayer(std::move(reader), listener);
    QSignalSpy ended(&replayer, &Replayer::ended);
    replayer.setSpeed(std::numeric_limits<double>::infinity());
    replayer.setPlaying(true);
    return ended.wait(30'000) ? listener.heard : QStringList{"the replay did not end"};
}

/// 200 lines at 10 Hz, every chunk of which ends within a line, with an answer and now and then a note. Between lines
/// 100 and 101 the link is lost.
std::vector<Kept> flight() {
    std::vector<Kept> records;
    records.push_back(kept({.kind = RecordKind::Start, .bytes = "robot: R1\nstarted: then\n"}));
    records.push_back(kept({.kind = RecordKind::Opened, .bytes = "h:1"}));
    std::string rest;
    for (std::uint64_t i = 1; i <= 200; ++i) {
        const RecordTime now = 20ms * i; // The simulator runs at five times real time.
        if (i == 101) {
            records.push_back(kept({.kind = RecordKind::Closed, .time = now, .line = {i - 1}, .bytes = "lost"}));
            records.push_back(kept({.kind = RecordKind::Opened, .time = now, .line = {i - 1}, .bytes = "h:1"}));
            rest.clear();
        }
        const std::string line = "STA {Time " + std::to_string(i / 10) + "." + std::to_string(i % 10) + "}\r\n";
        const std::string next = "SEN {half";
        records.push_back(kept({.kind = RecordKind::In,
                                .time = now,
                                .line = {2 * i - 2},
                                .bytes = (rest.empty() ? "NFO}\r\n" : " a line}\r\n") + line + next}));
        rest = next;
        records.push_back(kept({.kind = RecordKind::Out, .time = now, .line = {2 * i}, .bytes = "STEP\r\n"}));
        if (i % 17 == 0)
            records.push_back(kept({.kind = RecordKind::Note, .time = now, .line = {2 * i}, .name = "fault"}));
    }
    records.push_back(kept({.kind = RecordKind::End, .time = 5s, .line = {400}}));
    return records;
}

/// What a session puts in front of a later part.
std::vector<Kept> sceneOf(int number, LineNumber line) {
    const std::string facts = "robot: R1\nstarted: later\nbegan: then\npart: " + std::to_string(number) +
                              "\nafter_s: " + std::to_string(number) + ".6\n";
    return {kept({.kind = RecordKind::Start, .line = line, .bytes = facts}),
            kept({.kind = RecordKind::Opened, .line = line, .bytes = "h:1"}),
            kept({.kind = RecordKind::In, .line = line, .bytes = "SEN {half"}),
            kept({.kind = RecordKind::Note, .line = line, .name = "robot", .bytes = "INIT {Name R1}"}),
            kept({.kind = RecordKind::Note, .line = line, .name = "behavior", .bytes = "again"}),
            kept({.kind = RecordKind::Note, .line = line, .name = "part"})};
}

void writeRecords(const QString& path, const std::vector<Kept>& records) {
    QByteArray text(recording::text_title.data(), static_cast<qsizetype>(recording::text_title.size()));
    std::string lines = "\n";
    for (const Kept& record : records)
        recording::appendText(lines, record.view());
    text += QByteArray::fromStdString(lines);
    QBuffer in(&text);
    QFile out(path);
    QVERIFY(in.open(QIODevice::ReadOnly) && out.open(QIODevice::WriteOnly));
    QVERIFY(textToRecording(in, path, out));
}

/// Writes the flight in parts that begin with these records, and returns its length by the replay.
void writeParts(const QString& path, const std::vector<std::size_t>& cuts) {
    const auto whole = flight();
    std::size_t from = 0;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
        const bool is_last = i == cuts.size();
        const std::size_t to = is_last ? whole.size() : cuts[i];
        const int number = static_cast<int>(i) + 1;
        const LineNumber line = from == 0 ? LineNumber{} : whole[from - 1].record.line;
        const RecordTime begin = from == 0 ? RecordTime{0} : whole[from - 1].record.time;
        std::vector<Kept> records = from == 0 ? std::vector<Kept>{} : sceneOf(number, line);
        for (std::size_t at = from; at < to; ++at) {
            records.push_back(whole[at]);
            records.back().record.time -= begin;
        }
        if (!is_last)
            records.push_back(
                kept({.kind = RecordKind::End, .time = records.back().record.time, .line = whole[to - 1].record.line}));
        writeRecords(is_last ? path : partPath(path, number), records);
        from = to;
    }
}

QStringList heardOf(const std::vector<Kept>& records, const QString& name) {
    QTemporaryDir folder;
    writeRecords(folder.filePath(name), records);
    return replayed(*RecordingReader::open(folder.filePath(name)));
}

} // namespace

class tst_RecordingParts : public QObject {
    Q_OBJECT
private slots:
    void init() { QVERIFY((folder_ = std::make_unique<QTemporaryDir>())->isValid()); }

    void aPartIsNamedAfterItsRecording_data() {
        QTest::addColumn<QString>("recording");
        QTest::addColumn<QString>("part");
        QTest::newRow("usual") << "/a/R1.usarrec"
                               << "/a/R1.part3.usarrec";
        QTest::newRow("dots") << "/a.b/R1.2.usarrec"
                              << "/a.b/R1.2.part3.usarrec";
        QTest::newRow("no suffix") << "/a.b/R1"
                                   << "/a.b/R1.part3";
        QTest::newRow("a name like a part's") << "R1.part2x.usarrec"
                                              << "R1.part2x.part3.usarrec";
        QTest::newRow("the name of a part") << "R1.part2.usarrec"
                                            << "R1.part2.part3.usarrec";
        QTest::newRow("a part as suffix") << "R1.part2"
                                          << "R1.part3.part2";
    }
    void aPartIsNamedAfterItsRecording() {
        QFETCH(const QString, recording);
        QFETCH(const QString, part);
        QCOMPARE(partPath(recording, 3), part);
        const auto name = readPartPath(part);
        QVERIFY(name);
        QCOMPARE(name->recording, recording);
        QCOMPARE(name->number, 3);
    }

    void anotherNameIsNotThatOfAPart_data() {
        QTest::addColumn<QString>("path");
        for (const char* name : {"R1.usarrec", "R1", "R1.part2x.usarrec", "R1.part0.usarrec", "R1.part02.usarrec",
                                 "R1.part2.a.usarrec", "/a.part3/R1.usarrec", "R1.part1234567890.usarrec"})
            QTest::newRow(name) << name;
    }
    void anotherNameIsNotThatOfAPart() {
        QFETCH(const QString, path);
        QVERIFY(!readPartPath(path));
    }

    void seamsAreNotHeard_data() {
        QTest::addColumn<QList<int>>("cuts");
        QTest::newRow("two parts") << QList<int>{100};
        QTest::newRow("where the link is lost") << QList<int>{212, 213, 214};
        QTest::newRow("after each other") << QList<int>{2, 3, 4, 5};
        Random random(7);
        for (int i = 0; i < 12; ++i) {
            QList<int> cuts;
            for (int at = 2; (at += 1 + static_cast<int>(uniform(random, 0.0, 120.0))) < 410;)
                cuts << at;
            QTest::addRow("random %d", i) << cuts;
        }
    }
    void seamsAreNotHeard() {
        QFETCH(const QList<int>, cuts);
        writeRecords(path("whole.usarrec"), flight());
        writeParts(path("cut.usarrec"), {cuts.begin(), cuts.end()});
        const QStringList whole = replayed(*RecordingReader::open(path("whole.usarrec")));
        QVERIFY(whole.size() > 600);
        for (const OpenMode mode : {OpenMode::Quick, OpenMode::Thorough}) {
            auto reader = RecordingReader::open(path("cut.usarrec"), mode);
            QVERIFY(reader);
            QCOMPARE((*reader)->survey().complaint(), std::string());
            QCOMPARE((*reader)->survey().facts.at("started"), std::string("then"));
            QCOMPARE((*reader)->survey().span, RecordTime(5s));
            PlayClock clock;
            ClockTable table;
            RecordTime play{0};
            for (const Kept& record : recordsIn(**reader)) {
                play = clock.at(record.view());
                if (record.record.kind == RecordKind::In && clock.now())
                    table.add(play, *clock.now());
            }
            QCOMPARE((*reader)->survey().play_span, play);
            for (double at_s = 0.1; at_s < 20.0; at_s += 0.7) {
                const auto moment = (*reader)->survey().clock.at(Seconds{at_s});
                QVERIFY(moment && std::chrono::abs(*moment - *table.at(Seconds{at_s})) <= 10ms);
            }
            (*reader)->seek(RecordTime{0});
            QCOMPARE(replayed(*std::move(reader)), whole);
        }
    }

    void seekingFindsTheFirstRecordNotEarlier() {
        writeParts(path("cut.usarrec"), {60, 200, 333});
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        const auto all = recordsIn(**reader);
        for (const RecordTime time : {0ms, 1ms, 580ms, 600ms, 1980ms, 2000ms, 3300ms, 4000ms, 4900ms, 5000ms}) {
            (*reader)->seek(time);
            const auto found = (*reader)->next();
            const auto wanted =
                std::ranges::find_if(all, [time](const Kept& record) { return record.record.time >= time; });
            QVERIFY(found && wanted != all.end());
            QCOMPARE(found->time, wanted->record.time);
        }
    }

    void partsThatAreGoneAreTold_data() {
        QTest::addColumn<QList<int>>("gone");
        QTest::addColumn<QString>("words");
        QTest::newRow("none") << QList<int>{} << "";
        QTest::newRow("the first") << QList<int>{1}
                                   << "The first part of this recording is missing, because cut.part1.usarrec is gone "
                                      "or elsewhere; it begins 3 s late.";
        QTest::newRow("one in the middle")
            << QList<int>{2}
            << "The first 2 parts of this recording are missing, because cut.part2.usarrec is gone or elsewhere; it "
               "begins 4 s late.";
        QTest::newRow("all") << QList<int>{1, 2, 3}
                             << "The first 3 parts of this recording are missing, because cut.part3.usarrec is gone or "
                                "elsewhere; it begins 5 s late.";
    }
    void partsThatAreGoneAreTold() {
        QFETCH(const QList<int>, gone);
        QFETCH(const QString, words);
        const std::vector<std::size_t> cuts{60, 200, 333};
        writeParts(path("cut.usarrec"), cuts);
        for (const int number : gone)
            QVERIFY(QFile::remove(partPath(path("cut.usarrec"), number)));
        auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(reader);
        QCOMPARE(QString::fromStdString((*reader)->survey().complaint()), words);
        QCOMPARE((*reader)->survey().missingParts(), words.toStdString());
        QCOMPARE((*reader)->survey().defects(), std::string());
        QStringList heard = replayed(*std::move(reader));
        const QStringList whole = heardOf(flight(), "whole");
        if (!gone.isEmpty()) {
            // The first part that is there tells the scene, and from then on everything is as in the whole.
            const std::size_t from = cuts[static_cast<std::size_t>(gone.last()) - 1];
            const auto records = flight();
            const QStringList before =
                heardOf({records.begin(), records.begin() + static_cast<std::ptrdiff_t>(from)}, "before");
            const QStringList scene{"opened 0 h:1",
                                    QString("note %1 INIT {Name R1}").arg(records[from - 1].record.line.value),
                                    QString("note %1 again").arg(records[from - 1].record.line.value),
                                    QString("note %1 ").arg(records[from - 1].record.line.value)};
            QCOMPARE(heard.mid(0, scene.size()), scene);
            QCOMPARE(heard.mid(scene.size()), whole.mid(before.size()));
        } else {
            QCOMPARE(heard, whole);
        }
    }

    void aPartThatCannotBeReadIsTold_data() {
        QTest::addColumn<QByteArray>("first");
        QTest::addColumn<QString>("why");
        QTest::newRow("empty") << QByteArray() << "cannot be read (the file is empty)";
        QTest::newRow("no recording") << QByteArray("my own notes")
                                      << "cannot be read (byte 0 does not begin a recording)";
    }
    void aPartThatCannotBeReadIsTold() {
        QFETCH(const QByteArray, first);
        QFETCH(const QString, why);
        writeParts(path("cut.usarrec"), {200});
        QFile file(path("cut.part1.usarrec"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(first) == first.size());
        file.close();
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(reader);
        QCOMPARE((*reader)->survey().parts_lost, 1);
        const QString told = QString::fromStdString((*reader)->survey().complaint());
        QVERIFY2(told.contains("because cut.part1.usarrec " + why), qPrintable(told));
    }

    /// A loss of power leaves such files, and so does a look in the quarter of a second behind a seam.
    void aNewestPartWithNothingInItLeavesTheOthers_data() {
        QTest::addColumn<QString>("newest");
        QTest::addColumn<QList<int>>("empty");
        QTest::addColumn<int>("left");
        QTest::addColumn<QString>("words");
        const QString nothing = "The end of this recording is missing, because nothing can be read in cut.usarrec (";
        QTest::newRow("missing") << "" << QList<int>{} << 3 << nothing + "No such file or directory).";
        QTest::newRow("empty") << "empty" << QList<int>{} << 3 << nothing + "the file is empty).";
        QTest::newRow("only a head") << "head" << QList<int>{} << 3
                                     << nothing + "it holds not one whole record after byte 12).";
        QTest::newRow("zeros") << "zeros" << QList<int>{} << 3 << nothing + "byte 0 does not begin a recording).";
        QTest::newRow("the one before, too")
            << "empty" << QList<int>{3} << 2 << nothing + "the file is empty), cut.part3.usarrec (the file is empty).";
        QTest::newRow("being written") << "locked" << QList<int>{} << 3 << "";
    }
    void aNewestPartWithNothingInItLeavesTheOthers() {
        QFETCH(const QString, newest);
        QFETCH(const QList<int>, empty);
        QFETCH(const int, left);
        QFETCH(const QString, words);
        const std::vector<std::size_t> cuts{60, 200, 333};
        writeParts(path("cut.usarrec"), cuts);
        QVERIFY(QFile::remove(path("cut.usarrec")));
        std::string bytes;
        if (newest == "head" || newest == "locked")
            recording::appendHead(bytes);
        else if (newest == "zeros")
            bytes.assign(4096, '\0');
        QFile file(path("cut.usarrec"));
        if (!newest.isEmpty())
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) &&
                    file.write(QByteArray::fromStdString(bytes)) >= 0);
        if (newest == "locked")
            QCOMPARE(::flock(file.handle(), LOCK_EX | LOCK_NB), 0);
        for (const int number : empty)
            QVERIFY(QFile::resize(partPath(path("cut.usarrec"), number), 0));
        auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY2(reader, reader ? "" : reader.error().text().c_str());
        QCOMPARE(QString::fromStdString((*reader)->survey().complaint()), words);
        QCOMPARE((*reader)->survey().being_written, newest == "locked");
        const auto records = flight();
        const auto end = records.begin() + static_cast<std::ptrdiff_t>(cuts[static_cast<std::size_t>(left) - 1]);
        QCOMPARE(replayed(*std::move(reader)), heardOf({records.begin(), end}, "before"));
    }

    void aFileThatCannotBeReadAndHasNoPartsIsAnError() {
        put("cut.part2.usarrec", "nothing of ours");
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(!reader);
        QCOMPARE(reader.error().where, path("cut.usarrec").toStdString());
    }

    void aFileBesideItThatOnlyHasTheNameIsNoPart_data() {
        QTest::addColumn<QString>("facts");
        QTest::newRow("began at another time") << "part: 3\nbegan: yesterday\n";
        QTest::newRow("another part") << "part: 2\nbegan: then\n";
        QTest::newRow("no part") << "robot: R1\n";
        QTest::newRow("no beginning") << "part: 3\n";
    }
    void aFileBesideItThatOnlyHasTheNameIsNoPart() {
        QFETCH(const QString, facts);
        writeParts(path("cut.usarrec"), {60, 200, 333});
        const QString third = partPath(path("cut.usarrec"), 3);
        QVERIFY(QFile::remove(third));
        const std::string text = facts.toStdString();
        writeRecords(third, {kept({.kind = RecordKind::Start, .bytes = text})});
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(reader);
        QCOMPARE((*reader)->survey().parts_lost, 3);
        QVERIFY((*reader)->survey().complaint().find("because cut.part3.usarrec is not a part of it") !=
                std::string::npos);
    }

    /// Facts without a beginning say nothing about what belongs together.
    void partsThatTellNoBeginningAreNotJoined() {
        writeRecords(path("cut.part1.usarrec"), {kept({.kind = RecordKind::Start, .bytes = "robot: R1\n"})});
        writeRecords(path("cut.usarrec"), {kept({.kind = RecordKind::Start, .bytes = "robot: R2\npart: 2\n"})});
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(reader);
        QCOMPARE((*reader)->survey().parts_lost, 1);
    }

    void aRecordingThatIsCalledLikeAPartIsNone() {
        writeRecords(path("cut.part2.usarrec"), flight());
        writeParts(path("cut.usarrec"), {}); // beside it
        const auto own = RecordingReader::open(path("cut.part2.usarrec"));
        QVERIFY(own);
        QCOMPARE((*own)->survey().complaint(), std::string());
        QCOMPARE((*own)->survey().files.size(), std::size_t(1));
        // It may have parts of its own, of which it is the second.
        QVERIFY(QFile::remove(path("cut.part2.usarrec")));
        writeParts(path("cut.part2.usarrec"), {200});
        const auto parts = RecordingReader::open(path("cut.part2.usarrec"));
        QVERIFY(parts);
        QCOMPARE((*parts)->survey().complaint(), std::string());
        QCOMPARE((*parts)->survey().files.front().file, std::string("cut.part2.part1.usarrec"));
    }

    void anEarlierPartOpensWithThoseBeforeIt() {
        writeParts(path("cut.usarrec"), {60, 200, 333});
        auto reader = RecordingReader::open(partPath(path("cut.usarrec"), 2));
        QVERIFY(reader);
        QCOMPARE((*reader)->survey().parts_lost, 0);
        QCOMPARE((*reader)->survey().complaint(), std::string("This is an earlier part of the recording cut.usarrec, "
                                                              "and what came after it is not read."));
        QCOMPARE((*reader)->survey().defects(), std::string());
        writeRecords(path("whole.usarrec"), flight());
        const QStringList whole = replayed(*RecordingReader::open(path("whole.usarrec")));
        const QStringList heard = replayed(*std::move(reader));
        QVERIFY(heard.size() > 200 && heard.size() < whole.size());
        QCOMPARE(heard, whole.mid(0, heard.size()));
    }

    void damageInAPartIsFoundWhereItIs() {
        writeParts(path("cut.usarrec"), {200});
        const auto size = static_cast<std::uint64_t>(QFileInfo(partPath(path("cut.usarrec"), 1)).size());
        std::string newest; // In a plain file, damage costs one record.
        doubles::appendOldHead(newest);
        for (const Kept& record : sceneOf(2, {}))
            doubles::appendPlain(newest, record.view());
        const std::size_t at = newest.size();
        for (int i = 0; i < 3; ++i)
            doubles::appendPlain(newest, {.kind = RecordKind::In, .bytes = "NFO\r\n"});
        newest[at + recording::record_head_bytes] ^= 1;
        QFile file(path("cut.usarrec"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray::fromStdString(newest)) > 0);
        file.close();
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(reader);
        QCOMPARE((*reader)->survey().damage.size(), std::size_t(1));
        QCOMPARE((*reader)->survey().damage.front().offset, size + at);
        const std::string words = "damaged, the first at byte " + std::to_string(at) + " of cut.usarrec, and left out.";
        QVERIFY((*reader)->survey().complaint().find(words) != std::string::npos);
        QVERIFY((*reader)->survey().defects().find(words) != std::string::npos);
        QBuffer text;
        QVERIFY(text.open(QIODevice::WriteOnly) && recordingToText(path("cut.usarrec"), text));
        const auto comment = QString("damaged bytes at byte %1 of cut.usarrec\n").arg(at);
        QVERIFY2(text.data().contains(comment.toUtf8()), text.data().right(2000).constData());
    }

    void onlyThePartThatIsReadTakesMemory() {
        const auto resident_bytes = [] {
            QFile file("/proc/self/statm");
            const bool open = file.open(QIODevice::ReadOnly);
            return open ? file.readAll().split(' ').value(1).toLongLong() * ::sysconf(_SC_PAGESIZE) : 0;
        };
        std::vector<std::size_t> cuts(40);
        std::iota(cuts.begin(), cuts.end(), 2);
        writeParts(path("cut.usarrec"), cuts);
        const auto before = resident_bytes();
        const auto reader = RecordingReader::open(path("cut.usarrec"));
        QVERIFY(reader);
        QCOMPARE((*reader)->survey().files.size(), std::size_t(41));
        QVERIFY(before > 0);
        QVERIFY(recordsIn(**reader).size() > 600);
        const auto grown = resident_bytes() - before;
        QVERIFY2(is_sanitized || grown < 20'000'000, qPrintable(QString::number(grown))); // A window has 2 MiB.
    }

    void aSeamWhoseNoteIsLostEndsWithTheNextLine() {
        PartSeam seam;
        QVERIFY(!seam.repeats({.kind = RecordKind::Start}));
        QVERIFY(!seam.repeats({.kind = RecordKind::In, .bytes = "NFO\r\n"}));
        QVERIFY(seam.repeats({.kind = RecordKind::Start, .line = {1}}));
        QVERIFY(seam.repeats({.kind = RecordKind::Note, .line = {1}, .name = "robot"}));
        QVERIFY(!seam.repeats({.kind = RecordKind::Out, .line = {2}}));
        QVERIFY(!seam.repeats({.kind = RecordKind::Note, .line = {1}, .name = "fault"}));
    }

    void onlyWhatWasSetAsideIsDeletedAndOldestFirst() {
        constexpr std::uint64_t limit = 100'000'000;
        auto newest = put("r.usarrec", "first");
        auto parts = RecordingParts::at(path("r.usarrec"));
        QVERIFY(parts);
        for (int number = 1; number <= 9; ++number) {
            QVERIFY(parts->setAside(newest->handle(), 10'000'000, Seconds(number)));
            newest = put("r.usarrec", "part");
            QCOMPARE(parts->number(), number + 1);
            QVERIFY(!parts->makeRoom(1, limit)); // Another part still fits.
        }
        QCOMPARE(parts->bytes(5), std::uint64_t(90'000'005));
        QVERIFY(QFile::remove(path("r.part2.usarrec")));
        put("r.part2.usarrec", "somebody else's"); // At a place that was ours.
        QVERIFY(parts->setAside(newest->handle(), 10'000'000, Seconds(10)));
        put("r.usarrec", "newest");
        const auto dropped = parts->makeRoom(1, limit);
        QVERIFY(dropped && *dropped);
        QCOMPARE((*dropped)->path, path("r.part1.usarrec").toStdString());
        QCOMPARE((*dropped)->end, Seconds(1));
        QVERIFY((*dropped)->deleted);
        QVERIFY(!QFile::exists(path("r.part1.usarrec")));
        QVERIFY(!parts->makeRoom(1, limit));
        const auto refused = parts->makeRoom(10'000'001, limit);
        QVERIFY(refused && !*refused);
        QCOMPARE(refused->error().where, path("r.part2.usarrec").toStdString());
        QVERIFY(QFile::exists(path("r.part2.usarrec")));
        QVERIFY(!parts->makeRoom(10'000'001, limit));
        QVERIFY(QFile::rename(path("r.part3.usarrec"), path("kept.usarrec"))); // Somebody wants it.
        const auto moved = parts->makeRoom(1, 1);
        QVERIFY(moved && *moved && !(*moved)->deleted);
        while (const auto more = parts->makeRoom(1, 1))
            QVERIFY(*more && (*more)->deleted);
        QCOMPARE(QDir(folder_->path()).entryList(QDir::Files),
                 (QStringList{"kept.usarrec", "r.part2.usarrec", "r.usarrec"}));
    }

    void aPartOfAnotherRecordingIsNotWrittenOver() {
        put("r.part7.usarrec", "older");
        const auto refused = RecordingParts::at(path("r.usarrec"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().where, path("r.part7.usarrec").toStdString());
        QVERIFY(QFile::remove(path("r.part7.usarrec")));
        auto parts = RecordingParts::at(path("r.usarrec"));
        QVERIFY(parts);
        const auto ours = put("r.usarrec", "ours");
        put("r.part1.usarrec", "came later");
        QVERIFY(!parts->setAside(ours->handle(), 1, Seconds(1)));
        QVERIFY(QFile::exists(path("r.usarrec")));
        QFile other(path("r.part1.usarrec"));
        QVERIFY(other.open(QIODevice::ReadOnly));
        QCOMPARE(other.readAll(), QByteArray("came later"));
    }

    void aFileThatSomebodyElsePutThereIsLeftAlone() {
        const auto ours = put("r.usarrec", "ours");
        auto parts = RecordingParts::at(path("r.usarrec"));
        QVERIFY(parts);
        QVERIFY(QFile::remove(path("r.usarrec")));
        const auto gone = parts->setAside(ours->handle(), 4, Seconds(1));
        QVERIFY(!gone);
        QCOMPARE(gone.error().where, path("r.usarrec").toStdString());
        put("r.usarrec", "another");
        QVERIFY(!parts->setAside(ours->handle(), 4, Seconds(1)));
        QVERIFY(!QFile::exists(path("r.part1.usarrec")));
        QVERIFY(QFile::remove(path("r.usarrec")));
        put("elsewhere.usarrec", "another");
        QVERIFY(QFile::link(path("elsewhere.usarrec"), path("r.usarrec")));
        const auto link = parts->setAside(ours->handle(), 4, Seconds(1));
        QVERIFY(!link);
        QVERIFY(link.error().what.find("another file") != std::string::npos);
        QVERIFY(QFileInfo(path("r.usarrec")).isSymLink());
        QCOMPARE(parts->number(), 1);
    }

    void aPartWhoseNextCannotBeginGetsItsNameBack() {
        const auto ours = put("r.usarrec", "ours");
        auto parts = RecordingParts::at(path("r.usarrec"));
        QVERIFY(parts && parts->setAside(ours->handle(), 4, Seconds(1)));
        QVERIFY(parts->takeBack());
        QVERIFY(QFile::exists(path("r.usarrec")));
        QCOMPARE(parts->number(), 1);
        QCOMPARE(parts->bytes(0), std::uint64_t(0));
        QVERIFY(parts->setAside(ours->handle(), 4, Seconds(1)));
        put("r.usarrec", "another");
        const auto refused = parts->takeBack();
        QVERIFY(!refused);
        QCOMPARE(refused.error().where, path("r.part1.usarrec").toStdString());
        QVERIFY(QFile::exists(path("r.part1.usarrec")));
    }

    void aLinkInThePlaceOfAPartIsLeftAlone() {
        const auto ours = put("r.usarrec", "ours");
        auto parts = RecordingParts::at(path("r.usarrec"));
        QVERIFY(parts && parts->setAside(ours->handle(), 4, Seconds(1)));
        QVERIFY(QFile::rename(path("r.part1.usarrec"), path("kept.usarrec")));
        QVERIFY(QFile::link(path("kept.usarrec"), path("r.part1.usarrec")));
        const auto refused = parts->makeRoom(1, 1);
        QVERIFY(refused && !*refused);
        QVERIFY(QFileInfo(path("r.part1.usarrec")).isSymLink());
        QVERIFY(QFile::exists(path("kept.usarrec")));
    }

    /// Some file systems set the time of a file when it is closed.
    void aPartIsKnownByItsTimeOnceItIsClosed_data() {
        QTest::addColumn<bool>("replaced"); ///< by somebody else's file
        QTest::addColumn<bool>("noted");
        QTest::addColumn<bool>("deleted");
        QTest::newRow("as it was closed") << false << true << true;
        QTest::newRow("changed afterward") << false << false << false;
        QTest::newRow("another file") << true << true << false;
    }
    void aPartIsKnownByItsTimeOnceItIsClosed() {
        QFETCH(const bool, replaced);
        QFETCH(const bool, noted);
        QFETCH(const bool, deleted);
        const auto ours = put("r.usarrec", "ours"); // Stays open, so that its inode is not used again.
        auto parts = RecordingParts::at(path("r.usarrec"));
        QVERIFY(parts && parts->setAside(ours->handle(), 4, Seconds(1)));
        QFile aside(path("r.part1.usarrec"));
        if (replaced)
            QVERIFY(aside.remove());
        QVERIFY(aside.open(QIODevice::ReadWrite));
        QVERIFY(aside.setFileTime(QDateTime::fromSecsSinceEpoch(1), QFileDevice::FileModificationTime));
        aside.close();
        if (noted)
            parts->noteClosed();
        const auto dropped = parts->makeRoom(1, 1);
        QVERIFY(dropped);
        QCOMPARE(dropped->has_value(), deleted);
        QCOMPARE(aside.exists(), !deleted);
    }

    void aPartIsFullAtATenthOfTheLimitOrTwiceItsBeginning_data() {
        QTest::addColumn<quint64>("newest");
        QTest::addColumn<quint64>("head");
        QTest::addColumn<bool>("full");
        QTest::newRow("nearly") << quint64(9'999'999) << quint64(0) << false;
        QTest::newRow("a tenth") << quint64(10'000'000) << quint64(5'000'000) << true;
        QTest::newRow("a long beginning") << quint64(10'000'000) << quint64(6'000'000) << false;
        QTest::newRow("twice a long beginning") << quint64(12'000'000) << quint64(6'000'000) << true;
    }
    void aPartIsFullAtATenthOfTheLimitOrTwiceItsBeginning() {
        QFETCH(const quint64, newest);
        QFETCH(const quint64, head);
        QTEST(RecordingParts::isFull(newest, head, 100'000'000), "full");
    }

private:
    QString path(const char* name) const { return folder_->filePath(name); }
    /// Returns the file, which stays open.
    std::unique_ptr<QFile> put(const char* name, const char* text) const {
        auto file = std::make_unique<QFile>(path(name));
        if (!file->open(QIODevice::WriteOnly | QIODevice::Unbuffered) || file->write(text) <= 0)
            return nullptr;
        return file;
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_RecordingParts)

} // namespace tst_recording_parts

#include "tst_recording_parts.moc"
