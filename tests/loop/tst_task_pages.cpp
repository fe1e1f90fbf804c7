// The commands that the task pages show do what the pages say.
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
    int exit_code = -1;
    QByteArray said;
};

/// Ends at the first command that fails, as a reader would.
Ended run(const QString& script) {
    const QTemporaryDir place;
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QString(USAR_BINARY_DIR "/bin:") + environment.value("PATH"));
    shell.setProcessEnvironment(environment);
    shell.setWorkingDirectory(place.path());
    shell.setProcessChannelMode(QProcess::MergedChannels);
    shell.start("bash", {"-euo", "pipefail", "-c", script});
    if (!shell.waitForFinished(200'000))
        shell.kill();
    return {shell.exitStatus() == QProcess::NormalExit ? shell.exitCode() : -1, shell.readAll()};
}

} // namespace

class tst_TaskPages : public QObject {
    Q_OBJECT
private slots:
    void theCommandsOfEachPageWork_data() {
        QTest::addColumn<QString>("page");
        for (const QString& page : QDir(folder).entryList({"*.md"}, QDir::Files, QDir::Name))
            if (page != "README.md")
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
        QVERIFY(run("usar-mission run no-such-file.json\n").exit_code != 0);
    }
};

USAR_TEST(tst_TaskPages)

} // namespace tst_task_pages

#include "tst_task_pages.moc"
