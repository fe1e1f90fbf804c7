// A real flight, exported as MCAP by the program `usar-mission`.
#include <algorithm>

#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_reader.h"
#include "tests/doubles/mcap_file.h"
#include "tests/doubles/plain_recording.h"
#include "tests/doubles/test_files.h"
#include "tests/loop/mcap_flight.h"
#include "tests/suite/suite.h"

namespace tst_usar_mcap {

using namespace usar;

namespace {

long residentPeak_kB(qint64 process) {
    QFile status(QString("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    const QByteArray text = status.readAll();
    const qsizetype at = text.indexOf("VmHWM:");
    return at < 0 ? 0 : text.mid(at + 6, text.indexOf("kB", at) - at - 6).trimmed().toLong();
}

struct Exported {
    long peak_kB = 0; ///< of the program's memory
    qint64 bytes = 0;
};

/// Exports to a pipe, so that the program cannot be ahead of the look at its memory.
Exported exportAndWatch(const QString& recording, const QString& pipe) {
    Exported exported;
    ::unlink(pipe.toLocal8Bit().constData());
    if (::mkfifo(pipe.toLocal8Bit().constData(), 0600) != 0)
        return exported;
    QProcess process;
    process.start("sh", {"-c", "exec \"$0\" recording-to-mcap \"$1\" - >\"$2\"", loop::program, recording, pipe});
    if (!process.waitForStarted())
        return exported;
    QFile output(pipe);
    if (!output.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return exported;
    QByteArray bytes(1 << 16, '\0');
    while (const qint64 count = std::max<qint64>(output.read(bytes.data(), bytes.size()), 0)) {
        exported.bytes += count;
        exported.peak_kB = std::max(exported.peak_kB, residentPeak_kB(process.processId()));
    }
    process.waitForFinished();
    return exported;
}

/// The recording, and again and again behind it, as if the robot had connected so many times.
std::string repeated(const QString& recording, int times) {
    std::string file;
    doubles::appendOldHead(file);
    link::RecordTime begin{0};
    const auto reader = link::RecordingReader::open(recording);
    for (int time = 0; time < times && reader; ++time) {
        (*reader)->seek(link::RecordTime{0});
        while (auto record = (*reader)->next()) {
            record->time += begin;
            if (record->kind != link::RecordKind::End && (time == 0 || record->kind != link::RecordKind::Start))
                doubles::appendPlain(file, *record);
        }
        begin += (*reader)->survey().span;
    }
    return file;
}

} // namespace

class tst_UsarMcap : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(loop::flySmallMission(folder_.path()));
        QCOMPARE(loop::exportMcap(path("r.usarrec"), path("r.mcap")), QString());
    }

    void everythingOfTheFlightIsInTheFile() {
        std::string trouble;
        const auto file = doubles::readMcap(doubles::readAll(path("r.mcap").toStdString()), trouble);
        QVERIFY2(file, trouble.c_str());
        const auto reader = link::RecordingReader::open(path("r.usarrec"));
        QCOMPARE(file->of("/R1/command").size(), std::size_t((*reader)->survey().commands));
        QVERIFY(file->of("/R1/scan/Scanner1").size() > 100);
        QCOMPARE(file->of("/R1/range/F1").size() + file->of("/R1/range/M0").size(),
                 file->of("/R1/scan/Scanner1").size());
        QVERIFY(file->of("/R1/pose").size() >= file->of("/R1/pose/INS").size());
        QCOMPARE(file->of("/R1/pose").size(), file->of("/R1/transform").size());
        QCOMPARE(file->of("/R1/mount/Scanner1").size(), std::size_t(1));
        QVERIFY(file->of("/R1/map").size() >= 2 && !file->of("/R1/path").empty() && !file->of("/log").empty());
        std::uint64_t last_ns = 0;
        for (const doubles::McapMessage& message : file->messages) {
            QVERIFY(message.logged_ns >= last_ns && message.published_ns <= message.logged_ns);
            last_ns = message.logged_ns;
        }
        QVERIFY(file->messages.front().logged_ns < 1'000'000'000);
    }

    void standardOutputGetsTheSameBytes() {
        QProcess process;
        process.start(loop::program, {"recording-to-mcap", path("r.usarrec"), "-"});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(process.readAllStandardOutput().toStdString() == doubles::readAll(path("r.mcap").toStdString()));
    }

    void whatIsCutOffIsSaidByTheExitCode() {
        const std::string whole = doubles::readAll(path("r.usarrec").toStdString());
        doubles::writeAll(path("cut.usarrec").toStdString(), whole.substr(0, whole.size() / 2));
        QProcess process;
        process.start(loop::program, {"recording-to-mcap", path("cut.usarrec"), path("cut.mcap")});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("cut.usarrec: The recording was not ended in order"));
        std::string trouble;
        QVERIFY(doubles::readMcap(doubles::readAll(path("cut.mcap").toStdString()), trouble));
    }

    void refusalsNameTheFileAndTheMend_data() {
        QTest::addColumn<QString>("recording");
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("no such file") << "none.usarrec"
                                      << "x.mcap" << QByteArray("none.usarrec: ");
        QTest::newRow("over a file") << "r.usarrec"
                                     << "small.json" << QByteArray("left alone");
        QTest::newRow("no folder") << "r.usarrec"
                                   << "none/x.mcap" << QByteArray("none/x.mcap: cannot write");
    }

    void refusalsNameTheFileAndTheMend() {
        QFETCH(QString, recording);
        QFETCH(QString, file);
        QFETCH(QByteArray, words);
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(loop::program, {"recording-to-mcap", recording, file});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 2);
        const QByteArray said = process.readAllStandardError();
        QVERIFY2(said.contains(words) && said.count('\n') == 1, said);
        QVERIFY(!QFile::exists(path("x.mcap")));
    }

    void aRecordingTenTimesAsLongTakesNoMoreMemory() {
        doubles::writeAll(path("long.usarrec").toStdString(), repeated(path("r.usarrec"), 10));
        const Exported once = exportAndWatch(path("r.usarrec"), path("pipe"));
        const Exported ten = exportAndWatch(path("long.usarrec"), path("pipe"));
        QVERIFY2(once.peak_kB > 1000 && once.bytes > 1'000'000, qPrintable(QString::number(once.peak_kB)));
        QVERIFY2(ten.bytes > 8 * once.bytes, qPrintable(QString("%1, %2").arg(once.bytes).arg(ten.bytes)));
        QVERIFY2(ten.peak_kB - once.peak_kB < ten.bytes / 1000 / 5,
                 qPrintable(QString("%1 kB, %2 kB").arg(once.peak_kB).arg(ten.peak_kB)));
    }

private:
    QString path(const char* name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
};

USAR_TEST(tst_UsarMcap)

} // namespace tst_usar_mcap

#include "tst_usar_mcap.moc"
