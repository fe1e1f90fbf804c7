// What is written into a recording, and when, without a connection.
#include <algorithm>
#include <functional>
#include <future>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/link/recording_reader.h"
#include "core/mission/session/record_keeping.h"
#include "tests/mission/session/session_parts.h"
#include "tests/suite/suite.h"

namespace tst_record_keeping {

using namespace usar;
using namespace usar::mission;
using link::RecordKind;

namespace {

struct Keeping : test::NoticeBook {
    QString path() const { return folder.filePath("a.usar"); }
    /// Ends the recording and reads it: "kind line name bytes".
    QStringList written() {
        records.end();
        auto recording = link::RecordingReader::open(path());
        QStringList texts;
        if (!recording)
            return texts;
        facts = (*recording)->survey().facts;
        while (const auto record = (*recording)->next())
            if (record->kind != RecordKind::Start && record->kind != RecordKind::End)
                texts << QString("%1 %2 %3 %4")
                             .arg(static_cast<int>(record->kind))
                             .arg(record->line.value)
                             .arg(QString::fromStdString(std::string(record->name)),
                                  QString::fromStdString(std::string(record->bytes)));
        return texts;
    }
    static RecordingScene connected() {
        RecordingScene scene;
        scene.link.host = "sim";
        scene.link.port = 3000;
        scene.link.state = link::LinkState::Connected;
        scene.cell_size_m = 0.25;
        return scene;
    }

    /// Waits until everything so far is on the disk.
    void flush() {
        std::promise<void> flushed;
        records.flush([&flushed] { flushed.set_value(); });
        flushed.get_future().wait();
    }

    /// Calls `act` while the writer's thread stands, as if the disk were slow.
    void whileTheDiskIsBusy(const std::function<void()>& act) {
        std::promise<void> let_go;
        std::promise<void> stands;
        records.flush([&] {
            stands.set_value();
            let_go.get_future().wait();
        });
        stands.get_future().wait();
        act();
        let_go.set_value();
        flush();
    }

    QTemporaryDir folder;
    QObject thread_owner;
    Incoming incoming;
    int looks = 0;
    std::map<std::string, std::string> facts;
    RecordingScene scene{};
    RecordKeeping records{thread_owner, notices, incoming, [this] { return scene; }, [this] { ++looks; }};
};

/// Letters that cannot be compressed by much.
void appendNoise(std::string& text, int bytes, Random& random) {
    for (int i = 0; i < bytes / 8; ++i)
        for (auto [eight, left] = std::pair(random(), 8); left > 0; --left, eight >>= 8)
            text += static_cast<char>('!' + (eight & 0xff) % 90);
}

std::uint64_t bytesIn(const QString& folder, const QString& names) {
    std::uint64_t bytes = 0;
    for (const QFileInfo& file : QDir(folder).entryInfoList({names}, QDir::Files))
        bytes += static_cast<std::uint64_t>(file.size());
    return bytes;
}

} // namespace

class tst_RecordKeeping : public QObject {
    Q_OBJECT
private slots:
    void withoutARecordingNothingIsKept() {
        Keeping k;
        k.records.opened("sim:3000");
        k.records.received("NFO\r\n");
        k.records.noteFault("wind");
        QVERIFY(!k.records.on());
        QVERIFY(k.records.path().isEmpty());
        QVERIFY(!k.records.figures());
        k.records.look();
        QVERIFY(k.said.empty());
    }

    void everythingIsWrittenInItsOrder() {
        Keeping k;
        QVERIFY(k.records.begin(k.path(), {}));
        QCOMPARE(k.records.path(), k.path());
        QVERIFY(k.records.figures() && k.records.figures()->bytes > 0);
        k.records.opened("sim:3000");
        k.records.received("STA {Time 1.00}\r\n");
        k.incoming.take("STA {Time 1.00}");
        k.records.sent({by::Session{"lockstep"}, {1}}, "STEP");
        k.records.noteFault("wind");
        k.records.noteFinished({true, "Done."});
        k.records.closed("gone");
        QCOMPARE(k.written(),
                 (QStringList{"2 0  sim:3000", "4 0  STA {Time 1.00}\r\n", "5 1 session: lockstep STEP\r\n",
                              "6 1 fault wind", "6 1 finished 1 Done.", "3 1  gone"}));
    }

