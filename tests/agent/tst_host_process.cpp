#include <csignal>

#include <QDir>
#include <QFile>
#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/process/host_process.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_host_process {

using namespace usar;
using namespace usar::agent;

namespace {

const QString program = QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host");

/// The folder for temporary files that the process was given.
QString folderOf(int process) {
    QFile environment("/proc/" + QString::number(process) + "/environ");
    if (environment.open(QIODevice::ReadOnly))
        for (const QByteArray& variable : environment.readAll().split('\0'))
            if (variable.startsWith("TMPDIR="))
                return QFile::decodeName(variable.mid(7));
    return {};
}

} // namespace

class tst_HostProcess : public QObject {
    Q_OBJECT

private slots:
    void itsFolderGoesWithIt_data() {
        QTest::addColumn<bool>("is_killed");
        QTest::newRow("killed") << true;
        QTest::newRow("left to itself") << false;
    }

    /// A process whose folder went before it would write to the root of the file system.
    void itsFolderGoesWithIt() {
        QFETCH(const bool, is_killed);
        auto host = HostProcess::start(program, "behavior test");
        QVERIFY(host);
        const int process = (*host)->id();
        QTRY_VERIFY(!folderOf(process).isEmpty()); // once the program has replaced the copy of this one
        const QString folder = folderOf(process);
        QVERIFY2(QDir(folder).exists(), qPrintable(folder));

        QVERIFY(test::sendSignal(process, SIGSTOP)); // so that it cannot end
        is_killed ? (*host)->kill() : (*host)->leave();
        host->reset(); // what a failed process's owner does next
        QCOMPARE(QDir(folder).exists(), !is_killed);

        QCOMPARE(test::sendSignal(process, SIGCONT), !is_killed);
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(folder).exists(), 60000); // it may still have to be loaded
    }
};

USAR_TEST(tst_HostProcess)

} // namespace tst_host_process

#include "tst_host_process.moc"
