// What a person does with the Debian packages, done in a clean Debian 12: install, fly, look, build a robot, remove.
#include <unistd.h>

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_debian_packages {

namespace {

const QString source = USAR_SOURCE_DIR;

} // namespace

/// Making them takes half an hour and installing them packages from the network, so that is done only when it is asked
/// for (label long). USAR_DEB_FOLDER names a folder with packages that are made already.
class tst_DebianPackages : public QObject {
    Q_OBJECT
private slots:
    void areInstalledUsedAndRemovedInACleanTree();
};

void tst_DebianPackages::areInstalledUsedAndRemovedInACleanTree() {
    const QStringList system_programs{"/usr/sbin", "/usr/bin"};
    for (const char* needed : {"mmdebstrap", "unshare", "readelf"})
        if (QStandardPaths::findExecutable(needed, system_programs).isEmpty())
            QSKIP(qPrintable(QString("%1 is not installed; apt-get install mmdebstrap binutils").arg(needed)));
    if (::geteuid() != 0)
        QSKIP("only root can make a clean Debian tree and change into it");
    const QTemporaryDir folder;
    QString packages = qEnvironmentVariable("USAR_DEB_FOLDER");
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    if (packages.isEmpty()) {
        packages = folder.filePath("packages");
        process.start(source + "/resources/packaging/make-deb", {"--out", packages});
        const bool ended = process.waitForFinished(5'400'000);
        QVERIFY2(ended && process.exitCode() == 0, process.readAll());
    }
    const QString tree = folder.filePath("tree");
    QVERIFY(QDir().mkpath(tree));
    process.start("unshare", {"--mount", "--pid", "--fork", "--mount-proc", "--kill-child", "sh",
                              source + "/tests/data/packaging/clean_tree.sh", packages, tree});
    const bool ended = process.waitForFinished(1'800'000);
    const QByteArray said = process.readAll();
    QVERIFY2(ended && process.exitCode() == 0, said.right(1500)); // The end has the reason.
    QVERIFY2(said.contains("== passed"), said);
}

USAR_TEST(tst_DebianPackages)

} // namespace tst_debian_packages

#include "tst_debian_packages.moc"