    void theFactsSayWhereItWas() {
        Keeping k;
        k.scene = Keeping::connected();
        k.scene.level = "tall_test";
        QVERIFY(k.records.begin(k.path(), {{"robot", "R1"}}));
        QCOMPARE(k.written(), QStringList{"2 0  sim:3000"});
        QCOMPARE(k.facts["robot"], std::string("R1"));
        QCOMPARE(k.facts["host"], std::string("sim"));
        QCOMPARE(k.facts["port"], std::string("3000"));
        QCOMPARE(k.facts["cell_size_m"], std::string("0.25"));
        QCOMPARE(k.facts["level"], std::string("tall_test"));
        QVERIFY(k.facts.contains("started"));
    }

    void aLateRecordingBeginsWithWhatItsReaderCannotKnow() {
        Keeping k;
        agent::BehaviorStatus status;
        status.state = "scanning";
        k.records.notePublished(status, true);
        k.records.notePublished(agent::CurrentGoal{}, false); // of no behavior that runs here
        ScanRecord record;
        record.behavior_id = "airrobot/cpp";
        record.robot_name = "R1";
        record.marks.emplace_back();
        k.scene = Keeping::connected();
        k.scene.pending = "SEN {Ti";
        k.scene.robot = protocol::Init{"USARBot.AirRobot", "R1"};
        k.scene.of_behavior = &record;
        QVERIFY(k.records.begin(k.path(), {}));
        const QStringList texts = k.written();
        QCOMPARE(texts.size(), 6);
        QCOMPARE(texts[0], QString("2 0  sim:3000"));
        QCOMPARE(texts[1], QString("4 0  SEN {Ti"));
        QVERIFY(texts[2].startsWith("6 0 robot INIT {ClassName USARBot.AirRobot} {Name R1}"));
        QCOMPARE(texts[3], QString("6 0 behavior airrobot/cpp\tR1\t0 0 0 0"));
        QVERIFY(texts[4].startsWith("6 0 published ")); // the mark
        QVERIFY(texts[5].contains("scanning"));
    }

