// Runs that are written down must come out as they are written, byte for byte: ours, and those of the folders that
// USAR_POSH_TRACES names.
#include <QFileInfo>
#include <QTest>

#include "tests/posh/trace_vector.h"
#include "tests/suite/suite.h"

namespace tst_golden_traces {

class tst_GoldenTraces : public QObject {
    Q_OBJECT
private slots:
    void comeOutAsWritten_data();
    void comeOutAsWritten();
};

void tst_GoldenTraces::comeOutAsWritten_data() {
    QTest::addColumn<QString>("file");
    QStringList folders{USAR_SOURCE_DIR "/tests/data/posh/traces"};
    folders += qEnvironmentVariable("USAR_POSH_TRACES").split(':', Qt::SkipEmptyParts);
    for (const QString& folder : folders) {
        const QStringList files = traceVectorFiles(folder);
        QVERIFY2(!files.isEmpty(), qPrintable(folder + " has no traces"));
        for (const QString& file : files)
            QTest::addRow("%s", qPrintable(file)) << file;
    }
}

void tst_GoldenTraces::comeOutAsWritten() {
    QFETCH(QString, file);
    const TraceVector vector = readTraceVector(file);
    const QStringList ours = QString::fromStdString(runVector(vector)).split('\n');
    const QStringList expected = QString::fromStdString(vector.expected).split('\n');
    for (qsizetype i = 0; i < std::max(ours.size(), expected.size()); ++i)
        QCOMPARE(ours.value(i), expected.value(i));
}

USAR_TEST(tst_GoldenTraces)

} // namespace tst_golden_traces

#include "tst_golden_traces.moc"
