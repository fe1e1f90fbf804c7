// Snapshot files that are damaged: each is refused with its line and what is wrong, or reads as what it says.
#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/snapshot.h"
#include "tests/suite/suite.h"

namespace tst_snapshot_file {

using namespace usar;
using namespace usar::sim;

namespace {

Snapshot example() {
    return {.options = {.seed = 18446744073709551615u,
                        .profile = protocol::Dialect::Udk,
                        .tick = Seconds{0.1},
                        .physics_steps_per_tick = 25,
                        .battery_life = Seconds{1200.5},
                        .noise = false,
                        .faults = {readFault("wind speed=5").value(), readFault("link_cut from=3").value()},
                        .world_source = "tall test"},
            .ticks = 12,
            .digest = 77,
            .journal = {{JournalEntry::Kind::Connect, 0, 1, ""},
                        {JournalEntry::Kind::Receive, 0, 1, "INIT {ClassName P2DX}\r\n"},
                        {JournalEntry::Kind::Receive, 3, 1, std::string("\0\n\xff c 0 1 0\n", 12)},
                        {JournalEntry::Kind::AddFault, 4, 0, "link_delay by=1"},
                        {JournalEntry::Kind::EndFault, 5, 2, ""},
                        {JournalEntry::Kind::Release, 6, 1, ""},
                        {JournalEntry::Kind::Disconnect, 7, 1, ""},
                        {JournalEntry::Kind::Resume, 12, 0, ""}}};
}

QString good() {
    return QString::fromLatin1(write(example()));
}

/// The result for a file in which one text is another.
Result<Snapshot> readWith(const QString& from, const QString& to) {
    return readSnapshot(good().replace(from, to).toLatin1().toStdString());
}

void damage(const char* row, const char* from, const char* to, int line, const char* what) {
    QTest::newRow(row) << QString(from) << QString(to) << line << QString(what);
}

} // namespace

class tst_SnapshotFile : public QObject {
    Q_OBJECT

private slots:
    void everythingIsKept() {
        const auto back = readSnapshot(write(example()));
        QVERIFY2(back, back ? "" : back.error().text().c_str());
        QVERIFY(*back == example());
        QVERIFY(readSnapshot(write(Snapshot{})).value() == Snapshot{});
    }

