// How soon a moment of a long recording is found, in wall-clock time.
#include <chrono>
#include <string>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_format.h"
#include "core/link/recording_reader.h"
#include "tests/doubles/plain_recording.h"
#include "tests/suite/suite.h"

namespace tst_recording_timing {

using namespace usar::link;
using namespace std::chrono_literals;

class tst_RecordingTiming : public QObject {
    Q_OBJECT
private slots:
    void anHourIsSoughtInATenthOfASecond();
};

void tst_RecordingTiming::anHourIsSoughtInATenthOfASecond() {
    std::string bytes;
    usar::doubles::appendOldHead(bytes);
    const std::string tick(500, 's');
    for (int i = 0; i < 36000; ++i)
        usar::doubles::appendPlain(bytes, {.kind = RecordKind::In, .time = 100ms * i, .bytes = tick});
    const QTemporaryDir folder;
    QFile file(folder.filePath("hour.usarrec"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(QByteArray::fromStdString(bytes)), qint64(bytes.size()));
    file.close();
    const auto reader = RecordingReader::open(file.fileName());
    QVERIFY(reader);
    QElapsedTimer timer;
    for (const auto minute : {59min, 1min, 30min, 0min, 58min}) {
        timer.start();
        (*reader)->seek(minute);
        const auto record = (*reader)->next();
        QVERIFY(record && record->time == minute);
        QVERIFY2(timer.elapsed() < 100, qPrintable(QString::number(timer.elapsed())));
    }
}

USAR_TEST(tst_RecordingTiming)

} // namespace tst_recording_timing

#include "tst_recording_timing.moc"
