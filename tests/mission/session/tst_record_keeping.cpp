// What is written into a recording, and when, without a connection.
#include <QTemporaryDir>
#include <QTest>

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

    QTemporaryDir folder;
    QObject thread_owner;
    Incoming incoming;
    int looks = 0;
    std::map<std::string, std::string> facts;
    RecordKeeping records{thread_owner, notices, incoming, [this] { ++looks; }};
};

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
        QVERIFY(k.records.begin(k.path(), {}, {}));
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
        RecordingScene scene = Keeping::connected();
        scene.level = "tall_test";
        QVERIFY(k.records.begin(k.path(), {{"robot", "R1"}}, scene));
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
        RecordingScene scene = Keeping::connected();
        scene.pending = "SEN {Ti";
        scene.robot = protocol::Init{"USARBot.AirRobot", "R1"};
        scene.of_behavior = &record;
        QVERIFY(k.records.begin(k.path(), {}, scene));
        const QStringList texts = k.written();
        QCOMPARE(texts.size(), 6);
        QCOMPARE(texts[0], QString("2 0  sim:3000"));
        QCOMPARE(texts[1], QString("4 0  SEN {Ti"));
        QVERIFY(texts[2].startsWith("6 0 robot INIT {ClassName USARBot.AirRobot} {Name R1}"));
        QCOMPARE(texts[3], QString("6 0 behavior airrobot/cpp\tR1\t0 0 0 0"));
        QVERIFY(texts[4].startsWith("6 0 published ")); // the mark
        QVERIFY(texts[5].contains("scanning"));
    }

    void aFileThatExistsIsLeftAlone() {
        Keeping k;
        QVERIFY(k.records.begin(k.path(), {}, {}));
        k.records.end();
        QVERIFY(!k.records.begin(k.path(), {}, {}));
        QVERIFY(!k.records.on());
    }
};

USAR_TEST(tst_RecordKeeping)

} // namespace tst_record_keeping

#include "tst_record_keeping.moc"
