// The commands that the task pages show do what the pages say.
#include <chrono>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_task_pages {

namespace {

const QString folder = USAR_SOURCE_DIR "/resources/docs/tasks";

/// All ```sh blocks of the page, in their order.
QString scriptOf(const QString& page) {
    static const QRegularExpression block("^```sh\\n(.*?)^```$", QRegularExpression::MultilineOption |
                                                                     QRegularExpression::DotMatchesEverythingOption);
    QFile file(folder + '/' + page);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.readAll());
    QString script;
    for (auto found = block.globalMatch(text); found.hasNext();)
        script += found.next().captured(1);
    return script;
}

struct Ended {
    int exit_code = -1; ///< -1 also if it had to be stopped
    QByteArray said;
};

constexpr std::chrono::seconds longest{200};
constexpr int stopped_by_timeout = 124;

/// Ends at the first command that fails, as a reader would, and with all its children when the time is over: timeout
/// makes a process group of them.
Ended run(const QString& script, std::chrono::seconds most = longest) {
    const QTemporaryDir place;
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QString(USAR_BINARY_DIR "/bin:") + environment.value("PATH"));
    shell.setProcessEnvironment(environment);
    shell.setWorkingDirectory(place.path());
    shell.setProcessChannelMode(QProcess::MergedChannels);
    shell.start("timeout", {"--kill-after=5", QString::number(most.count()), "bash", "-euo", "pipefail", "-c", script});
    const std::chrono::milliseconds until_killed = most + std::chrono::seconds(20);
    if (!shell.waitForFinished(static_cast<int>(until_killed.count()))) {
        shell.kill();
        shell.waitForFinished();
        return {-1, shell.readAll()};
    }
    const bool ended = shell.exitStatus() == QProcess::NormalExit && shell.exitCode() != stopped_by_timeout;
    return {ended ? shell.exitCode() : -1, shell.readAll()};
}

/// Empty if the process is gone, or is dead and only waits for its parent.
QByteArray commandOf(const QByteArray& process_id) {
    QFile file("/proc/" + QString::fromLatin1(process_id) + "/cmdline");
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class tst_TaskPages : public QObject {
    Q_OBJECT
private slots:
    void theCommandsOfEachPageWork_data() {
        QTest::addColumn<QString>("page");
        for (const QString& page : QDir(folder).entryList({"*.md"}, QDir::Files, QDir::Name))
            QTest::newRow(qPrintable(page)) << page;
    }
    void theCommandsOfEachPageWork() {
        QFETCH(const QString, page);
        const QString script = scriptOf(page);
        QVERIFY2(script.contains("usar-mission"), "A task without a command that can be tried");
        const Ended ended = run(script);
        QVERIFY2(ended.exit_code == 0, ended.said);
    }

    void theTestItselfSeesACommandThatFails() {
        QCOMPARE(run("true\nfalse\ntrue\n").exit_code, 1);
        QVERIFY(run("usar-mission run no-such-file.json\n").exit_code > 0);
    }

    void theTestItselfSeesACommandThatHangs() {
        const Ended ended = run("sleep 600 &\necho $!\nwait\n", std::chrono::seconds(3));
        QCOMPARE(ended.exit_code, -1);
        const QByteArray child = ended.said.split('\n').first();
        QVERIFY2(child.toInt() > 0, ended.said);
        QTRY_VERIFY(commandOf(child).isEmpty()); // It went with the shell.
        QVERIFY(!commandOf("self").isEmpty());
    }
};

USAR_TEST(tst_TaskPages)

} // namespace tst_task_pages

#include "tst_task_pages.moc"
