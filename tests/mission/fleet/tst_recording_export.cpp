// Recordings exported in the background: the ends are told, and a cancelled one leaves nothing.
#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_format.h"
#include "core/mission/fleet/recording_export.h"
#include "tests/doubles/mcap_file.h"
#include "tests/doubles/plain_recording.h"
#include "tests/doubles/test_files.h"
#include "tests/doubles/two_flights.h"
#include "tests/suite/suite.h"

namespace tst_recording_export {

using namespace usar;
using namespace usar::mission;

namespace {

/// So many lines that an export takes a while.
std::string longRecording() {
    std::string file;
    doubles::appendOldHead(file);
    for (int line = 0; line < 200'000; ++line)
        doubles::appendPlain(
            file, {.kind = link::RecordKind::In,
                   .time = std::chrono::milliseconds(line),
                   .line = {static_cast<std::uint64_t>(line)},
                   .bytes = "SEN {Time " + std::to_string(line / 1000.0) + "} {Type IR} {Name I Range 0.5}\r\n"});
    return file;
}

} // namespace

class tst_RecordingExport : public QObject {
    Q_OBJECT
private slots:
    void exportsOneAfterTheOther() {
        doubles::writeAll(path("a.usarrec").toStdString(), doubles::twoFlights());
        RecordingExport exporter;
        QSignalSpy done(&exporter, &RecordingExport::done), refused(&exporter, &RecordingExport::refused);
        exporter.begin(path("a.usarrec"), path("a.mcap"));
        exporter.begin(path("none.usarrec"), path("none.mcap"));
        exporter.begin(path("a.usarrec"), path("a.mcap")); // It is replaced.
        QVERIFY(exporter.busy());
        QTRY_VERIFY(!exporter.busy());
        QCOMPARE(done.size(), 2);
        QCOMPARE(done.front().at(0).toString(), path("a.mcap"));
        QVERIFY(done.front().at(1).toString().contains("not ended in order"));
        QCOMPARE(refused.size(), 1);
        QVERIFY(refused.front().at(0).toString().contains("none.usarrec"));
        QCOMPARE(refused.front().at(1).toBool(), false);
        std::string trouble;
        QVERIFY(doubles::readMcap(doubles::readAll(path("a.mcap").toStdString()), trouble));
    }

    void aCancelledOneLeavesNothing() {
        doubles::writeAll(path("long.usarrec").toStdString(), longRecording());
        RecordingExport exporter;
        QSignalSpy refused(&exporter, &RecordingExport::refused), progressed(&exporter, &RecordingExport::progressed);
        exporter.begin(path("long.usarrec"), path("long.mcap"));
        QTRY_VERIFY(!progressed.empty());
        exporter.cancel();
        QTRY_VERIFY(!exporter.busy());
        QCOMPARE(refused.size(), 1);
        QCOMPARE(refused.front().at(1).toBool(), true);
        QVERIFY(remains().isEmpty());
    }

    void theEndOfTheProgramGivesItUp() {
        doubles::writeAll(path("long.usarrec").toStdString(), longRecording());
        {
            RecordingExport exporter;
            QSignalSpy progressed(&exporter, &RecordingExport::progressed);
            exporter.begin(path("long.usarrec"), path("long.mcap"));
            QTRY_VERIFY(!progressed.empty());
        }
        QVERIFY(remains().isEmpty());
    }

private:
    QString path(const char* name) const { return folder_.filePath(name); }
    QStringList remains() const { return QDir(folder_.path()).entryList({"long.mcap*"}, QDir::Files | QDir::Hidden); }

    QTemporaryDir folder_;
};

USAR_TEST(tst_RecordingExport)

} // namespace tst_recording_export

#include "tst_recording_export.moc"
