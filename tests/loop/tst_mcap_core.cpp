// An exported flight, read by Foxglove's own reader of MCAP files.
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/doubles/mcap_file.h"
#include "tests/doubles/test_files.h"
#include "tests/loop/mcap_flight.h"
#include "tests/suite/suite.h"

namespace tst_mcap_core {

using namespace usar;

namespace {

/// The reader that is known to work, and a validator of JSON Schemas.
const QStringList packages{"@mcap/core@2.2.2", "ajv@8.17.1"};

struct Ended {
    bool well = false;
    QByteArray out;
    QByteArray err;
};

Ended run(const QString& folder, const QString& name, const QStringList& arguments) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(name, arguments);
    const bool ended = process.waitForFinished(240'000);
    return {ended && process.exitCode() == 0, process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

/// Needs node, and npm with a registry from which it can install the reader.
class tst_McapCore : public QObject {
    Q_OBJECT
private slots:
    void itReadsTheFileWhole() {
        for (const char* needed : {"node", "npm"})
            if (QStandardPaths::findExecutable(needed).isEmpty())
                QSKIP(qPrintable(QString("%1 is not installed, and with it the reader @mcap/core").arg(needed)));
        const QTemporaryDir folder;
        const Ended installed =
            run(folder.path(), "npm", QStringList{"install", "--no-audit", "--no-fund", "--ignore-scripts"} + packages);
        if (!installed.well)
            QSKIP(qPrintable("npm cannot install @mcap/core, as without a network: " + installed.err.left(300)));
        QVERIFY(loop::flySmallMission(folder.path()));
        QCOMPARE(loop::exportMcap(folder.filePath("r.usarrec"), folder.filePath("r.mcap")), QString());
        // Modules are looked for beside the script.
        QVERIFY(QFile::copy(USAR_SOURCE_DIR "/tests/data/mcap/read_whole.mjs", folder.filePath("read_whole.mjs")));
        const Ended read = run(folder.path(), "node", {"read_whole.mjs", "r.mcap"});
        QVERIFY2(read.well, read.err);
        const QJsonObject told = QJsonDocument::fromJson(read.out).object();
        std::string trouble;
        const auto file = doubles::readMcap(doubles::readAll(folder.filePath("r.mcap").toStdString()), trouble);
        QVERIFY2(file, trouble.c_str());
        for (const char* way : {"indexed", "streamed"}) {
            const QJsonObject topics = told[way].toObject();
            qsizetype messages = 0;
            for (const QString& topic : topics.keys()) {
                QCOMPARE(std::size_t(topics[topic].toInt()), file->of(topic.toStdString()).size());
                messages += topics[topic].toInt();
            }
            QCOMPARE(messages, qsizetype(file->messages.size()));
        }
        QCOMPARE(told["invalid"].toString(), QString());
    }
};

USAR_TEST(tst_McapCore)

} // namespace tst_mcap_core

#include "tst_mcap_core.moc"
