#include <unistd.h>

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/version.h"
#include "core/campaign/runs/shard_file.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_slurm {

using namespace usar;
using namespace usar::campaign;

namespace {

const QString program = QString(USAR_BINARY_DIR) + "/bin/usar-mission";
constexpr int runs = 400;

} // namespace

/// A cluster of two nodes on this machine flies a campaign. It needs Debian's slurm-wlm, and root for the namespaces.
class tst_Slurm : public QObject {
    Q_OBJECT
private slots:
    void everyRunIsThereOnceThoughANodeDies() {
        const QStringList system_programs{"/usr/sbin", "/usr/bin"};
        for (const char* needed : {"slurmctld", "slurmd", "sbatch", "unshare", "ip"})
            if (QStandardPaths::findExecutable(needed, system_programs).isEmpty())
                QSKIP(qPrintable(QString("%1 is not installed; apt-get install slurm-wlm iproute2").arg(needed)));
        if (::geteuid() != 0)
            QSKIP("only root can make the namespaces that keep the cluster apart from this machine's own");
        const QTemporaryDir folder;
        doubles::writeAll(doubles::pathOf(folder) / "small.json",
                          R"({ "name": "Small", "area": { "x": -4, "y": -3, "width": 8, "height": 6 } })");
        doubles::writeAll(doubles::pathOf(folder) / "many.json",
                          R"({ "name": "Many", "missions": ["small.json"], "seeds": 200, "variants": [
                               { "name": "C++", "behavior": "airrobot/cpp" },
                               { "name": "POSH", "behavior": "airrobot/posh" }] })");
        const QString results = folder.filePath("results");
        QProcess script;
        script.setWorkingDirectory(folder.path());
        script.start(program, {"campaign", "--slurm", "8", "many.json", "--out", results});
        QVERIFY(script.waitForFinished());
        doubles::writeAll(doubles::pathOf(folder) / "job.sh", script.readAllStandardOutput().toStdString());

        QProcess box;
        box.setProcessChannelMode(QProcess::MergedChannels);
        box.start("unshare", {"--net", "--mount", "--pid", "--fork", "--mount-proc", "--kill-child", "sh",
                              USAR_SOURCE_DIR "/tests/data/campaign/slurm_box.sh", folder.filePath("box"),
                              USAR_SOURCE_DIR "/tests/data/campaign/slurm.conf", folder.filePath("job.sh"), results,
                              QString::number(runs / 4 + 20)}); // Both nodes are in the middle of a part.
        const bool ended = box.waitForFinished(1'500'000);
        const QByteArray said = box.readAll();
        QVERIFY2(ended && box.exitCode() == 0, said);
        const auto all = readResults(results, std::string(version()));
        QVERIFY2(all, all ? "" : all.error().text().c_str());
        QCOMPARE(all->size(), std::size_t(runs));
        qsizetype lines = 0;
        for (int i = 0; i < 8; ++i) {
            QFile shard(results + QString("/shard-%1.jsonl").arg(i, 3, 10, QChar('0')));
            QVERIFY2(shard.open(QIODevice::ReadOnly), qPrintable(shard.fileName()));
            lines += shard.readAll().count('\n');
        }
        QCOMPARE(lines, qsizetype(runs)); // none twice
        for (const RunResult& result : *all)
            QVERIFY2(result.outcome == Outcome::Done, result.reason.c_str());
        QVERIFY2(said.contains("killed n2 with") && said.contains("requeue"), said);
    }
};

USAR_TEST(tst_Slurm)

} // namespace tst_slurm

#include "tst_slurm.moc"