    void namesTheLineAndWhatIsWrong_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("what");
        damage("a word nobody knows", "\nnoise off", "\nnoises off", 8, "unknown word 'noises'");
        damage("an empty line", "\nnoise off", "\n", 8, "unknown word ''");
        damage("a seed below zero", "seed 1844", "seed -1844", 3, "'-18446744073709551615' is not a valid seed");
        damage("a seed that is too long", "551615\n", "5516150\n", 3, "'184467440737095516150' is not a valid seed");
        damage("a seed with more after it", "551615\n", "551615 3\n", 3,
               "'18446744073709551615 3' is not a valid seed");
        damage("a seed in hexadecimal", "seed 18446744073709551615", "seed 0x12", 3, "'0x12' is not a valid seed");
        damage("no seed", "seed 18446744073709551615", "seed", 3, "'' is not a valid seed");
        damage("a tick of no length", "tick_s 0.1", "tick_s 0", 5, "'0' is not a valid time");
        damage("a tick back in time", "tick_s 0.1", "tick_s -0.1", 5, "'-0.1' is not a valid time");
        damage("a tick that is no number", "tick_s 0.1", "tick_s nan", 5, "'nan' is not a valid time");
        damage("an endless tick", "tick_s 0.1", "tick_s inf", 5, "'inf' is not a valid time");
        damage("half a step", "per_tick 25", "per_tick 2.5", 6, "'2.5' is not a valid number of steps");
        damage("one step too many", "per_tick 25", "per_tick 10001", 6, "'10001' is not a valid number of steps");
        damage("an empty battery", "life_s 1200.5", "life_s 0", 7, "'0' is not a valid time");
        damage("one tick too many", "ticks 12\n", "ticks 100000001\n", 11,
               "'100000001' is not a valid number of ticks");
        damage("a digest of letters", "digest 77", "digest abc", 12, "'abc' is not a valid digest");
        damage("no number of entries", "journal 8", "journal", 13, "'' is not a valid number of entries");
        damage("a kind of two letters", "\nc 0 1 0\n\nr", "\ncc 0 1 0\n\nr", 14, "'cc' is not a kind of entry");
        damage("a kind nobody knows", "\nc 0 1 0\n\nr", "\nx 0 1 0\n\nr", 14, "'x' is not a kind of entry");
        damage("a tick of letters", "\nc 0 1 0\n\nr", "\nc o 1 0\n\nr", 14, "'o' is not a valid tick");
        damage("a client of letters", "\nc 0 1 0\n\nr", "\nc 0 l 0\n\nr", 14, "'l' is not a valid client");
        damage("no count of bytes", "\nc 0 1 0\n\nr", "\nc 0 1\n\nr", 14, "'' is not a valid count of bytes");
    }
    void namesTheLineAndWhatIsWrong() {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const int, line);
        QFETCH(const QString, what);
        QCOMPARE(good().count(from), 1);
        const auto snapshot = readWith(from, to);
        QVERIFY(!snapshot);
        QCOMPARE(QString::fromStdString(snapshot.error().what), what);
        QCOMPARE(QString::fromStdString(snapshot.error().where), QString("snapshot, line %1").arg(line));
        QCOMPARE(snapshot.error().mend, std::string("Choose a file that Save snapshot has written"));
    }

    void saysWhatIsWrongWithAFault() {
        const auto snapshot = readWith("fault wind", "fault wild");
        QVERIFY(!snapshot);
        QVERIFY(snapshot.error() == readFault("wild speed=5").error());
    }

    void bytesMustBeAsManyAsCounted_data() {
        QTest::addColumn<QString>("to");
        QTest::newRow("one more") << "\nr 0 1 24\n";
        QTest::newRow("two fewer") << "\nr 0 1 21\n";
        QTest::newRow("beyond the file") << "\nr 0 1 2300\n";
        QTest::newRow("all that a number can say") << "\nr 0 1 18446744073709551615\n";
    }
    void bytesMustBeAsManyAsCounted() {
        QFETCH(const QString, to);
        const auto snapshot = readWith("\nr 0 1 23\n", to);
        QVERIFY(!snapshot);
        QCOMPARE(snapshot.error().what, std::string("the file is cut short, or bytes are missing"));
    }

    void moreEntriesThanThereAreAreMissed() {
        const auto snapshot = readWith("journal 8", "journal 18446744073709551615");
        QVERIFY(!snapshot);
        QCOMPARE(snapshot.error().what, std::string("the file is cut short"));
    }

    void isNoSnapshot_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("empty") << QString();
        QTest::newRow("a blank line") << QString("\n");
        QTest::newRow("another version") << good().replace("snapshot 1\n", "snapshot 2\n");
        QTest::newRow("other line ends") << good().replace("snapshot 1\n", "snapshot 1\r\n");
        QTest::newRow("a first line that does not end") << QString("USARSim snapshot 1");
        QTest::newRow("something before it") << "\n" + good();
    }
    void isNoSnapshot() {
        QFETCH(const QString, file);
        const auto snapshot = readSnapshot(file.toLatin1().toStdString());
        QVERIFY(!snapshot);
        QCOMPARE(snapshot.error().what, std::string("this is not a snapshot"));
    }

    void mayHaveBlanksAroundItsValues() {
        const auto snapshot = readWith("ticks 12\n", "ticks \t 12 \r\n");
        QVERIFY2(snapshot, snapshot ? "" : snapshot.error().text().c_str());
        QVERIFY(*snapshot == example());
    }

    void everyCutInTheJournalIsNoticed() {
        const std::string file = write(example());
        for (std::size_t length = file.find("\njournal ") + 2; length < file.size(); ++length) {
            const auto snapshot = readSnapshot(std::string_view(file).substr(0, length));
            QVERIFY2(!snapshot, qPrintable(QString::number(length)));
        }
    }

    void aWrongByteIsNoticedOrTaken() {
        const std::string file = write(example());
        Random random = seeded(21, 1);
        int refused = 0;
        for (int i = 0; i < 3000; ++i) {
            std::string damaged = file;
            damaged[random() % damaged.size()] = static_cast<char>(random() & 0xff);
            const auto snapshot = readSnapshot(damaged);
            if (!snapshot) {
                ++refused;
                QVERIFY(!snapshot.error().what.empty() && !snapshot.error().where.empty());
                continue;
            }
            const auto again = readSnapshot(write(*snapshot));
            QVERIFY2(again && *again == *snapshot, qPrintable(QString::number(i)));
        }
        QVERIFY(refused > 1000);
    }
};

USAR_TEST(tst_SnapshotFile)

} // namespace tst_snapshot_file

#include "tst_snapshot_file.moc"