    void aLimitIsKeptFromTheFirstWarningOn() {
        constexpr std::uint64_t limit = 10'000'000;
        Keeping k;
        k.scene = Keeping::connected();
        k.scene.robot = protocol::Init{"USARBot.AirRobot", "R1"};
        k.records.setLimit(limit);
        QVERIFY(k.records.begin(k.path(), {{"robot", "R1"}}));
        QFile foreign(k.folder.filePath("b.part1.usar"));
        QVERIFY(foreign.open(QIODevice::WriteOnly) && foreign.write("not ours") > 0);
        foreign.close();
        Random random(3);
        std::uint64_t most = 0;
        int lines = 0;
        for (; lines < 1000; ++lines) {
            std::string line = "SEN {" + std::to_string(lines) + ' ';
            appendNoise(line, 30'000, random);
            k.records.received(line + "\r\n");
            k.incoming.take(line);
            if (lines % 10 == 0) {
                k.flush();
                k.records.look();
                k.flush(); // The writer's thread cuts and deletes.
                most = std::max(most, bytesIn(k.folder.path(), "a*"));
            }
        }
        QVERIFY(most <= limit + 300'000); // What came since the last look.
        QVERIFY(most > limit * 8 / 10);
        QVERIFY(k.records.figures() && k.records.figures()->limit_bytes == limit);
        k.flush();
        QCOMPARE(k.records.figures()->bytes, bytesIn(k.folder.path(), "a*"));
        QCOMPARE(k.said.front().severity, Severity::Warning);
        QVERIFY(k.said.front().text.find("its oldest part is deleted") != std::string::npos);
        QVERIFY(k.said.size() > 5);
        QVERIFY(std::all_of(k.said.begin() + 1, k.said.end(), [](const Notice& notice) {
            return notice.severity == Severity::Note && notice.text.find("was deleted") != std::string::npos;
        }));
        k.records.end();
        QVERIFY(QFile::exists(foreign.fileName()));
        const auto reader = link::RecordingReader::open(k.path());
        QVERIFY(reader);
        QVERIFY((*reader)->survey().ended);
        QCOMPARE((*reader)->survey().parts_lost, static_cast<int>(k.said.size()) - 1);
        std::uint64_t newest = 0;
        link::PartSeam seam;
        while (const auto record = (*reader)->next()) {
            if (seam.repeats(*record) || record->kind != RecordKind::In)
                continue;
            QVERIFY(newest == 0 || record->line.value == newest + 1); // Nothing is missing between the parts.
            newest = record->line.value;
        }
        QCOMPARE(newest, static_cast<std::uint64_t>(lines - 1));
    }

    void aLimitThatIsSetLateDeletesNothingAtOnce_data() {
        QTest::addColumn<quint64>("limit_percent"); ///< of what is recorded
        QTest::newRow("far beyond it") << quint64(0);
        QTest::newRow("just beyond it") << quint64(98);
        QTest::newRow("at 95 %") << quint64(105);
        QTest::newRow("at 85 %") << quint64(118);
    }
    void aLimitThatIsSetLateDeletesNothingAtOnce() {
        QFETCH(const quint64, limit_percent);
        Keeping k;
        QVERIFY(k.records.begin(k.path(), {}));
        Random random(3);
        std::string noise;
        appendNoise(noise, 14'000'000, random);
        k.records.received(noise);
        k.flush();
        k.records.look();
        QVERIFY(!k.records.figures()->limit_bytes && k.said.empty());
        const std::uint64_t limit = k.records.figures()->bytes * limit_percent / 100;
        k.records.setLimit(limit);
        QCOMPARE(k.records.figures()->limit_bytes,
                 RecordingLimit(std::max(limit, link::RecordingParts::least_limit_bytes)));
        for (int looks = 0; looks < 5; ++looks) {
            k.records.look();
            k.flush();
        }
        QCOMPARE(k.said.size(), std::size_t(1)); // The warning, with time to object.
        QVERIFY(k.said.front().text.find("In about 60 s") != std::string::npos);
        QVERIFY(QFile::exists(k.folder.filePath("a.part1.usar")));
        k.records.setLimit(std::nullopt);
        QVERIFY(!k.records.figures()->limit_bytes);
        k.records.end();
        const auto reader = link::RecordingReader::open(k.path());
        QVERIFY(reader);
        QVERIFY((*reader)->survey().bytes_in >= noise.size()); // Nothing of it is lost.
        QCOMPARE((*reader)->survey().parts_lost, 0);
    }

    void aLimitThatIsRaisedCallsOffADeletion_data() {
        QTest::addColumn<quint64>("other_limit"); ///< set while the disk is busy; 0: none
        QTest::addColumn<bool>("deleted");
        QTest::newRow("it stays") << quint64(link::RecordingParts::least_limit_bytes) << true;
        QTest::newRow("it is raised") << quint64(3 * link::RecordingParts::least_limit_bytes) << false;
        QTest::newRow("it is taken away") << quint64(0) << false;
    }
    void aLimitThatIsRaisedCallsOffADeletion() {
        QFETCH(const quint64, other_limit);
        QFETCH(const bool, deleted);
        Keeping k;
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        Random random(3);
        const auto record_a_part = [&] {
            std::string noise;
            appendNoise(noise, 1'300'000, random);
            k.records.received(noise);
            k.flush();
        };
        for (int parts = 0; parts < 12 && k.said.empty(); ++parts) {
            record_a_part();
            k.records.look();
            k.flush();
        }
        QCOMPARE(k.said.size(), std::size_t(1)); // the warning
        record_a_part();
        k.whileTheDiskIsBusy([&] {
            k.records.look();
            k.records.setLimit(other_limit > 0 ? RecordingLimit(other_limit) : std::nullopt);
        });
        QCOMPARE(QFile::exists(k.folder.filePath("a.part1.usar")), !deleted);
        k.records.setLimit(std::nullopt);
        k.records.look(); // What was deleted is said without a limit, too.
        const bool said = k.said.back().text.find("was deleted to keep the limit") != std::string::npos;
        QCOMPARE(said, deleted);
    }

    void aPartThatCannotBeginEndsTheRecordingWithAReason_data() {
        QTest::addColumn<QString>("in_the_way"); ///< file that somebody makes during the recording
        QTest::addColumn<QString>("words");
        QTest::newRow("at its next name") << "a.part1.usar"
                                          << "a.part1.usar: ";
        QTest::newRow("in its place") << "a.usar"
                                      << "this is another file than the part that was written there";
    }
    void aPartThatCannotBeginEndsTheRecordingWithAReason() {
        QFETCH(const QString, in_the_way);
        QFETCH(const QString, words);
        Keeping k;
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        const QString moved = k.folder.filePath("moved.usar");
        QFile foreign(k.folder.filePath(in_the_way));
        if (foreign.exists())
            QVERIFY(QFile::rename(k.path(), moved));
        QVERIFY(foreign.open(QIODevice::WriteOnly) && foreign.write("not ours") > 0);
        foreign.close();
        Random random(3);
        std::string noise;
        appendNoise(noise, 1'500'000, random);
        k.records.received(noise);
        k.flush();
        k.records.look();
        k.flush();
        k.records.look();
        QVERIFY(!k.records.on());
        QCOMPARE(k.said.size(), std::size_t(1));
        QCOMPARE(k.said.front().severity, Severity::Error);
        QVERIFY2(k.said.front().text.find(words.toStdString()) != std::string::npos, k.said.front().text.c_str());
        QCOMPARE(bytesIn(k.folder.path(), in_the_way), std::uint64_t(8));
        const auto reader = link::RecordingReader::open(QFile::exists(moved) ? moved : k.path());
        QVERIFY(reader && (*reader)->survey().ended);
        QVERIFY((*reader)->survey().bytes_in == noise.size());
    }

    /// The disk is busy with the parts, and the session does not wait for it: what it records meanwhile is in its
    /// order.
    void aSeamDoesNotKeepTheSessionWaiting() {
        Keeping k;
        k.scene = Keeping::connected();
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        Random random(3);
        std::string noise;
        appendNoise(noise, 1'500'000, random);
        k.records.received(noise);
        k.flush();
        k.whileTheDiskIsBusy([&] {
            k.records.received("before\r\n");
            k.records.look();
            for (int i = 0; i < 1000; ++i)
                k.records.received("behind " + std::to_string(i) + "\r\n");
            QVERIFY(!QFile::exists(k.folder.filePath("a.part1.usar")));
            k.records.look(); // The seam is still to come, so that there is no second one.
        });
        QVERIFY(QFile::exists(k.folder.filePath("a.part1.usar")));
        QVERIFY(!QFile::exists(k.folder.filePath("a.part2.usar")));
        const QStringList texts = k.written();
        const auto before = texts.indexOf("4 0  before\r\n");
        QVERIFY(before > 0);
        QCOMPARE(texts.mid(before + 1, 3), (QStringList{"2 0  sim:3000", "6 0 part ", "4 0  behind 0\r\n"}));
        QCOMPARE(texts.size(), before + 1 + 2 + 1000);
        QCOMPARE(texts.last(), QString("4 0  behind 999\r\n"));
    }

    /// Otherwise the part would have to be twice as large as all of that.
    void whatComesWhileTheDiskIsBusyIsNotCountedAsItsBeginning() {
        Keeping k;
        k.scene = Keeping::connected();
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        Random random(3);
        std::string noise;
        appendNoise(noise, 1'500'000, random);
        k.records.received(noise);
        k.flush();
        k.whileTheDiskIsBusy([&] {
            k.records.look();
            k.records.received(noise);
        });
        QVERIFY(QFile::exists(k.folder.filePath("a.part1.usar")));
        k.records.look();
        k.flush();
        QVERIFY(QFile::exists(k.folder.filePath("a.part2.usar")));
        k.records.end();
        const auto reader = link::RecordingReader::open(k.path());
        QVERIFY(reader && (*reader)->survey().complaint().empty());
        QVERIFY((*reader)->survey().bytes_in == 2 * noise.size());
        std::uint64_t read = 0;
        while (const auto record = (*reader)->next())
            read += record->kind == RecordKind::In ? record->bytes.size() : 0;
        QCOMPARE(read, (*reader)->survey().bytes_in);
    }

    void faultsThatStillHoldAreInLaterParts() {
        Keeping k;
        k.scene = Keeping::connected();
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        k.records.noteFault("1.0 s: fault begins: wind speed=5");
        k.records.noteFault("2.0 s: fault begins: gps lost");
        k.records.noteFault("3.0 s: fault begins: wind speed=5"); // once more
        k.records.noteFault("4.0 s: fault ends: gps lost");
        k.records.noteFault("4.0 s: fault ends: wind speed=5");
        Random random(3);
        std::string noise;
        appendNoise(noise, 1'500'000, random);
        k.records.received(noise);
        k.flush();
        k.records.look();
        k.records.noteFault("5.0 s: fault begins: gps lost");
        const QStringList all = k.written();
        QStringList faults = all.filter("6 0 fault ");
        QCOMPARE(faults.size(), 7);
        QCOMPARE(faults[5], QString("6 0 fault 3.0 s: fault begins: wind speed=5"));
        const auto whole = link::RecordingReader::open(k.path());
        QVERIFY(whole && (*whole)->survey().files.size() == 2);
        link::PartSeam seam;
        int heard = 0;
        while (const auto record = (*whole)->next())
            heard += !seam.repeats(*record) && record->name == "fault" ? 1 : 0;
        QCOMPARE(heard, 6);
        QVERIFY(QFile::remove(k.folder.filePath("a.part1.usar")));
        k.facts.clear();
        QCOMPARE(k.written().filter("6 0 fault ").size(), 2); // The part alone knows of the wind.
    }

    /// A trace that can be compressed takes little of the file.
    void aBeginningCountsAsItIsOnTheDisk() {
        Keeping k;
        k.scene = Keeping::connected();
        ScanRecord record;
        record.behavior_id = "a plan";
        k.scene.of_behavior = &record;
        k.records.notePublished(agent::PlanTrace{std::string(5'000'000, 'a')}, true);
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        k.flush();
        QVERIFY(k.records.figures()->bytes < 100'000);
        Random random(3);
        std::string noise;
        appendNoise(noise, 1'500'000, random);
        k.records.received(noise);
        k.flush();
        k.records.look();
        k.flush();
        QVERIFY(QFile::exists(k.folder.filePath("a.part1.usar")));
    }

    void aBeginningMayBeLongerThanTheBuffer() {
        Keeping k;
        k.scene = Keeping::connected();
        ScanRecord record;
        record.behavior_id = "a plan";
        k.scene.of_behavior = &record;
        k.records.notePublished(agent::PlanTrace{std::string(70'000'000, 'a')}, true); // The buffer has 64 MiB.
        k.records.setLimit(link::RecordingParts::least_limit_bytes);
        QVERIFY(k.records.begin(k.path(), {}));
        k.records.received("NFO\r\n");
        k.flush();
        k.records.look();
        QVERIFY(k.records.on());
        QCOMPARE(k.written().last(), QString("4 0  NFO\r\n"));
        QCOMPARE(k.said.size(), std::size_t(0));
    }

    void aFileThatExistsIsLeftAlone() {
        Keeping k;
        QVERIFY(k.records.begin(k.path(), {}));
        k.records.end();
        QVERIFY(!k.records.begin(k.path(), {}));
        QVERIFY(!k.records.on());
    }
};

USAR_TEST(tst_RecordKeeping)

} // namespace tst_record_keeping

#include "tst_record_keeping.moc"
