// Texts of faults and files of snapshots: what is read, and what is said about the rest.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/server/embedded/simulator_files.h"
#include "tests/suite/suite.h"

namespace tst_simulator_files {

using namespace usar;
using namespace usar::server;

class tst_SimulatorFiles : public QObject {
    Q_OBJECT
private slots:
    void faultsAreReadInTheirOrder() {
        const auto faults = readFaults({"wind speed=5 from=60", "link_cut robot=R1"});
        QVERIFY2(faults, faults ? "" : faults.error().text().c_str());
        QCOMPARE(faults->size(), 2u);
        QVERIFY((*faults)[0].kind == sim::FaultKind::Wind);
        QCOMPARE((*faults)[0].from.count(), 60.0);
        QCOMPARE((*faults)[0].number("speed"), 5.0);
        QVERIFY((*faults)[1].kind == sim::FaultKind::LinkCut);
        QCOMPARE((*faults)[1].robot, std::string("R1"));
        QCOMPARE(readFaults({})->size(), 0u);
    }

    void theFirstTextThatIsNoFaultIsNamed_data() {
        QTest::addColumn<QStringList>("texts");
        QTest::addColumn<QString>("said");
        QTest::newRow("an unknown kind") << QStringList{"wnid speed=5"} << "fault \"wnid speed=5\": ";
        QTest::newRow("its nearest kind") << QStringList{"wnid speed=5"} << "'wind'";
        QTest::newRow("the second") << QStringList{"link_cut", "rainbow", "unicorn"} << "fault \"rainbow\": ";
        QTest::newRow("an unknown key") << QStringList{"wind sped=5"} << "'speed'";
        QTest::newRow("a number that is none") << QStringList{"wind speed=fast"} << "'fast' is not a valid speed";
        QTest::newRow("nothing") << QStringList{""} << "fault \"\": ";
    }
    void theFirstTextThatIsNoFaultIsNamed() {
        QFETCH(QStringList, texts);
        QFETCH(QString, said);
        const auto faults = readFaults(texts);
        QVERIFY(!faults);
        const QString text = QString::fromStdString(faults.error().text());
        QVERIFY2(text.contains(said), qPrintable(text));
        QVERIFY(!faults.error().mend.empty());
    }

    void whatWasWrittenIsReadBack() {
        for (const sim::FaultDescription& kind : sim::faultKinds()) {
            const QString text(QString::fromStdString(std::string(kind.word)) + " from=12.5 for=3" +
                               (kind.word == std::string_view("sensor_bias") ? " by=2" : ""));
            const auto faults = readFaults({text});
            QVERIFY2(faults, faults ? "" : faults.error().text().c_str());
            const auto again = readFaults({QString::fromStdString(sim::write(faults->front()))});
            QVERIFY(again);
            QVERIFY(again->front() == faults->front());
        }
    }

    void theHelpNamesEveryKindWithItsNumbersAndTheirRanges() {
        const auto entries = faultSection().entries;
        QCOMPARE(entries.size(), qsizetype(sim::faultKinds().size()));
        qsizetype at = 0;
        for (const sim::FaultDescription& kind : sim::faultKinds()) {
            const auto& [word, line] = entries[at++];
            QCOMPARE(word, QString::fromStdString(std::string(kind.word)));
            for (const sim::FaultNumber& number : kind.numbers) {
                const QString words = QString("; %1=%2 (%3 to %4")
                                          .arg(QString::fromStdString(std::string(number.name)))
                                          .arg(number.usual)
                                          .arg(number.smallest)
                                          .arg(number.largest);
                QVERIFY2(line.contains(words), qPrintable(line));
            }
        }
    }

    void textsBecomeAListInTheirOrder() {
        QCOMPARE(textsOf({}), QStringList());
        QCOMPARE(textsOf({"b", "", "größer"}), (QStringList{"b", "", "größer"}));
    }

    void whatIsNoSnapshotIsRefusedWithItsFile_data() {
        QTest::addColumn<bool>("is_there");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("said");
        QTest::newRow("no file") << false << QByteArray() << "cannot read the snapshot: ";
        QTest::newRow("an empty one") << true << QByteArray() << "line 1: this is not a snapshot";
        QTest::newRow("a text") << true << QByteArray("hello\nworld\n") << "line 1: this is not a snapshot";
        QTest::newRow("garbage") << true << QByteArray(5000, '\xff') << "line 1: this is not a snapshot";
    }
    void whatIsNoSnapshotIsRefusedWithItsFile() {
        QFETCH(bool, is_there);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, said);
        const QTemporaryDir folder;
        const QString path = folder.filePath("run.snapshot");
        if (is_there) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            QCOMPARE(file.write(bytes), qint64(bytes.size()));
        }
        const auto resumed = resumeSimulation(path, nullptr);
        QVERIFY(!resumed);
        const QString text = QString::fromStdString(resumed.error().text());
        QVERIFY2(text.startsWith(path + ": " + said), qPrintable(text));
        QVERIFY(!resumed.error().mend.empty());
    }
};

USAR_TEST(tst_SimulatorFiles)

} // namespace tst_simulator_files

#include "tst_simulator_files.moc"
