#include "core/mission/files/run_marker.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/doubles/crashed_run.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_run_marker {

using namespace usar::mission;
using usar::doubles::leaveAsIfKilled;
using usar::doubles::writeAll;

class tst_RunMarker : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        for (const char* name : {"R1.usarrec", "R2.usarrec"})
            writeAll(file(name).toStdString(), "x");
    }

    void anOrderlyEndLeavesNothing() {
        {
            const RunMarker marker(marks());
            marker.setRecordings({file("R1.usarrec")});
            QCOMPARE(QDir(marks()).entryList(QDir::Files).size(), 2);
        }
        QVERIFY(QDir(marks()).entryList(QDir::Files).isEmpty());
        QVERIFY(RunMarker::takeAbandoned(marks()).isEmpty());
    }

    void whatRunsIsNotAbandoned() {
        const RunMarker marker(marks());
        marker.setRecordings({file("R1.usarrec")});
        QVERIFY(RunMarker::takeAbandoned(marks()).isEmpty());
        QCOMPARE(QDir(marks()).entryList(QDir::Files).size(), 2);
    }

    void whatAKilledProcessRecordedIsFoundOnce() {
        const QStringList recordings{file("R1.usarrec"), file("R2.usarrec")};
        QVERIFY(leaveAsIfKilled(marks(), recordings));
        const RunMarker next(marks());
        QCOMPARE(RunMarker::takeAbandoned(marks()), recordings);
        QVERIFY(RunMarker::takeAbandoned(marks()).isEmpty());
    }

    void aRecordingThatWasDeletedIsNotFound() {
        QVERIFY(leaveAsIfKilled(marks(), {file("gone.usarrec"), file("R2.usarrec")}));
        QCOMPARE(RunMarker::takeAbandoned(marks()), QStringList{file("R2.usarrec")});
    }

    void withoutAFolderThereIsNoMark() {
        const QString nowhere = file("R1.usarrec") + "/running"; // In a file there is no folder.
        const RunMarker marker(nowhere);
        marker.setRecordings({file("R2.usarrec")});
        QVERIFY(RunMarker::takeAbandoned(nowhere).isEmpty());
    }

private:
    QString marks() const { return folder_->filePath("running"); }
    QString file(const QString& name) const { return folder_->filePath(name); }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_RunMarker)

} // namespace tst_run_marker

#include "tst_run_marker.moc"
