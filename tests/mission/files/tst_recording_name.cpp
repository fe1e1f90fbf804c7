#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/files/result_writer.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_recording_name {

using namespace usar::mission;

namespace {

const QDateTime moment(QDate(2026, 11, 21), QTime(18, 21, 29));

} // namespace

class tst_RecordingName : public QObject {
    Q_OBJECT
private slots:
    void saysWhoAndWhen_data() {
        QTest::addColumn<QString>("robot_name");
        QTest::addColumn<QString>("file_name");
        QTest::newRow("a plain name") << "R1"
                                      << "R1_2026-11-21_18-21-29.usarrec";
        QTest::newRow("signs that stay") << "my-robot_2"
                                         << "my-robot_2_2026-11-21_18-21-29.usarrec";
        QTest::newRow("signs that do not") << "../a b:c"
                                           << "___a_b_c_2026-11-21_18-21-29.usarrec";
    }

    void saysWhoAndWhen() {
        QFETCH(QString, robot_name);
        QFETCH(QString, file_name);
        const QTemporaryDir folder;
        QCOMPARE(newRecordingIn(folder.path(), robot_name, moment), folder.filePath(file_name));
    }

    void neverNamesAFileThatIsThere() {
        const QTemporaryDir folder;
        for (const char* end : {"", "_2", "_3"}) {
            const QString path = newRecordingIn(folder.path(), "R1", moment);
            QCOMPARE(path, folder.filePath(QString("R1_2026-11-21_18-21-29%1.usarrec").arg(end)));
            usar::doubles::writeAll(path.toStdString(), "x");
        }
    }
};

USAR_TEST(tst_RecordingName)

} // namespace tst_recording_name

#include "tst_recording_name.moc"
