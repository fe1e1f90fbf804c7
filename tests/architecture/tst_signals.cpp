// A test that signals a process that has ended must not end all other tests: see tests/suite/signaling.h.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_signals {

class tst_Signals : public QObject {
    Q_OBJECT
private slots:
    void testsSignalThroughTheOneFunctionThatSparesGroups();
};

void tst_Signals::testsSignalThroughTheOneFunctionThatSparesGroups() {
    static const QRegularExpression bare(":{2}kill(pg)?\\(");
    QStringList found;
    int seen = 0;
    QDirIterator files(USAR_SOURCE_DIR "/tests", {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        // Plugins are no tests, and a bad one kills itself on purpose.
        if (file.fileName().contains("/tests/plugins/"))
            continue;
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
        if (!bare.match(QString::fromUtf8(file.readAll())).hasMatch())
            continue;
        ++seen;
        if (!file.fileName().endsWith("/tests/suite/signaling.h"))
            found << file.fileName() + ": send signals by test::sendSignal, which spares groups of processes";
    }
    QCOMPARE(seen - static_cast<int>(found.size()), 1); // it finds what it looks for
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

USAR_TEST(tst_Signals)

} // namespace tst_signals

#include "tst_signals.moc"
